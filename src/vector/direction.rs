//! Directions of unit length: cosines, reflections, rotations and cross products. Knows no ray and no
//! scene.

use super::Vector;
use crate::number::{Unit, high, minus_wide, narrowed, rounded, signed_wide, wide};

/// Unit vector, Q2.30 per coordinate. Its length is within 2⁻²⁶ of one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Direction {
    pub(crate) x: Unit,
    pub(crate) y: Unit,
    pub(crate) z: Unit,
}

impl Direction {
    /// Direction of the x axis.
    pub const X: Self = Self {
        x: Unit::ONE,
        y: Unit::ZERO,
        z: Unit::ZERO,
    };

    /// Returns the three coordinates.
    pub const fn components(self) -> [Unit; 3] {
        [self.x, self.y, self.z]
    }

    /// Returns the cosine of the angle to `other`, rounded down to 2⁻³⁰.
    #[inline(always)]
    pub const fn dot(self, other: Self) -> Unit {
        Unit::from_bits(narrowed(self.dot_wide(other) >> 30))
    }

    /// Returns the cosine of the angle to `other`, rounded down to 2⁻²⁸.
    #[inline(always)]
    pub const fn short_dot(self, other: Self) -> Unit {
        Unit::from_bits(self.raw().quarter_dot(other) << 2)
    }

    /// Returns the cosine of the angle to `other` with 60 fraction bits.
    const fn dot_wide(self, other: Self) -> i64 {
        self.raw().dot_wide(other)
    }

    /// Returns the coordinates as a vector of raw Q2.30 bits.
    pub const fn raw(self) -> Vector {
        Vector::new(self.x.to_bits(), self.y.to_bits(), self.z.to_bits())
    }

    /// Returns the difference of another direction from this one, in raw Q2.30 bits. Returns `None` if the two
    /// are a right angle apart, or more: a coordinate of opposite ones would not fit.
    pub(crate) fn change_to(self, other: Self) -> Option<Vector> {
        (self.dot(other) > Unit::ZERO).then(|| other.raw().minus(self.raw()))
    }

    /// Creates a direction from raw Q2.30 bits. The caller ensures that its length is one.
    pub const fn from_raw(raw: Vector) -> Self {
        Self {
            x: Unit::from_bits(raw.x),
            y: Unit::from_bits(raw.y),
            z: Unit::from_bits(raw.z),
        }
    }

    /// Returns the direction of `vector`. `shift` brings the vector to a length L of 2³⁰ to 2³¹, and
    /// `root` is 2⁶¹ / L. Coordinates are rounded down to 2⁻²⁹.
    #[inline(always)]
    pub(crate) const fn lengthened(vector: Vector, shift: u32, root: i32) -> Self {
        Self::from_raw(Vector::new(
            high(vector.x << shift, root) << 1,
            high(vector.y << shift, root) << 1,
            high(vector.z << shift, root) << 1,
        ))
    }

    /// Returns the opposite direction if `is_reversed`, else the same direction. Takes no branch.
    #[inline(always)]
    pub const fn reversed_if(self, is_reversed: bool) -> Self {
        let sign = -(is_reversed as i32);
        let Vector { x, y, z } = self.raw();
        Self::from_raw(Vector::new(
            (x ^ sign) - sign,
            (y ^ sign) - sign,
            (z ^ sign) - sign,
        ))
    }

    /// Returns the opposite direction.
    pub const fn reversed(self) -> Self {
        self.reversed_if(true)
    }

    /// Reflects the direction at a surface: `self` - 2 (`self` · `normal`) `normal`. `cosine` is
    /// `self` · `normal`.
    ///
    /// The length changes by a few last bits at most.
    pub const fn reflected(self, normal: Self, cosine: Unit) -> Self {
        let Vector { x, y, z } = self.raw();
        // A ray that hits head-on along an axis subtracts up to 2³¹; the difference fits 32 bits again.
        Self::from_raw(Vector::new(
            minus_wide(x, twice(cosine, normal.x)),
            minus_wide(y, twice(cosine, normal.y)),
            minus_wide(z, twice(cosine, normal.z)),
        ))
    }

    /// Rotates the direction towards `other`, which is perpendicular to it:
    /// `self` · cosine + `other` · sine.
    pub(crate) fn turned_towards(self, other: Self, (sine, cosine): (Unit, Unit)) -> Self {
        Self::from_raw(
            self.raw_times(cosine.to_bits())
                .plus(other.raw_times(sine.to_bits())),
        )
        .renormalised()
    }

    /// Rotates the direction about `axis` (Rodrigues' formula).
    pub(crate) fn turned_about(self, axis: Self, (sine, cosine): (Unit, Unit)) -> Self {
        let along = axis.raw_times(self.dot(axis).to_bits());
        let across = self.raw().minus(along);
        let turned = along
            .plus(Self::from_raw(across).raw_times(cosine.to_bits()))
            .plus(axis.crossed(self).raw_times(sine.to_bits()));
        Self::from_raw(turned).renormalised()
    }

    /// Returns the vector of `length` steps along the direction, each coordinate rounded down. `length`
    /// is within ±2³⁰.
    #[inline(always)]
    pub(crate) const fn raw_times(self, length: i32) -> Vector {
        self.raw().part(Unit::from_bits(length))
    }

    /// Returns the vector of `length` steps along the direction, each coordinate rounded to nearest.
    #[inline(always)]
    pub(crate) const fn nearest(self, length: i32) -> Vector {
        Vector::new(
            narrowed(rounded(wide(length, self.x.to_bits()), 30)),
            narrowed(rounded(wide(length, self.y.to_bits()), 30)),
            narrowed(rounded(wide(length, self.z.to_bits()), 30)),
        )
    }

    /// Returns the vector of `length` steps along the direction, each coordinate rounded down to an even
    /// number. `length` is below 2³⁰. The coarser rounding takes half the instructions.
    #[inline(always)]
    pub const fn scaled(self, length: i32) -> Vector {
        let twice = length << 1;
        Vector::new(
            high(twice, self.x.to_bits()) << 1,
            high(twice, self.y.to_bits()) << 1,
            high(twice, self.z.to_bits()) << 1,
        )
    }

    /// Corrects the length of the direction to one. The length must be within 2⁻¹¹ of one; one step of
    /// third order then corrects all but the last bits.
    pub const fn renormalised(self) -> Self {
        // h = (1 - |d|²) / 2, in Q30.
        let lack = narrowed(((1_i64 << 60) + (1 << 30) - signed_wide(self.raw().square())) >> 31);
        // 1 / √(1 - 2 h) = 1 + h + 3 h² / 2 + ...
        let excess = lack + high(2 * lack, 3 * lack);
        Self::from_raw(self.raw().plus(self.nearest(excess)))
    }

    /// Does what [`Self::renormalised`] does in half the instructions: it rounds coordinates down. So even a direction of
    /// length one may change in its last bit.
    #[inline(always)]
    pub(crate) const fn quickly_renormalised(self) -> Self {
        // h = (1 - |d|²) / 2, in Q32.
        let lack = narrowed(((1_i64 << 60) - signed_wide(self.raw().square())) >> 29);
        // 1 / √(1 - 2 h) = 1 + h + 3 h² / 2 + ...
        let excess = lack + high(lack, lack + (lack >> 1));
        let Vector { x, y, z } = self.raw();
        Self::from_raw(Vector::new(
            x + high(excess, x),
            y + high(excess, y),
            z + high(excess, z),
        ))
    }

    /// Returns the cross product, scaled so that its largest coordinate has 29 bits, and the shift of
    /// that scale: |`self` × `other`| = |vector| · 2^(shift - 60). The shift is 1 to 32. Returns `None`
    /// if the directions are parallel.
    pub const fn cross(self, other: Self) -> Option<(Vector, u32)> {
        // The exact cross product is in Q60.
        match Vector::leading(self.raw().cross_wide(other.raw()), 29) {
            (_, 0) => None,
            crossed => Some(crossed),
        }
    }

    /// Returns the cross product with a perpendicular direction, which is a direction again.
    pub const fn crossed(self, other: Self) -> Self {
        Self::from_raw(self.crossed_with(other.raw()))
    }

    /// Returns the cross product of the direction with the vector `b`, each coordinate rounded down.
    pub(crate) const fn crossed_with(self, b: Vector) -> Vector {
        let [x, y, z] = self.raw().cross_wide(b);
        Vector::new(narrowed(x >> 30), narrowed(y >> 30), narrowed(z >> 30))
    }

    /// Returns the direction of the cross product, exact to the last bit, or `None` if the directions
    /// are parallel.
    pub const fn perpendicular(self, other: Self) -> Option<Self> {
        match self.cross(other) {
            Some((vector, _)) => Some(vector.precise_direction()),
            None => None,
        }
    }
}

/// Returns 2 · `a` · `b` in Q30, rounded down. The result has 64 bits, because 2 does not fit Q2.30.
const fn twice(a: Unit, b: Unit) -> i64 {
    wide(a.to_bits(), b.to_bits()) >> 29
}
