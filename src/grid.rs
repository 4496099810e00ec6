//! Floor 1: the grid a scene is laid on: where its middle is and how fine its steps are.

use crate::number::{Length, Number, fitting, narrowed, narrowed_128};
use crate::ray::ScaledPoint;
use crate::vector::{Direction, Point, Position};

/// The scene's own coordinates: raw steps of 2^-`fraction_bits` scene units from its middle.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    middle: Position,
    /// A step is 2^-(64 - drop) scene units: how many bits of a [`Number`] are dropped.
    drop: u32,
}

impl Grid {
    /// A grid around `middle` on which `radius` (in the bits of a [`Number`], at least 2²⁸ · 2)
    /// is at most 2²⁸ steps.
    pub(crate) const fn new(middle: Position, radius: u128) -> Self {
        let bits = 128 - (radius - 1).leading_zeros();
        Self {
            middle,
            drop: bits - 28,
        }
    }

    /// How many bits of a raw step lie behind the binary point of a scene unit.
    #[cfg(any(test, feature = "host"))]
    pub const fn fraction_bits(&self) -> i32 {
        use crate::number::signed;
        64 - signed(self.drop)
    }

    /// The middle of the scene.
    #[cfg(any(test, feature = "host"))]
    pub const fn middle(&self) -> Position {
        self.middle
    }

    /// How far a position lies from the middle along a direction, in steps with 30 more fraction
    /// bits, rounded down; coordinates below 2^(31 + 64) times Q30, three of them, stay below 2^127.
    ///
    /// Along an axis it is rounded to whole steps as [`Grid::place`] rounds: what has the same
    /// coordinate in a description lies in the plane, and not beside it.
    pub(crate) const fn height_of(&self, position: Position, normal: Direction) -> i128 {
        let [x, y, z] = position.minus(self.middle).0;
        let [nx, ny, nz] = normal.components();
        let (nx, ny, nz) = (
            nx.to_bits() as i128,
            ny.to_bits() as i128,
            nz.to_bits() as i128,
        );
        if (nx | ny) == 0 || (ny | nz) == 0 || (nz | nx) == 0 {
            let half = 1 << (self.drop - 1);
            return ((x.to_bits() + half) >> self.drop) * nx
                + ((y.to_bits() + half) >> self.drop) * ny
                + ((z.to_bits() + half) >> self.drop) * nz;
        }
        (x.to_bits() * nx + y.to_bits() * ny + z.to_bits() * nz) >> self.drop
    }

    /// A length, rounded to the nearest step; what does not fit 2³⁰ steps becomes 2³⁰.
    pub(crate) const fn length(&self, number: Number) -> Length {
        let steps = (number.to_bits() + (1 << (self.drop - 1))) >> self.drop;
        Length::from_bits(if steps > 1 << 30 {
            1 << 30
        } else {
            narrowed(narrowed_128(steps))
        })
    }

    /// A position, rounded to the nearest step, or coarser where it is far.
    pub(crate) const fn place(&self, position: Position) -> ScaledPoint {
        let [x, y, z] = position.minus(self.middle).0;
        let mut drop = self.drop;
        loop {
            let point = Point::new(rounded(x, drop), rounded(y, drop), rounded(z, drop));
            if let Some(ScaledPoint { point, .. }) = ScaledPoint::near(point) {
                let scale = drop - self.drop;
                return ScaledPoint { point, scale };
            }
            drop += 1;
        }
    }
}

/// A number without so many of its last bits, rounded to the nearest; the largest where that does not
/// fit.
#[inline(never)]
const fn rounded(number: Number, drop: u32) -> i32 {
    let twice = number.to_bits() >> (drop - 1);
    match fitting(twice) {
        Some(twice) => (twice >> 1) + (twice & 1),
        None => i32::MAX,
    }
}

#[cfg(test)]
mod tests;
