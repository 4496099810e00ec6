//! Floor 1: points, differences of points, and directions of unit length.
//!
//! A [`Point`] and a [`Vector`] hold raw scene steps ([`Length`]); a [`Direction`] holds
//! Q2.30 and has length one by construction. Knows no ray and no scene.

use crate::number::{Length, Number, Unit, reciprocal_root, scaled_by_unit, unit_shift};

/// Three coordinates of a description: a position, or a normal, axis or view direction that is
/// not normalised yet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position(pub [Number; 3]);

impl Position {
    /// The largest coordinate a description may hold, in scene units: 2³⁰.
    pub const MAX_COORDINATE: i64 = 1 << 30;

    /// The origin.
    pub const ORIGIN: Self = Self([Number::ZERO; 3]);

    /// From plain decimal numbers.
    pub const fn new([x, y, z]: [f64; 3]) -> Self {
        Self([Number::new(x), Number::new(y), Number::new(z)])
    }

    /// Whether every coordinate is within ±[`Position::MAX_COORDINATE`].
    pub const fn is_in_range(self) -> bool {
        const MAX: i64 = Position::MAX_COORDINATE;
        let [x, y, z] = self.0;
        x.is_within(-MAX, MAX) && y.is_within(-MAX, MAX) && z.is_within(-MAX, MAX)
    }

    /// `self - other`, for coordinates in range.
    pub(crate) const fn minus(self, other: Self) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self.0, other.0);
        Self([
            Number::from_bits(ax.to_bits() - bx.to_bits()),
            Number::from_bits(ay.to_bits() - by.to_bits()),
            Number::from_bits(az.to_bits() - bz.to_bits()),
        ])
    }

    /// The position as far from `self` as `offset`, a result of [`Position::leading`], is long, in
    /// another direction.
    pub(crate) fn plus(self, direction: Direction, (offset, shift): (Vector, i32)) -> Self {
        let length = i128::from(offset.direction_and_length().1.to_bits());
        let [x, y, z] = self.0;
        let moved = |start: Number, unit: Unit| {
            // Q30 times the length: 60 bits and a shift of -29 to 66.
            let way = length * i128::from(unit.to_bits());
            let way = if shift >= 30 {
                way << (shift - 30)
            } else {
                way >> (30 - shift)
            };
            Number::from_bits(start.to_bits() + way)
        };
        Self([
            moved(x, direction.x),
            moved(y, direction.y),
            moved(z, direction.z),
        ])
    }

    /// The largest magnitude of a coordinate, in the bits of a [`Number`].
    pub(crate) const fn magnitude(self) -> u128 {
        let [x, y, z] = self.0;
        max(
            max(x.to_bits().unsigned_abs(), y.to_bits().unsigned_abs()),
            z.to_bits().unsigned_abs(),
        )
    }

    /// As a vector scaled by the power of two that gives its largest coordinate 29 bits, and
    /// how far it was shifted right for that; `None` for zero.
    pub(crate) const fn leading(self) -> Option<(Vector, i32)> {
        let magnitude = self.magnitude();
        if magnitude == 0 {
            return None;
        }
        let shift = 128 - magnitude.leading_zeros() as i32 - 29;
        let [x, y, z] = self.0;
        let vector = Vector::new(
            leading_bits(x, shift),
            leading_bits(y, shift),
            leading_bits(z, shift),
        );
        Some((vector, shift))
    }

    /// The direction it points in, to the last bit; `None` for zero.
    pub(crate) const fn direction(self) -> Option<Direction> {
        match self.leading() {
            Some((vector, _)) => Some(vector.precise_direction()),
            None => None,
        }
    }
}

const fn max(a: u128, b: u128) -> u128 {
    if a > b { a } else { b }
}

/// `number` · 2^-`shift`, rounded to nearest.
const fn leading_bits(number: Number, shift: i32) -> i32 {
    let bits = number.to_bits();
    if shift > 0 {
        ((bits + (1 << (shift - 1))) >> shift) as i32
    } else {
        (bits << -shift) as i32
    }
}

impl<N: Into<Number>> From<[N; 3]> for Position {
    fn from(coordinates: [N; 3]) -> Self {
        Self(coordinates.map(Into::into))
    }
}

#[cfg(feature = "micromath")]
impl From<micromath::vector::F32x3> for Position {
    fn from(vector: micromath::vector::F32x3) -> Self {
        Self::from([vector.x, vector.y, vector.z])
    }
}

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

    /// The point `distance` along `direction`.
    ///
    /// With coordinates within ±3 · 2²⁷ and a distance of at most 2³⁰ the sum stays below
    /// 1.375 · 2³⁰.
    pub const fn along(self, direction: Direction, distance: Length) -> Self {
        let t = distance.to_bits();
        Self::new(
            self.x + scaled_by_unit(t, direction.x),
            self.y + scaled_by_unit(t, direction.y),
            self.z + scaled_by_unit(t, direction.z),
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
        self.x as i64 * direction.x.to_bits() as i64
            + self.y as i64 * direction.y.to_bits() as i64
            + self.z as i64 * direction.z.to_bits() as i64
    }

    /// The length along `direction`, rounded down.
    pub const fn dot(self, direction: Direction) -> i32 {
        (self.dot_wide(direction) >> 30) as i32
    }

    /// The squared length, for coordinates within ±2³⁰.
    pub const fn square(self) -> u64 {
        (self.x as i64 * self.x as i64) as u64
            + (self.y as i64 * self.y as i64) as u64
            + (self.z as i64 * self.z as i64) as u64
    }

    /// What is left when the part of length `length` along `direction` is taken away.
    pub const fn without(self, direction: Direction, length: i32) -> Self {
        Self::new(
            self.x - scaled_by_unit(length, direction.x),
            self.y - scaled_by_unit(length, direction.y),
            self.z - scaled_by_unit(length, direction.z),
        )
    }

    /// The direction and the length, for a length below 2³¹; a relative error below 2⁻²⁶ for
    /// lengths from 2¹³ on, and below 1 / (2 length²) for shorter ones.
    ///
    /// The direction of the zero vector is zero.
    pub const fn direction_and_length(self) -> (Direction, Length) {
        let square = self.square();
        let (shift, mantissa) = unit_shift(square);
        let root = reciprocal_root(mantissa);
        let length = ((mantissa as u64 * root as u64) >> 31 >> shift) as i32;
        (
            Direction::lengthened(self, shift, root),
            Length::from_bits(length),
        )
    }

    /// The direction, corrected to the last bit by one Newton step on its squared length.
    pub const fn precise_direction(self) -> Direction {
        self.direction_and_length().0.renormalised()
    }
}

/// A vector of length one, Q2.30 a coordinate: within 2⁻²⁶ of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Direction {
    pub(crate) x: Unit,
    pub(crate) y: Unit,
    pub(crate) z: Unit,
}

impl Direction {
    /// The x axis.
    pub const X: Self = Self {
        x: Unit::ONE,
        y: Unit::ZERO,
        z: Unit::ZERO,
    };

    /// The coordinates.
    pub const fn components(self) -> [Unit; 3] {
        [self.x, self.y, self.z]
    }

    /// The cosine of the angle to `other`.
    pub const fn dot(self, other: Self) -> Unit {
        Unit::from_bits((self.dot_wide(other) >> 30) as i32)
    }

    /// The cosine with 60 fraction bits.
    const fn dot_wide(self, other: Self) -> i64 {
        self.raw().dot_wide(other)
    }

    /// The coordinates as raw Q2.30.
    pub const fn raw(self) -> Vector {
        Vector::new(self.x.to_bits(), self.y.to_bits(), self.z.to_bits())
    }

    const fn from_raw(raw: Vector) -> Self {
        Self {
            x: Unit::from_bits(raw.x),
            y: Unit::from_bits(raw.y),
            z: Unit::from_bits(raw.z),
        }
    }

    /// The direction of a vector, given the shift that gives it a length L of 2³⁰ to 2³¹ and
    /// `root` = 2⁶¹ / L.
    pub(crate) const fn lengthened(vector: Vector, shift: u32, root: i32) -> Self {
        Self::from_raw(Vector::new(
            (((vector.x << shift) as i64 * root as i64) >> 31) as i32,
            (((vector.y << shift) as i64 * root as i64) >> 31) as i32,
            (((vector.z << shift) as i64 * root as i64) >> 31) as i32,
        ))
    }

    /// The opposite direction.
    pub const fn reversed(self) -> Self {
        Self::from_raw(Vector::new(
            -self.x.to_bits(),
            -self.y.to_bits(),
            -self.z.to_bits(),
        ))
    }

    /// `self - 2 (self · normal) normal`, given `cosine` = self · normal.
    ///
    /// The length is kept to a few last bits.
    pub const fn reflected(self, normal: Self, cosine: Unit) -> Self {
        let Vector { x, y, z } = self.raw();
        // Head-on along an axis the part taken away reaches 2³¹; what is left fits again.
        Self::from_raw(Vector::new(
            x.wrapping_sub(twice(cosine, normal.x)),
            y.wrapping_sub(twice(cosine, normal.y)),
            z.wrapping_sub(twice(cosine, normal.z)),
        ))
    }

    /// `self` cos + `other` sin, for perpendicular directions.
    pub(crate) fn turned_towards(self, other: Self, (sine, cosine): (Unit, Unit)) -> Self {
        Self::from_raw(self.scaled(cosine).plus(other.scaled(sine))).renormalised()
    }

    /// `self` turned about a unit axis (Rodrigues' formula).
    pub(crate) fn turned_about(self, axis: Self, (sine, cosine): (Unit, Unit)) -> Self {
        let along = axis.scaled(self.dot(axis));
        let across = self.raw().minus(along);
        let turned = along
            .plus(Self::from_raw(across).scaled(cosine))
            .plus(axis.crossed(self).scaled(sine));
        Self::from_raw(turned).renormalised()
    }

    /// Every coordinate times `unit`, in Q2.30.
    fn scaled(self, unit: Unit) -> Vector {
        let Vector { x, y, z } = self.raw();
        Vector::new(
            scaled_by_unit(x, unit),
            scaled_by_unit(y, unit),
            scaled_by_unit(z, unit),
        )
    }

    /// The same direction with its length corrected: one Newton step, which leaves the last bit
    /// of a length that was within 2⁻¹⁵ of one.
    pub const fn renormalised(self) -> Self {
        // Half of 1 - |d|², in Q30.
        let excess = (((1_i64 << 60) + (1 << 30) - self.raw().square() as i64) >> 31) as i32;
        Self::from_raw(Vector::new(
            grown(self.x.to_bits(), excess),
            grown(self.y.to_bits(), excess),
            grown(self.z.to_bits(), excess),
        ))
    }

    /// The cross product scaled so that its largest coordinate has 29 bits, and the shift that
    /// did it: |self × other| = |vector| · 2^(shift - 60), and shift is 1 to 32. `None` where the
    /// two are parallel.
    pub const fn cross(self, other: Self) -> Option<(Vector, u32)> {
        let (a, b) = (self.raw(), other.raw());
        // Exact in Q60.
        let x = a.y as i64 * b.z as i64 - a.z as i64 * b.y as i64;
        let y = a.z as i64 * b.x as i64 - a.x as i64 * b.z as i64;
        let z = a.x as i64 * b.y as i64 - a.y as i64 * b.x as i64;
        let bits = 64 - (x.unsigned_abs() | y.unsigned_abs() | z.unsigned_abs()).leading_zeros();
        if bits < 30 {
            return None;
        }
        let shift = bits - 29;
        Some((
            Vector::new(
                (x >> shift) as i32,
                (y >> shift) as i32,
                (z >> shift) as i32,
            ),
            shift,
        ))
    }

    /// The cross product of two perpendicular directions.
    pub const fn crossed(self, other: Self) -> Self {
        let (a, b) = (self.raw(), other.raw());
        Self::from_raw(Vector::new(
            ((a.y as i64 * b.z as i64 - a.z as i64 * b.y as i64) >> 30) as i32,
            ((a.z as i64 * b.x as i64 - a.x as i64 * b.z as i64) >> 30) as i32,
            ((a.x as i64 * b.y as i64 - a.y as i64 * b.x as i64) >> 30) as i32,
        ))
    }

    /// The direction of the cross product, to the last bit; `None` where the two are parallel.
    pub const fn perpendicular(self, other: Self) -> Option<Self> {
        match self.cross(other) {
            Some((vector, _)) => Some(vector.precise_direction()),
            None => None,
        }
    }
}

/// 2 `a` `b`, rounded down; 2 wraps to -2.
const fn twice(a: Unit, b: Unit) -> i32 {
    ((a.to_bits() as i64 * b.to_bits() as i64) >> 29) as i32
}

/// `coordinate` (1 + `excess`), rounded to nearest.
const fn grown(coordinate: i32, excess: i32) -> i32 {
    coordinate + ((coordinate as i64 * excess as i64 + (1 << 29)) >> 30) as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::sine_and_cosine_of;

    #[test]
    fn a_turn_about_an_axis_is_a_turn() {
        let axis = Position::new([0.0, 0.0, 1.0]).direction().unwrap();
        let quarter = sine_and_cosine_of(Number::from(90));
        let turned = Direction::X.turned_about(axis, quarter);
        let [x, y, z] = turned.components().map(|unit| unit.to_num::<f64>());
        assert!(
            x.abs() < 1e-8 && (y - 1.0).abs() < 1e-8 && z.abs() < 1e-8,
            "{x} {y} {z}"
        );
    }

    #[test]
    fn directions_of_axes_are_exact() {
        assert_eq!(
            Position::new([3.7, 0.0, 0.0]).direction(),
            Some(Direction::X)
        );
        assert_eq!(
            Position::new([1e-12, 0.0, 0.0]).direction(),
            Some(Direction::X)
        );
        assert_eq!(
            Position::new([1e9, 0.0, 0.0]).direction(),
            Some(Direction::X)
        );
    }
}

#[cfg(test)]
mod sweeps;
