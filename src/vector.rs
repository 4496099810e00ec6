//! Floor 1: points, differences of points, and directions of unit length.
//!
//! A [`Point`] and a [`Vector`] hold raw scene steps ([`Length`]). A [`Direction`] holds Q2.30 and has
//! length one by construction. Knows no ray and no scene.

mod direction;
mod position;

pub use direction::Direction;
pub use position::Position;
pub(crate) use position::leading_shift;

use crate::number::{
    Length, Unit, high, high_unsigned, narrowed, reciprocal_root, scaled_by_unit, shifted, signed,
    unit_shift, unsigned, unsigned_wide, wide,
};

/// Point of the scene, in raw scene steps from the middle of the scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Point {
    /// Coordinate along the x axis, in raw steps.
    pub x: i32,
    /// Coordinate along the y axis, in raw steps.
    pub y: i32,
    /// Coordinate along the z axis, in raw steps.
    pub z: i32,
}

impl Point {
    /// Middle of the scene: all coordinates are 0.
    pub const ORIGIN: Self = Self { x: 0, y: 0, z: 0 };

    /// Creates a point from its coordinates in raw steps.
    pub const fn new(x: i32, y: i32, z: i32) -> Self {
        Self { x, y, z }
    }

    /// Returns the vector from `self` to `other`. Every coordinate of both points is within ±2³⁰.
    pub const fn to(self, other: Self) -> Vector {
        Vector::new(other.x - self.x, other.y - self.y, other.z - self.z)
    }

    /// Returns the point at the end of a vector from the middle of the scene.
    pub(crate) const fn at(way: Vector) -> Self {
        Self::new(way.x, way.y, way.z)
    }

    /// Returns the point that divides the way to another one, at a share of it.
    pub(crate) fn towards(self, other: Self, share: Unit) -> Self {
        Self::at(self.to_vector().plus(self.to(other).part(share)))
    }

    /// Returns the vector from the middle of the scene to the point.
    pub const fn to_vector(self) -> Vector {
        Vector::new(self.x, self.y, self.z)
    }

    /// Returns the point at `distance` along `direction`. Each coordinate changes by an even number of
    /// steps, rounded down.
    ///
    /// With coordinates within ±3 · 2²⁷ and a distance below 2³⁰, the sum stays below 1.375 · 2³⁰.
    #[inline(always)]
    pub const fn along(self, direction: Direction, distance: Length) -> Self {
        let Vector { x, y, z } = direction.scaled(distance.to_bits());
        Self::new(self.x + x, self.y + y, self.z + z)
    }

    /// Returns the point at `distance` along `direction`, each coordinate rounded to the nearest step.
    ///
    /// With coordinates within ±3 · 2²⁷ and a distance below 2³⁰, the sum stays below 1.375 · 2³⁰.
    #[inline(always)]
    pub const fn precisely_along(self, direction: Direction, distance: Length) -> Self {
        Self::at(self.to_vector().plus(direction.nearest(distance.to_bits())))
    }

    /// Divides all coordinates by 2^`shift`, rounded down.
    pub const fn coarser(self, shift: u32) -> Self {
        Self::new(self.x >> shift, self.y >> shift, self.z >> shift)
    }
}

/// Difference of two points, in raw scene steps.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Vector {
    /// Component along the x axis, in raw steps.
    pub x: i32,
    /// Component along the y axis, in raw steps.
    pub y: i32,
    /// Component along the z axis, in raw steps.
    pub z: i32,
}

impl Vector {
    /// The zero vector.
    pub const ZERO: Self = Self::new(0, 0, 0);

    /// Creates a vector from its components in raw steps.
    pub const fn new(x: i32, y: i32, z: i32) -> Self {
        Self { x, y, z }
    }

    /// Returns a vector of wide coordinates, each rounded down so that all have at most `bits` bits and a sign,
    /// and the right shift that this takes.
    ///
    /// Not inlined, because a 64-bit shift takes many instructions and callers need it rarely.
    #[inline(never)]
    pub(crate) const fn leading([x, y, z]: [i64; 3], bits: u32) -> (Self, u32) {
        let used = 64 - ((x ^ x >> 63) | (y ^ y >> 63) | (z ^ z >> 63)).leading_zeros();
        let shift = used.saturating_sub(bits);
        let vector = Self::new(
            narrowed(shifted(x, -signed(shift))),
            narrowed(shifted(y, -signed(shift))),
            narrowed(shifted(z, -signed(shift))),
        );
        (vector, shift)
    }

    /// Adds two vectors. The sums must fit 32 bits.
    pub(crate) const fn plus(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }

    /// Subtracts `other` from this vector. The differences must fit 32 bits.
    pub(crate) const fn minus(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }

    /// Returns the vector with all components shifted to the left. They must fit 32 bits.
    pub(crate) const fn lifted(self, shift: u32) -> Self {
        Self::new(self.x << shift, self.y << shift, self.z << shift)
    }

    /// Returns the vector with all components divided by 2^`shift`, rounded down.
    pub(crate) const fn coarser(self, shift: u32) -> Self {
        Self::new(self.x >> shift, self.y >> shift, self.z >> shift)
    }

    /// Multiplies all components by a Q2.30 number, rounded down. They must stay within ±2³¹.
    #[inline(always)]
    pub(crate) const fn part(self, share: Unit) -> Self {
        Self::new(
            scaled_by_unit(self.x, share),
            scaled_by_unit(self.y, share),
            scaled_by_unit(self.z, share),
        )
    }

    /// Returns the exact dot product with another vector. Components of one are within ±2³⁰, of the other ±2³¹.
    pub(crate) const fn dot_raw(self, b: Self) -> i64 {
        wide(self.x, b.x) + wide(self.y, b.y) + wide(self.z, b.z)
    }

    /// Returns the exact cross product with another vector. All components are within ±2³⁰.
    pub(crate) const fn cross_wide(self, b: Self) -> [i64; 3] {
        [
            wide(self.y, b.z) - wide(self.z, b.y),
            wide(self.z, b.x) - wide(self.x, b.z),
            wide(self.x, b.y) - wide(self.y, b.x),
        ]
    }

    /// Returns the dot product with `direction`: the length of the vector along it, in steps with 30
    /// fraction bits. Its magnitude is below 2⁶² for coordinates within ±2³⁰.
    pub const fn dot_wide(self, direction: Direction) -> i64 {
        // Not by `dot_raw`: cores without a long multiply would take more instructions.
        wide(self.x, direction.x.to_bits())
            + wide(self.y, direction.y.to_bits())
            + wide(self.z, direction.z.to_bits())
    }

    /// Returns the dot product with `direction`: the length of the vector along it, rounded down to a
    /// step.
    #[inline(always)]
    pub const fn dot(self, direction: Direction) -> i32 {
        narrowed(self.dot_wide(direction) >> 30)
    }

    /// Returns a quarter of the dot product with `direction`, in steps, rounded down. It is the high
    /// word of the exact product.
    #[inline(always)]
    pub const fn quarter_dot(self, direction: Direction) -> i32 {
        (self.dot_wide(direction) >> 32) as i32
    }

    /// Returns the squared length of the vector. Every coordinate is within ±2³⁰.
    pub const fn square(self) -> u64 {
        unsigned_wide(wide(self.x, self.x))
            + unsigned_wide(wide(self.y, self.y))
            + unsigned_wide(wide(self.z, self.z))
    }

    /// Tests whether a ray in a direction surely misses a ball of `radius` steps. This vector leads from the ray's origin to
    /// the ball's centre. The ball is missed if the ray's line passes it or if it lies behind the origin. Allows for
    /// directions within 2⁻²⁶ of length one.
    #[inline(always)]
    pub(crate) const fn passes_by(self, direction: Direction, radius: i32) -> bool {
        let quarter = self.quarter_dot(direction);
        // Both in steps of four: the length along the ray is rounded down, the radius up.
        if quarter < !(radius >> 2) {
            return true;
        }
        // That length is off by up to 4 steps and below 2³¹, so the high word of its square is off by up to 4. Rounding
        // takes less than 1 off each high word.
        let along = high(quarter << 2, quarter << 2);
        (self.square() >> 32) as i32 - along - (along >> 24) > high(radius, radius) + 8
    }

    /// Subtracts the part of length `length` steps along `direction`. If `length` is the dot product
    /// with `direction`, the rest is perpendicular to it.
    #[inline(always)]
    pub const fn without(self, direction: Direction, length: i32) -> Self {
        self.minus(direction.raw_times(length))
    }

    /// Returns the direction and the length of a vector shorter than 2³¹ steps. The relative error is
    /// below 2⁻²⁶ for lengths from 2¹³ on, and below 1 / (2 length²) for shorter ones.
    ///
    /// The direction of the zero vector is zero.
    #[inline(always)]
    pub const fn direction_and_length(self) -> (Direction, Length) {
        let (direction, length, _) = self.direction_length_and_share(0);
        (direction, length)
    }

    /// Returns what [`Vector::direction_and_length`] does, out of line: code that is rare takes less flash.
    #[inline(never)]
    pub const fn normalised(self) -> (Direction, Length) {
        self.direction_and_length()
    }

    /// Returns the direction, the length, and the quotient `part` / length, which is limited to one.
    /// `part` is in steps. One reciprocal root gives all three.
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

    /// Returns the direction of the vector. `square` is its squared length, which may have a relative
    /// error of 2⁻²⁸.
    #[inline(always)]
    pub(crate) const fn direction_of_square(self, square: u64) -> Direction {
        let (shift, mantissa) = unit_shift(square);
        Direction::lengthened(self, shift, reciprocal_root(mantissa))
    }

    /// Returns the direction of the vector, corrected to the last bit by one Newton step on its squared
    /// length.
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
