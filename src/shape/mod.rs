//! Floor 3: one file a shape. Each has the shape as it is described, the shape as the kernels
//! read it (`Prepared…`), and the kernels: where a ray meets it, whether it blocks a ray, and its
//! normal. Knows no scene.

pub mod cylinder;
#[cfg(test)]
mod fixture;
pub mod plane;
pub mod sphere;

use crate::number::Unit;
use crate::number::{Length, divide};
use crate::vector::{Direction, Vector};

/// Names a material of one scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MaterialId(pub(crate) u16);

impl MaterialId {
    /// Its place in the scene's list of materials.
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// Divides vectors of one length by that length: turns the way from a centre into a normal.
#[derive(Clone, Copy, Debug)]
struct Normaliser {
    /// How far a vector of the length is shifted left to have 2²⁹ to 2³⁰.
    lift: u32,
    /// 2⁵⁹ / (length << lift), above 2²⁹, at most 2³⁰.
    inverse: i32,
}

impl Normaliser {
    const fn new(length: Length) -> Self {
        let length = length.to_bits() as u32;
        let lift = length.leading_zeros() - 2;
        let lifted = (length << lift) as i64;
        let quotient = divide(1 << 59, lifted as u32);
        let estimate = (quotient.mantissa >> -quotient.exponent) as i64;
        // One Newton step leaves the last bit.
        let residue = (1_i64 << 59) - lifted * estimate;
        let inverse = estimate + ((residue * estimate + (1 << 58)) >> 59);
        Self {
            lift,
            inverse: if inverse > 1 << 30 {
                1 << 30
            } else {
                inverse as i32
            },
        }
    }

    /// The direction of `vector`, whose length is the one given, but for a few steps.
    const fn direction(&self, vector: Vector) -> Direction {
        // A radius below 2^16 steps: rounding moves the length by more than one Newton step mends.
        if self.lift > 13 {
            let Vector { x, y, z } = vector;
            let lifted = Vector::new(x << self.lift, y << self.lift, z << self.lift);
            return lifted.precise_direction();
        }
        Direction {
            x: self.coordinate(vector.x),
            y: self.coordinate(vector.y),
            z: self.coordinate(vector.z),
        }
        .renormalised()
    }

    const fn coordinate(&self, raw: i32) -> Unit {
        Unit::from_bits((((raw << self.lift) as i64 * self.inverse as i64) >> 29) as i32)
    }
}
