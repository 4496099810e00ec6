//! A set of bounded shapes in 64 bits: the candidates that a ray asks. The plain path asks the set of all;
//! `accel` makes the others.
//!
//! Where a scene has more shapes than bits, a bit stands for a run of them. A set may hold more shapes
//! than a ray can hit, never fewer: it changes the work, not the picture.

use super::access::KINDS;
use crate::number::{low_word, to_u32};

/// A set of runs of shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ShapeSet(u64);

impl ShapeSet {
    /// No shape.
    pub(crate) const NONE: Self = Self(0);

    /// Every shape.
    pub(crate) const ALL: &'static Self = &Self(u64::MAX);

    /// The run with this bit.
    pub(crate) const fn of(bit: usize) -> Self {
        Self(1 << (bit % 64))
    }

    /// The runs of both sets.
    pub(crate) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Tests whether both sets have a run in common.
    pub(crate) const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// How many runs are in only one of two sets.
    pub(crate) const fn difference(self, other: Self) -> u32 {
        (self.0 ^ other.0).count_ones()
    }

    /// Whether `ask` says yes to a shape of one kind in the set; in rising order. `lengths` are the numbers
    /// of shapes of all kinds, `shapes` those of this one. Where nothing `is_chosen`, the set is that of
    /// all.
    #[inline(always)]
    pub(crate) fn any<'a, T>(
        &self,
        is_chosen: bool,
        (kind, lengths): (usize, [usize; KINDS]),
        shapes: &'a [T],
        mut ask: impl FnMut(usize, &'a T) -> bool,
    ) -> bool {
        if !is_chosen {
            let mut shapes = shapes.iter().enumerate();
            return shapes.any(|(index, shape)| ask(index, shape));
        }
        SetLayout::new(lengths).any(*self, kind, |index| {
            shapes.get(index).is_some_and(|shape| ask(index, shape))
        })
    }
}

/// Which bits the shapes of a scene have: kind after kind from the lowest bit on, and the same number of
/// shapes to a bit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SetLayout {
    run: usize,
    /// The first bit of each kind, and the one after the last.
    starts: [usize; KINDS + 1],
}

impl SetLayout {
    /// Of a scene with so many shapes of each kind.
    #[inline(always)]
    pub(crate) const fn new(lengths: [usize; KINDS]) -> Self {
        let (mut total, mut kind) = (0, 0);
        while kind < KINDS {
            total += lengths[kind];
            kind += 1;
        }
        // Each kind may end with a run that is not full.
        let run = match total <= 64 {
            true => 1,
            false => total.div_ceil(65 - KINDS),
        };
        let mut starts = [0; KINDS + 1];
        kind = 0;
        while kind < KINDS {
            starts[kind + 1] = starts[kind] + lengths[kind].div_ceil(run);
            kind += 1;
        }
        Self { run, starts }
    }

    /// The bit of a shape of a kind.
    pub(crate) const fn bit(self, kind: usize, index: usize) -> usize {
        self.starts[kind] + index / self.run
    }

    /// Whether a shape of a kind in a set is what is looked for; a word at a time. The last run of a kind
    /// may name shapes that there are not.
    #[inline(always)]
    fn any(self, set: ShapeSet, kind: usize, mut is_it: impl FnMut(usize) -> bool) -> bool {
        let (start, end) = (self.starts[kind], self.starts[kind + 1]);
        if start == end {
            return false;
        }
        let is_one_word = self.starts[KINDS] <= 32;
        let all = match is_one_word {
            true => low_word(set.0).into(),
            false => set.0,
        };
        let mut bits = all.checked_shr(to_u32(start)).unwrap_or(0);
        // Bits after the last shape name none; in one word it takes less time to clear them than to ask.
        if end < self.starts[KINDS] || is_one_word {
            let low = 1_u64.checked_shl(to_u32(end - start));
            bits &= low.map_or(u64::MAX, |end| end - 1);
        }
        for (word, first) in [(low_word(bits), 0), (low_word(bits >> 32), 32)] {
            let mut rest = word;
            while rest != 0 {
                let run = first + rest.trailing_zeros() as usize;
                rest &= rest - 1;
                let mut shapes = run * self.run..(run + 1) * self.run;
                if shapes.any(&mut is_it) {
                    return true;
                }
            }
        }
        false
    }
}
