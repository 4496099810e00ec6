//! Cells of directions, and caps of directions with bounds on the cells that they reach.
//!
//! Each coordinate of a direction is cut into equal parts of its range, so that a direction belongs to
//! one of SIDE x SIDE x SIDE cells without a comparison of coordinates; those that the sphere of
//! directions does not pass through stay empty. A ball is seen as a cap of angle φ around a direction
//! c, the coordinates of a cap are bounded by cos(θ ± φ) where θ is the angle from c to the axis, and a
//! cell is left out as well where all of its points have a smaller cosine to c than cos φ. Bounds are
//! widened by 2⁻¹⁶, more than rounding can be wrong.

use crate::number::{Unit, divide, narrowed, signed, square_root, to_u32, unsigned, unsigned_wide};
use crate::vector::{Direction, Vector};

/// What a bound of a coordinate is widened by: 2⁻¹⁶.
const MARGIN: i32 = 1 << 14;

/// The cell that a direction lies in, of `SIDE` along each axis: a power of two.
#[inline(always)]
pub(super) const fn cell_of<const SIDE: usize>(direction: Direction) -> usize {
    let Vector { x, y, z } = direction.raw();
    cell::<SIDE>(
        cell_number::<SIDE>(x),
        cell_number::<SIDE>(y),
        cell_number::<SIDE>(z),
    )
}

/// The bits of a coordinate of Q2.30 below the number of its cell, which is -SIDE / 2 to SIDE / 2 - 1.
const fn cell_bits<const SIDE: usize>() -> u32 {
    31 - SIDE.trailing_zeros()
}

/// The number of the cell that a coordinate lies in.
#[inline(always)]
const fn cell_number<const SIDE: usize>(coordinate: i32) -> i32 {
    // One beyond ±1 by a few last places, for which there is no cell, is drawn in; less than the margin.
    (coordinate - (coordinate >> 25)) >> cell_bits::<SIDE>()
}

#[inline(always)]
pub(super) const fn cell<const SIDE: usize>(x: i32, y: i32, z: i32) -> usize {
    let sides = signed(to_u32(SIDE));
    let middle = (sides / 2) * (sides * sides + sides + 1);
    unsigned((x * sides + y) * sides + z + middle) as usize
}

/// A cap of directions: everything within an angle φ of one direction.
pub(super) struct Cap {
    direction: Direction,
    sine: Unit,
    cosine: Unit,
}

impl Cap {
    /// Of a ball of this radius at this distance.
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

    /// Whether a point of a cell has as large a cosine to the middle as the cap.
    pub(super) const fn reaches<const SIDE: usize>(&self, cell: [i32; 3]) -> bool {
        let coordinates = self.direction.components();
        let mut largest = 0_i64;
        let mut axis = 0;
        while axis < 3 {
            // From 2⁻¹⁶ below the cell to as much above it.
            let low = ((cell[axis] as i64) << cell_bits::<SIDE>()) - MARGIN as i64;
            let high = ((cell[axis] as i64 + 1) << cell_bits::<SIDE>()) + MARGIN as i64;
            let coordinate = coordinates[axis].to_bits() as i64;
            largest += coordinate * if coordinate > 0 { high } else { low };
            axis += 1;
        }
        largest >> 30 >= (self.cosine.to_bits() - MARGIN) as i64
    }

    /// The first and the last cell along an axis.
    pub(super) const fn cells<const SIDE: usize>(&self, axis: usize) -> (i32, i32) {
        let (low, high) = self.bounds(self.direction.components()[axis].to_bits());
        (cell_number::<SIDE>(low), cell_number::<SIDE>(high))
    }

    /// The least and the largest value of a coordinate whose value in the middle is `middle`.
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
        // Where the cap holds the axis itself, its end is the axis.
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
