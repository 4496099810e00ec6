//! The parabola through three sums, in steps of one column.

use core::hint::black_box;

use super::{Bend, Sum};
use crate::number::{Unit, scaled_by_unit, signed, to_u32};

/// Largest number of columns of a parabola.
pub const LONGEST: usize = 64;

/// Reciprocals of 1 to [`LONGEST`], in Q2.30, rounded to nearest.
static RECIPROCALS: [i32; LONGEST] = {
    let mut reciprocals = [0; LONGEST];
    let mut place = 0;
    while place < LONGEST {
        let number = signed(to_u32(place)) + 1;
        reciprocals[place] = ((1 << 30) + number / 2) / number;
        place += 1;
    }
    reciprocals
};

/// Returns the reciprocal of a number of columns, 1 to [`LONGEST`].
#[inline(always)]
fn reciprocal(number: u32) -> Unit {
    Unit::from_bits(RECIPROCALS[(number as usize - 1) % LONGEST])
}

/// Parabola through the sums of three columns. Columns are counted from the first of them. Holds the sum of
/// column 0, and the first and the second difference there, for a distance of one column.
#[derive(Clone, Copy, Debug)]
pub struct Parabola([Sum; 3]);

impl Parabola {
    /// Returns the parabola through the sums of columns 0, `half` and `length`.
    #[inline(never)]
    pub fn through([start, middle, end]: [Sum; 3], half: u32, length: u32) -> Self {
        let [near, far, whole] = [half, length - half, length].map(reciprocal);
        let before = middle.each(start, |middle, start| scaled_by_unit(middle - start, near));
        let after = end.each(middle, |end, middle| scaled_by_unit(end - middle, far));
        let second = after.each(before, |after, before| {
            scaled_by_unit(2 * (after - before), whole)
        });
        let steps = signed(half) - 1;
        let first = before.each(second, |slope, second| slope - second * steps / 2);
        Self([start, first, second])
    }

    /// Returns the second difference of the sums of three columns, each `half` columns after the one before.
    pub fn bend(&self, half: u32) -> Bend {
        let square = signed(half * half);
        let [_, _, second] = self.0;
        second.each(second, |second, _| second * square)
    }

    /// Returns the parabola counted from a later column on.
    #[inline(always)]
    pub fn after(self, columns: u32) -> Self {
        let [mut start, mut first, second] = self.0;
        for _ in 0..columns {
            start = start.each(first, |sum, first| sum + first);
            first = first.each(second, |first, second| first + second);
        }
        Self([start, first, second])
    }

    /// Returns the parabola with the same sum in each column.
    #[inline(always)]
    pub fn constant(sum: Sum) -> Self {
        Self([sum, Sum::ZERO, Sum::ZERO])
    }

    /// Returns the sum of all columns if it is the same.
    #[inline(always)]
    pub fn as_constant(&self) -> Option<Sum> {
        let [start, first, second] = self.0;
        let [red, green, blue] = first.each(second, |first, second| first | second).0;
        (red | green | blue == 0).then_some(start)
    }

    /// Fills places with the sums of columns 0, 1, 2, ..., each converted by `shown`.
    #[inline(always)]
    pub fn fill<'a, C: 'a>(
        self,
        places: impl Iterator<Item = &'a mut C>,
        shown: impl Fn(Sum) -> C,
    ) {
        // The step comes before the conversion, because both then fit into the registers of a Cortex-M.
        let [start, first, second] = self.0;
        let mut first = first.less(second);
        let mut sum = start.less(first);
        for place in places {
            sum = sum.each(first, |sum, first| sum + first);
            // Keeps the compiler from unrolling the loop: there are no registers for that.
            black_box(());
            first = first.each(second, |first, second| first + second);
            *place = shown(sum);
        }
    }
}
