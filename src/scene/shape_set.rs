//! A set of bounded shapes in 64 bits: the candidates of a ray. The plain path uses the set of all
//! shapes; `accel` makes the others.
//!
//! If a scene has more shapes than bits, a bit stands for a run of consecutive shapes. A set may hold
//! more shapes than a ray can hit, never fewer. So a set changes how long a ray takes, not what it shows.

use super::access::{KINDS, Parts, ShapeId};
use crate::number::{low_word, to_u32};

/// Largest number of bounded shapes of which each has a bit of its own.
pub(crate) const SETS: usize = 64;

/// A set of bounded shapes, one bit for each run of shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ShapeSet(u64);

impl ShapeSet {
    /// The set without any shape.
    pub(crate) const NONE: Self = Self(0);

    /// The set of all shapes.
    pub(crate) const ALL: &'static Self = &Self(u64::MAX);

    /// Returns the union of two sets.
    pub(crate) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Returns the runs that are in both sets.
    pub(crate) const fn common(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// Tests whether both sets have a run in common.
    pub(crate) const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }

    /// Returns how many runs are in only one of two sets.
    pub(crate) const fn difference(self, other: Self) -> u32 {
        (self.0 ^ other.0).count_ones()
    }

    /// Calls `call` for each shape of one kind in the set, in ascending order, as [`ShapeSet::any`] does.
    /// Takes less flash and more time.
    #[inline(always)]
    pub(crate) fn each<'a, T>(
        &self,
        kind: ShapeKind,
        shapes: &'a [T],
        mut call: impl FnMut(usize, &'a T),
    ) {
        let (mut rest, run_length) = (self.bits(kind), kind.layout.run);
        while rest != 0 {
            let run = rest.trailing_zeros() as usize * run_length;
            rest &= rest - 1;
            for index in run..run + run_length {
                if let Some(shape) = shapes.get(index) {
                    call(index, shape);
                }
            }
        }
    }

    /// Returns the bits of the shapes of one kind, from the lowest bit on.
    #[inline(always)]
    fn bits(&self, ShapeKind { place, layout, .. }: ShapeKind) -> u64 {
        let (start, end) = (layout.starts[place], layout.starts[place + 1]);
        let all = if layout.starts[KINDS] <= 32 { low_word(self.0).into() } else { self.0 };
        let after = 1_u64.checked_shl(to_u32(end - start));
        all.checked_shr(to_u32(start)).unwrap_or(0) & after.map_or(u64::MAX, |after| after - 1)
    }

    /// Calls `ask` for each shape of one kind in the set, in ascending order, until it returns `true`.
    /// Returns whether it did. Goes through the bits a word at a time.
    ///
    /// `shapes` are the shapes of the kind. If `is_chosen` is `false`, all shapes are tested and the set is ignored.
    #[inline(always)]
    pub(crate) fn any<'a, T>(
        &self,
        is_chosen: bool,
        kind: ShapeKind,
        shapes: &'a [T],
        mut ask: impl FnMut(usize, &'a T) -> bool,
    ) -> bool {
        if !is_chosen {
            let mut index = 0;
            while let Some(shape) = shapes.get(index) {
                if ask(index, shape) {
                    return true;
                }
                index += 1;
            }
            return false;
        }
        let (bits, run_length) = (self.bits(kind), kind.layout.run);
        for (mut rest, first) in [(low_word(bits), 0), (low_word(bits >> 32), 32)] {
            while rest != 0 {
                let run = first + rest.trailing_zeros() as usize;
                rest &= rest - 1;
                // The last run of a kind may have indices past the last shape.
                for index in run * run_length..(run + 1) * run_length {
                    if let Some(shape) = shapes.get(index) {
                        if ask(index, shape) {
                            return true;
                        }
                    }
                }
            }
        }
        false
    }
}

/// A kind of bounded shapes: which numbers its shapes have among all of a scene, and which bits in a set.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ShapeKind {
    /// Its place in the list of kinds.
    place: usize,
    /// Number of its first shape.
    first: usize,
    /// The bits of all kinds.
    layout: SetLayout,
}

impl ShapeKind {
    /// Returns the number that a shape has among all. `index` counts the shapes of this kind.
    #[inline(always)]
    pub(crate) const fn id(self, index: usize) -> ShapeId {
        ShapeId::at(self.first + index)
    }

    /// Returns the set of the run that holds a shape. `index` counts the shapes of this kind.
    #[inline(always)]
    pub(crate) const fn set_of(self, index: usize) -> ShapeSet {
        self.layout.set_in(self.place, index)
    }
}

macro_rules! shape_kinds {
    ($header:tt $({ $list:ident $($more:tt)* })*) => {
        impl Parts<'_> {
            /// Returns the kinds of bounded shapes, in the order in which shapes are numbered.
            #[inline(always)]
            pub(crate) const fn kinds(&self) -> [ShapeKind; KINDS] {
                let layout = SetLayout::new(self.lengths());
                let (place, first) = (0, 0);
                $(
                    let $list = ShapeKind { place, first, layout };
                    let (place, first) = (place + 1, first + self.$list.len());
                )*
                let _ = (place, first);
                [$($list),*]
            }
        }
    };
}
kinds!(shape_kinds);

/// Assigns bits of a [`ShapeSet`] to the shapes of a scene: kind after kind from the lowest bit on.
/// Each bit stands for the same number of shapes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SetLayout {
    /// Number of shapes of each kind.
    lengths: [usize; KINDS],
    /// Number of consecutive shapes that one bit stands for.
    run: usize,
    /// First bit of each kind, then the bit after the last.
    starts: [usize; KINDS + 1],
}

impl SetLayout {
    /// Returns the layout of a scene with these numbers of shapes of each kind.
    #[inline(always)]
    pub(crate) const fn new(lengths: [usize; KINDS]) -> Self {
        let (mut total, mut kind) = (0, 0);
        while kind < KINDS {
            total += lengths[kind];
            kind += 1;
        }
        // The last run of each kind may have fewer shapes.
        let run = if total <= SETS { 1 } else { total.div_ceil(65 - KINDS) };
        let mut starts = [0; KINDS + 1];
        kind = 0;
        while kind < KINDS {
            starts[kind + 1] = starts[kind] + lengths[kind].div_ceil(run);
            kind += 1;
        }
        Self {
            lengths,
            run,
            starts,
        }
    }

    /// Returns the set of the run that holds a shape. `index` counts the shapes of its kind.
    const fn set_in(self, kind: usize, index: usize) -> ShapeSet {
        ShapeSet(1 << ((self.starts[kind] + index / self.run) % 64))
    }

    /// Returns the set of the run that holds the bounded shape with this number.
    pub(crate) const fn set_of(self, number: usize) -> ShapeSet {
        let (mut kind, mut index) = (0, number);
        while kind + 1 < KINDS && index >= self.lengths[kind] {
            index -= self.lengths[kind];
            kind += 1;
        }
        self.set_in(kind, index)
    }
}
