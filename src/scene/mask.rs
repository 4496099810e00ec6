//! Sets of spheres and cylinders: which of them a ray need ask.
//!
//! A set is a mask of 64 bits. Where a scene has more shapes, a bit stands for a run of them. Every
//! set that is made here or in [`super::cells`], [`super::ahead`] and [`super::row`] holds all shapes
//! that a ray can meet, and may hold more: it changes the work, never the picture.

use crate::number::{low_word, to_u32};

/// A set of runs of shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mask(u64);

impl Mask {
    /// No shape.
    pub(crate) const NONE: Self = Self(0);

    /// Every shape.
    pub(crate) const ALL: Self = Self(u64::MAX);

    /// One run.
    pub(crate) const fn of(bit: usize) -> Self {
        Self(1 << (bit % 64))
    }

    pub(crate) const fn with(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// The first sixteen bits.
    pub(crate) const fn low(self) -> u16 {
        (self.0 & 0xffff) as u16
    }

    /// How many runs are in only one of two sets.
    pub(crate) const fn difference(self, other: Self) -> u32 {
        (self.0 ^ other.0).count_ones()
    }
}

/// How the shapes of a scene are spread over the bits of a mask: spheres from the lowest bit on,
/// cylinders after them, and the same number of shapes to a bit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Runs {
    length: usize,
    sphere_bits: usize,
}

impl Runs {
    #[inline(always)]
    pub(crate) const fn new(spheres: usize, cylinders: usize) -> Self {
        let total = spheres + cylinders;
        // Spheres and cylinders may both end with a run that is not full, hence 63.
        let length = if total <= 64 { 1 } else { total.div_ceil(63) };
        Self {
            length,
            sphere_bits: spheres.div_ceil(length),
        }
    }

    /// The bit of the sphere with this number.
    pub(crate) const fn sphere_bit(self, index: usize) -> usize {
        index / self.length
    }

    /// The bit of the cylinder with this number.
    pub(crate) const fn cylinder_bit(self, index: usize) -> usize {
        self.sphere_bits + index / self.length
    }

    /// Whether any sphere of a set is what is looked for, by its number.
    #[inline(always)]
    pub(crate) fn any_sphere(self, mask: Mask, is_it: impl FnMut(usize) -> bool) -> bool {
        let low = 1_u64
            .checked_shl(to_u32(self.sphere_bits))
            .map_or(u64::MAX, |end| end - 1);
        self.any(mask.0 & low, is_it)
    }

    /// Whether any cylinder of a set is what is looked for, by its number.
    #[inline(always)]
    pub(crate) fn any_cylinder(self, mask: Mask, is_it: impl FnMut(usize) -> bool) -> bool {
        let high = mask.0.checked_shr(to_u32(self.sphere_bits)).unwrap_or(0);
        self.any(high, is_it)
    }

    /// A word at a time; the last run may name shapes that there are not.
    #[inline(always)]
    fn any(self, bits: u64, mut is_it: impl FnMut(usize) -> bool) -> bool {
        for (word, first) in [(low_word(bits), 0), ((bits >> 32) as u32, 32)] {
            let mut rest = word;
            while rest != 0 {
                let run = first + rest.trailing_zeros() as usize;
                rest &= rest - 1;
                let mut shapes = run * self.length..(run + 1) * self.length;
                if shapes.any(&mut is_it) {
                    return true;
                }
            }
        }
        false
    }
}
