//! Positions of a description: three numbers in scene units, before they are converted to grid steps.

use super::{Direction, Vector};
use crate::number::{Number, Unit, narrowed, narrowed_128, numbers, signed};

/// Three coordinates of a description, in scene units: a position, or a normal, axis or view direction
/// that is not normalised yet.
///
/// ```
/// use reflet::{Number, Position};
/// let position = Position::new([0.0, 0.5, -2.0]);
/// assert_eq!(Position::from([Number::ZERO, Number::new(0.5), Number::from(-2)]), position);
/// assert_eq!(Position::from([0; 3]), Position::ORIGIN);
///
/// assert!(position.is_in_range());
/// let far = f64::from(1 << 30);
/// assert_eq!(far, Position::MAX_COORDINATE as f64);
/// assert!(!Position::new([2.0 * far, 0.0, 0.0]).is_in_range());
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Position(pub [Number; 3]);

impl Position {
    /// Largest magnitude of a coordinate in a description, in scene units: 2³⁰.
    pub const MAX_COORDINATE: i64 = 1 << 30;

    /// The origin: all coordinates are 0.
    pub const ORIGIN: Self = Self([Number::ZERO; 3]);

    /// Creates a position from decimal numbers.
    pub const fn new(coordinates: [f64; 3]) -> Self {
        Self(numbers(coordinates))
    }

    /// Tests whether every coordinate is within ±[`Position::MAX_COORDINATE`].
    pub const fn is_in_range(self) -> bool {
        const MAX: i64 = Position::MAX_COORDINATE;
        let [x, y, z] = self.0;
        x.is_within(-MAX, MAX) && y.is_within(-MAX, MAX) && z.is_within(-MAX, MAX)
    }

    /// Subtracts `other` from this position. All coordinates must be in range.
    pub(crate) const fn minus(self, other: Self) -> Self {
        let ([ax, ay, az], [bx, by, bz]) = (self.0, other.0);
        Self([
            Number::from_bits(ax.to_bits() - bx.to_bits()),
            Number::from_bits(ay.to_bits() - by.to_bits()),
            Number::from_bits(az.to_bits() - bz.to_bits()),
        ])
    }

    /// Returns the position at a distance from `self` along `direction`. The distance is the length of
    /// `offset`, which comes from [`Position::leading`].
    pub(crate) fn plus(self, direction: Direction, (offset, shift): (Vector, i32)) -> Self {
        let length = i128::from(offset.direction_and_length().1.to_bits());
        let [x, y, z] = self.0;
        let moved = |start: Number, unit: Unit| {
            // Q30 times the length: 60 bits and a shift of -29 to 66.
            let way = length * i128::from(unit.to_bits());
            let way = if shift >= 30 { way << (shift - 30) } else { way >> (30 - shift) };
            Number::from_bits(start.to_bits() + way)
        };
        Self([
            moved(x, direction.x),
            moved(y, direction.y),
            moved(z, direction.z),
        ])
    }

    /// Returns the largest magnitude of a coordinate, in the raw bits of a [`Number`].
    pub(crate) const fn magnitude(self) -> u128 {
        let [x, y, z] = self.0;
        max(
            max(x.to_bits().unsigned_abs(), y.to_bits().unsigned_abs()),
            z.to_bits().unsigned_abs(),
        )
    }

    /// Returns the position as a vector, scaled by a power of two so that its largest coordinate has 29
    /// bits, and the right shift of that scale. Returns `None` for the zero vector.
    #[inline(never)]
    pub(crate) const fn leading(self) -> Option<(Vector, i32)> {
        let magnitude = self.magnitude();
        if magnitude == 0 {
            return None;
        }
        let shift = leading_shift(magnitude);
        Some((self.coarser(shift), shift))
    }

    /// Returns the position as a vector, scaled by 2^-`shift`. Its coordinates must fit 30 bits.
    pub(crate) const fn coarser(self, shift: i32) -> Vector {
        let [x, y, z] = self.0;
        Vector::new(
            leading_bits(x, shift),
            leading_bits(y, shift),
            leading_bits(z, shift),
        )
    }

    /// Returns the direction of the position as a vector from the origin, exact to the last bit. Returns
    /// `None` for the zero vector.
    pub(crate) const fn direction(self) -> Option<Direction> {
        match self.leading() {
            Some((vector, _)) => Some(vector.precise_direction()),
            None => None,
        }
    }
}

/// Returns by how many bits a number above 0 is shifted right so that 29 bits of it are left.
pub(crate) const fn leading_shift(magnitude: u128) -> i32 {
    128 - signed(magnitude.leading_zeros()) - 29
}

/// Returns the larger of two numbers.
const fn max(a: u128, b: u128) -> u128 {
    if a > b { a } else { b }
}

/// Returns the raw bits of `number` · 2^-`shift`, rounded to nearest.
#[inline(never)]
const fn leading_bits(number: Number, shift: i32) -> i32 {
    let bits = number.to_bits();
    if shift > 0 {
        narrowed(narrowed_128((bits + (1 << (shift - 1))) >> shift))
    } else {
        narrowed(narrowed_128(bits << -shift))
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
