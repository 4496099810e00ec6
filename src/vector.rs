//! Floor 1: points, differences of points, and directions of unit length.
//!
//! A [`Point`] and a [`Vector`] hold raw scene steps ([`Length`]); a [`Direction`] holds
//! Q2.30 and has length one by construction. Knows no ray and no scene.

mod direction;
mod position;

pub use direction::Direction;
pub use position::Position;

use crate::number::{
    Length, Unit, high, high_unsigned, narrowed, reciprocal_root, rounded, signed, unit_shift,
    unsigned, unsigned_wide, wide,
};

/// A place in the scene, in raw scene steps from its middle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    /// Raw steps.
    pub x: i32,
    /// Raw steps.
    pub y: i32,
    /// Raw steps.
    pub z: i32,
}

impl Point {
    /// The middle of the scene.
    pub const ORIGIN: Self = Self { x: 0, y: 0, z: 0 };

    /// From raw steps.
    pub const fn new(x: i32, y: i32, z: i32) -> Self {
        Self { x, y, z }
    }

    /// The way from `self` to `other`; every coordinate of both is within ±2³⁰.
    pub const fn to(self, other: Self) -> Vector {
        Vector::new(other.x - self.x, other.y - self.y, other.z - self.z)
    }

    /// As the vector from the middle of the scene.
    pub const fn to_vector(self) -> Vector {
        Vector::new(self.x, self.y, self.z)
    }

    /// The point `distance` along `direction`, an even number of steps away a coordinate.
    ///
    /// With coordinates within ±3 · 2²⁷ and a distance below 2³⁰ the sum stays below
    /// 1.375 · 2³⁰.
    #[inline(always)]
    pub const fn along(self, direction: Direction, distance: Length) -> Self {
        let Vector { x, y, z } = direction.scaled(distance.to_bits());
        Self::new(self.x + x, self.y + y, self.z + z)
    }

    /// The point `distance` along `direction`, each coordinate rounded to the nearest step. The same
    /// ranges as of [`Point::along`].
    #[inline(always)]
    pub const fn precisely_along(self, direction: Direction, distance: Length) -> Self {
        let distance = distance.to_bits();
        Self::new(
            self.x + narrowed(rounded(wide(distance, direction.x.to_bits()), 30)),
            self.y + narrowed(rounded(wide(distance, direction.y.to_bits()), 30)),
            self.z + narrowed(rounded(wide(distance, direction.z.to_bits()), 30)),
        )
    }

    /// All coordinates divided by 2^`shift`, rounded down.
    pub const fn coarser(self, shift: u32) -> Self {
        Self::new(self.x >> shift, self.y >> shift, self.z >> shift)
    }
}

/// A difference of points, in raw scene steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vector {
    /// Raw steps.
    pub x: i32,
    /// Raw steps.
    pub y: i32,
    /// Raw steps.
    pub z: i32,
}

impl Vector {
    /// No way at all.
    pub const ZERO: Self = Self::new(0, 0, 0);

    /// From raw steps.
    pub const fn new(x: i32, y: i32, z: i32) -> Self {
        Self { x, y, z }
    }

    /// The sum.
    pub(crate) const fn plus(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }

    /// The difference.
    pub(crate) const fn minus(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }

    /// The length along `direction` with 30 more fraction bits: below 2⁶² for coordinates
    /// within ±2³⁰.
    pub const fn dot_wide(self, direction: Direction) -> i64 {
        wide(self.x, direction.x.to_bits())
            + wide(self.y, direction.y.to_bits())
            + wide(self.z, direction.z.to_bits())
    }

    /// The length along `direction`, rounded down.
    #[inline(always)]
    pub const fn dot(self, direction: Direction) -> i32 {
        narrowed(self.dot_wide(direction) >> 30)
    }

    /// A quarter of the length along `direction`, rounded down.
    #[inline(always)]
    pub const fn quarter_dot(self, direction: Direction) -> i32 {
        (self.dot_wide(direction) >> 32) as i32
    }

    /// The squared length, for coordinates within ±2³⁰.
    pub const fn square(self) -> u64 {
        unsigned_wide(wide(self.x, self.x))
            + unsigned_wide(wide(self.y, self.y))
            + unsigned_wide(wide(self.z, self.z))
    }

    /// Whether a line whose nearest point to the end of this way is `distance` along passes it by
    /// more than `radius`, or comes no nearer than that before its beginning, for sure: directions
    /// are within 2⁻²⁶ of length one.
    #[inline(always)]
    pub(crate) const fn passes_by(self, distance: i32, radius: i32) -> bool {
        if distance < -radius {
            return true;
        }
        // Of all squares the high halves: each is short of its square by less than one.
        let along = high(distance, distance);
        let aside = (self.square() >> 32) as i32 - along - (along >> 24);
        aside > high(radius, radius) + 4
    }

    /// What is left when the part of length `length` along `direction` is taken away.
    #[inline(always)]
    pub const fn without(self, direction: Direction, length: i32) -> Self {
        self.minus(direction.raw_times(length))
    }

    /// The direction and the length, for a length below 2³¹; a relative error below 2⁻²⁶ for
    /// lengths from 2¹³ on, and below 1 / (2 length²) for shorter ones.
    ///
    /// The direction of the zero vector is zero.
    #[inline(always)]
    pub const fn direction_and_length(self) -> (Direction, Length) {
        let (direction, length, _) = self.direction_length_and_share(0);
        (direction, length)
    }

    /// The direction and the length, and the share of the length that `part` of it is, at most one.
    #[inline(always)]
    pub(crate) const fn direction_length_and_share(self, part: i32) -> (Direction, Length, Unit) {
        let (shift, mantissa) = unit_shift(self.square());
        let root = reciprocal_root(mantissa);
        let length = signed(high_unsigned(mantissa, unsigned(root) << 1) >> shift);
        let part = if part < length { part } else { length };
        (
            Direction::lengthened(self, shift, root),
            Length::from_bits(length),
            Unit::from_bits(high(part << shift, root) << 1),
        )
    }

    /// The direction, given the squared length, which may be off by 2⁻²⁸ of it.
    #[inline(always)]
    pub(crate) const fn direction_of_square(self, square: u64) -> Direction {
        let (shift, mantissa) = unit_shift(square);
        Direction::lengthened(self, shift, reciprocal_root(mantissa))
    }

    /// The direction, corrected to the last bit by one Newton step on its squared length.
    pub const fn precise_direction(self) -> Direction {
        let (shift, mantissa) = unit_shift(self.square());
        let root = reciprocal_root(mantissa);
        Direction::from_raw(Vector::new(
            narrowed(wide(self.x << shift, root) >> 31),
            narrowed(wide(self.y << shift, root) >> 31),
            narrowed(wide(self.z << shift, root) >> 31),
        ))
        .renormalised()
    }
}

#[cfg(test)]
mod sweeps;
