//! The parabola through three sums, in steps of one column.

use super::{Bend, Sum};
use crate::number::{Unit, scaled_by_unit, signed, to_u32};

/// Largest number of columns of a parabola.
pub const LONGEST: usize = 32;

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

/// Parabola through the sums of three columns. Columns are counted from the first of them.
#[derive(Clone, Copy, Debug)]
pub struct Parabola {
    start: Sum,
    /// First and second difference at the start, for a distance of one column.
    first: Sum,
    second: Sum,
}

impl Parabola {
    /// Returns the parabola through the sums of columns 0, `half` and `length`.
    pub fn through([start, middle, end]: [Sum; 3], half: u32, length: u32) -> Self {
        let [near, far, whole] = [half, length - half, length].map(reciprocal);
        let before = middle.each(start, |middle, start| scaled_by_unit(middle - start, near));
        let after = end.each(middle, |end, middle| scaled_by_unit(end - middle, far));
        let second = after.each(before, |after, before| {
            scaled_by_unit(2 * (after - before), whole)
        });
        let steps = signed(half) - 1;
        let first = before.each(second, |slope, second| slope - second * steps / 2);
        Self {
            start,
            first,
            second,
        }
    }

    /// Returns the second difference of the sums of three columns, each `half` columns after the one before.
    pub fn bend(&self, half: u32) -> Bend {
        let square = signed(half * half);
        self.second.each(self.second, |second, _| second * square)
    }

    /// Fills places with the sums of columns 0, 1, 2, ....
    pub fn fill<'a>(self, places: impl Iterator<Item = &'a mut Sum>) {
        let (mut sum, mut first) = (self.start, self.first);
        for place in places {
            *place = sum;
            sum = sum.each(first, |sum, first| sum + first);
            first = first.each(self.second, |first, second| first + second);
        }
    }
}
