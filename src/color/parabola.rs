//! The parabola through three sums, in steps of one column.

use super::{Bend, Sum};
use crate::number::{Unit, scaled_by_unit, signed, to_u32};

/// Largest number of columns of a parabola.
pub const LONGEST: usize = 32;

/// Quotients 2³⁰ / n for n from 1 to [`LONGEST`], rounded to nearest.
static PARTS: [i32; LONGEST] = {
    let mut parts = [0; LONGEST];
    let mut place = 0;
    while place < LONGEST {
        let number = signed(to_u32(place)) + 1;
        parts[place] = ((1 << 30) + number / 2) / number;
        place += 1;
    }
    parts
};

/// Returns a number that divides another by `number`, 1 to [`LONGEST`], if they are multiplied as units.
#[inline(always)]
fn part(number: u32) -> Unit {
    Unit::from_bits(PARTS[(number as usize - 1) % LONGEST])
}

/// Parabola through three sums, at 0, at a column between, and at the last.
#[derive(Clone, Copy, Debug)]
pub struct Parabola {
    start: Sum,
    /// Its first difference at the start, and its second one, for a distance of 1.
    first: Sum,
    second: Sum,
}

impl Parabola {
    /// Returns the parabola through three sums at 0, `half` and `length`.
    pub fn through([start, middle, end]: [Sum; 3], half: u32, length: u32) -> Self {
        let [near, far, whole] = [half, length - half, length].map(part);
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

    /// Returns the second difference of three sums at a distance of `half`.
    pub fn bend(&self, half: u32) -> Bend {
        let square = signed(half * half);
        self.second.each(self.second, |second, _| second * square)
    }

    /// Fills places with the sums at 0, 1, 2, ....
    pub fn fill<'a>(self, places: impl Iterator<Item = &'a mut Sum>) {
        let (mut sum, mut first) = (self.start, self.first);
        for place in places {
            *place = sum;
            sum = sum.each(first, |sum, first| sum + first);
            first = first.each(self.second, |first, second| first + second);
        }
    }
}
