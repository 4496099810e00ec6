//! Floor 1: the grid of a scene. It converts positions in scene units to raw steps around the scene's
//! middle.

use crate::number::{Length, Number, fitting, narrowed, narrowed_128};
use crate::ray::ScaledPoint;
use crate::vector::{Direction, Point, Position};

/// Coordinate system of a scene: raw steps of 2^-`fraction_bits` scene units, counted from its middle.
#[derive(Clone, Copy, Debug)]
pub struct Grid {
    middle: Position,
    /// Number of low bits of a [`Number`] that a conversion drops. A step is 2^-(64 - `drop`) scene
    /// units.
    drop: u32,
}

impl Grid {
    /// Creates the finest grid around `middle` on which `radius` is at most 2²⁸ steps. `radius` is in
    /// the raw bits of a [`Number`] and at least 2²⁸ · 2.
    pub(crate) const fn new(middle: Position, radius: u128) -> Self {
        let bits = 128 - (radius - 1).leading_zeros();
        Self {
            middle,
            drop: bits - 28,
        }
    }

    /// Returns the number of fraction bits: a step is 2^-`fraction_bits` scene units.
    #[cfg(any(test, feature = "files"))]
    pub const fn fraction_bits(&self) -> i32 {
        use crate::number::signed;
        64 - signed(self.drop)
    }

    /// Returns the number of low bits of a [`Number`] that a conversion to steps drops: a step is 2^`drop` of its
    /// last places.
    pub(crate) const fn drop(&self) -> u32 {
        self.drop
    }

    /// Returns the middle of the scene, in scene units.
    pub const fn middle(&self) -> Position {
        self.middle
    }

    /// Returns the signed distance of `position` from the middle along `normal`, in steps with 30
    /// fraction bits, rounded down. Three coordinates below 2^(31 + 64), multiplied by Q30, have a sum
    /// below 2^127.
    ///
    /// If `normal` is a coordinate axis, the distance is rounded to whole steps as in [`Grid::place`].
    /// So a position with the same coordinate as a plane lies exactly in the plane.
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

    /// Converts a length to steps, rounded to nearest and limited to 2³⁰.
    #[inline(never)]
    pub(crate) const fn length(&self, number: Number) -> Length {
        let steps = (number.to_bits() + (1 << (self.drop - 1))) >> self.drop;
        Length::from_bits(if steps > 1 << 30 { 1 << 30 } else { narrowed(narrowed_128(steps)) })
    }

    /// Converts a position to steps from the middle of the scene, rounded to the nearest step. A far
    /// position gets coarser steps.
    #[inline(never)]
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

/// Drops the last `drop` bits of a number and rounds to nearest. Returns `i32::MAX` if the result does
/// not fit.
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
