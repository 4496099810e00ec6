//! Cells of directions, and caps of directions with bounds on the cells that they reach.
//!
//! Each coordinate of a direction is divided into `SIDE` equal parts of its range. So a direction
//! belongs to one of SIDE x SIDE x SIDE cells, and no coordinates need to be compared. Cells that the
//! unit sphere does not cross stay empty.
//!
//! A ball is seen as a cap: all directions within an angle φ of a direction c. A coordinate of a
//! direction in the cap lies between cos(θ + φ) and cos(θ - φ), where θ is the angle from c to the
//! axis. A cell is also left out if all of its points have a smaller cosine to c than cos φ. Bounds are
//! widened by 2⁻¹⁶, which is more than the rounding error.

use crate::number::{Unit, divide, narrowed, signed, square_root, to_u32, unsigned, unsigned_wide};
use crate::vector::{Direction, Vector};

/// Number of cells along each axis, a power of two.
pub(super) const SIDE: usize = 8;

/// Margin that widens the bounds of a coordinate: 2⁻¹⁶ in Q2.30.
const MARGIN: i32 = 1 << 14;

/// Returns the index of the cell that a direction lies in.
#[inline(always)]
pub(super) const fn cell_of(direction: Direction) -> usize {
    let Vector { x, y, z } = direction.raw();
    cell(cell_number(x), cell_number(y), cell_number(z))
}

/// Number of low bits of a Q2.30 coordinate that do not belong to its cell's number, which is -SIDE / 2 to
/// SIDE / 2 - 1.
const CELL_BITS: u32 = 31 - SIDE.trailing_zeros();

/// Returns the number of the cell that a Q2.30 coordinate lies in: -SIDE / 2 to SIDE / 2 - 1.
#[inline(always)]
const fn cell_number(coordinate: i32) -> i32 {
    // A coordinate may exceed ±1 by a few last places, where there is no cell. The shift moves it
    // inside; it moves a coordinate by less than the margin.
    (coordinate - (coordinate >> 25)) >> CELL_BITS
}

/// Returns the numbers of the first and the last cell along an axis that hold a coordinate between two, or
/// within `more` of them.
pub(super) fn cells_between([low, high]: [i32; 2], more: i32) -> (i32, i32) {
    const ONE: i32 = 1 << 30;
    let more = more + MARGIN;
    (
        cell_number(low.saturating_sub(more).max(-ONE)),
        cell_number(high.saturating_add(more).min(ONE)),
    )
}

/// Returns the index of a cell from its numbers along the three axes, each -SIDE / 2 to SIDE / 2 - 1.
#[inline(always)]
pub(super) const fn cell(x: i32, y: i32, z: i32) -> usize {
    let sides = signed(to_u32(SIDE));
    let middle = (sides / 2) * (sides * sides + sides + 1);
    unsigned((x * sides + y) * sides + z + middle) as usize
}

/// A cap of directions: all directions within an angle φ of `direction`.
pub(super) struct Cap {
    direction: Direction,
    /// Sine of the cap's angle φ, Q2.30.
    sine: Unit,
    /// Cosine of the cap's angle φ, Q2.30.
    cosine: Unit,
}

impl Cap {
    /// Returns the directions that hit a ball of this radius at this distance.
    pub(super) const fn new(direction: Direction, radius: i32, distance: i32) -> Self {
        let quotient = divide((unsigned(radius) as u64) << 30, unsigned(distance));
        let sine = (quotient.mantissa >> -quotient.exponent) as i64 + 64;
        let sine = if sine > 1 << 30 { 1 << 30 } else { sine };
        let cosine = square_root(unsigned_wide((1 << 60) - sine * sine));
        Self {
            direction,
            sine: Unit::from_bits(narrowed(sine)),
            cosine: Unit::from_bits(cosine),
        }
    }

    /// Tests whether a cell has a point whose cosine to the middle of the cap is at least cos φ.
    pub(super) const fn reaches(&self, cell: [i32; 3]) -> bool {
        let coordinates = self.direction.components();
        let mut largest = 0_i64;
        let mut axis = 0;
        while axis < 3 {
            // The cell, widened by the margin on both sides.
            let low = ((cell[axis] as i64) << CELL_BITS) - MARGIN as i64;
            let high = ((cell[axis] as i64 + 1) << CELL_BITS) + MARGIN as i64;
            let coordinate = coordinates[axis].to_bits() as i64;
            largest += coordinate * if coordinate > 0 { high } else { low };
            axis += 1;
        }
        largest >> 30 >= (self.cosine.to_bits() - MARGIN) as i64
    }

    /// Returns the least and the largest value of a coordinate in the cap.
    pub(super) const fn range(&self, axis: usize) -> (i32, i32) {
        self.bounds(self.direction.components()[axis].to_bits())
    }

    /// Returns the numbers of the first and the last cell that the cap reaches along an axis.
    pub(super) const fn cells(&self, axis: usize) -> (i32, i32) {
        let (low, high) = self.range(axis);
        (cell_number(low), cell_number(high))
    }

    /// Returns the least and the largest value of a coordinate in the cap. `middle` is its value in the
    /// middle.
    const fn bounds(&self, middle: i32) -> (i32, i32) {
        let middle = if middle > 1 << 30 {
            1 << 30
        } else if middle < -(1 << 30) {
            -(1 << 30)
        } else {
            middle
        };
        let across = square_root(unsigned_wide((1 << 60) - middle as i64 * middle as i64)) as i64;
        let along = (middle as i64 * self.cosine.to_bits() as i64) >> 30;
        let spread = (across * self.sine.to_bits() as i64) >> 30;
        // If the cap holds the axis itself, the bound is the end of the axis.
        let cosine = self.cosine.to_bits();
        let low = if -middle >= cosine - MARGIN {
            -(1 << 30)
        } else {
            let low = narrowed(along - spread) - MARGIN;
            if low < -(1 << 30) { -(1 << 30) } else { low }
        };
        let high = if middle >= cosine - MARGIN {
            1 << 30
        } else {
            let high = narrowed(along + spread) + MARGIN;
            if high > 1 << 30 { 1 << 30 } else { high }
        };
        (low, high)
    }
}
