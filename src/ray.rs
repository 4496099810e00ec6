//! Floor 1: rays, the places they start from, and the one place that offsets a ray from the
//! surface it leaves.
//!
//! Bounded shapes lie in a ball of 2²⁸ raw steps around the middle of the scene. A plane may be
//! met much further out, so a [`ScaledPoint`] carries a power of two: it is *near* (power 0, all
//! kernels work on it directly) or *far* (its point is in steps of 2ˢ, and a ray that starts
//! there is first moved to the ball).

use crate::number::{
    Length, high, narrowed, offset_modulo_2_32, product_modulo_2_32, shifted, signed,
    sum_modulo_2_32, unsigned,
};
use crate::vector::{Direction, Point, Vector};

/// The radius of the ball that holds every bounded shape, in raw steps.
pub const BALL: i32 = 1 << 28;

/// The largest magnitude of a coordinate of a near point, in raw steps.
///
/// Two near points are then at most 2√3 · 3 · 2²⁷ < 2³¹·⁵ apart and their difference fits
/// ±2³⁰ a coordinate.
pub const NEAR: i32 = 3 << 27;

/// How far a near ray looks, in raw steps: it crosses the ball from any near point,
/// √3 · 3 · 2²⁷ + 2²⁸ < 2³⁰.
pub const REACH: Length = Length::from_bits(1 << 30);

/// A point with its scale: `point` · 2^`scale` raw steps from the middle of the scene.
///
/// Normal form: every coordinate of `point` is within ±[`NEAR`], and `scale` is 0 or as small as
/// that allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScaledPoint {
    pub(crate) point: Point,
    pub(crate) scale: u32,
}

impl ScaledPoint {
    /// The middle of the scene.
    pub const ORIGIN: Self = Self {
        point: Point::ORIGIN,
        scale: 0,
    };

    /// Brings a point in steps of 2^`scale` to normal form.
    pub const fn new(point: Point, scale: u32) -> Self {
        let mut place = Self { point, scale };
        while !is_near(place.point) {
            place = Self {
                point: place.point.coarser(1),
                scale: place.scale + 1,
            };
        }
        place
    }

    /// Brings wide coordinates in raw steps to normal form; each is within ±2⁶².
    #[inline(never)]
    pub const fn from_wide(coordinates: [i64; 3]) -> Self {
        let [x, y, z] = coordinates;
        let bits = 64 - ((x ^ x >> 63) | (y ^ y >> 63) | (z ^ z >> 63)).leading_zeros();
        let shift = bits.saturating_sub(30);
        Self::new(
            Point::new(
                narrowed(shifted(x, -signed(shift))),
                narrowed(shifted(y, -signed(shift))),
                narrowed(shifted(z, -signed(shift))),
            ),
            shift,
        )
    }

    /// Whether the place is near.
    #[inline(always)]
    pub const fn is_near(self) -> bool {
        self.scale == 0
    }

    /// A near point, if it is one.
    #[inline(always)]
    pub(crate) const fn near(point: Point) -> Option<Self> {
        if is_near(point) {
            Some(Self { point, scale: 0 })
        } else {
            None
        }
    }

    /// Where every ray starts that leaves a surface here: `epsilon`, below 2²⁸, along the normal.
    #[inline(always)]
    pub const fn lifted(self, normal: Direction, epsilon: Length) -> Self {
        let step = match self.scale {
            0 => epsilon.to_bits(),
            scale => coarser(epsilon, scale),
        } << 2;
        let Point { x, y, z } = self.point;
        let point = Point::new(
            x + high(step, normal.x.to_bits()),
            y + high(step, normal.y.to_bits()),
            z + high(step, normal.z.to_bits()),
        );
        Self {
            point,
            scale: self.scale,
        }
    }

    /// The way to `other` in steps of 2ˢ, and s: the smallest scale that both have, or one more
    /// where they are far.
    pub const fn to(self, other: Self) -> (Vector, u32) {
        if self.scale | other.scale == 0 {
            return (self.point.to(other.point), 0);
        }
        let scale = if self.scale > other.scale {
            self.scale
        } else {
            other.scale
        };
        let from = self.point.coarser(shift_of(scale - self.scale));
        let to = other.point.coarser(shift_of(scale - other.scale));
        (from.to(to), scale)
    }
}

/// A length in steps of 2^`scale`; rarely asked.
#[cold]
#[inline(never)]
const fn coarser(length: Length, scale: u32) -> i32 {
    length.to_bits() >> shift_of(scale)
}

/// A shift that an `i32` allows: past 31 nothing but the sign is left anyway.
const fn shift_of(difference: u32) -> u32 {
    if difference > 31 { 31 } else { difference }
}

#[inline(always)]
const fn is_near(point: Point) -> bool {
    const SPAN: u32 = 2 * unsigned(NEAR);
    offset_modulo_2_32(point.x, NEAR) <= SPAN
        && offset_modulo_2_32(point.y, NEAR) <= SPAN
        && offset_modulo_2_32(point.z, NEAR) <= SPAN
}

/// A ray from a near point: what the shapes are tested against.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub(crate) origin: Point,
    pub(crate) direction: Direction,
}

/// A ray from any place: `ray` starts at a point in steps of 2^`scale`.
#[derive(Clone, Copy, Debug)]
pub struct ScaledRay {
    pub(crate) ray: Ray,
    pub(crate) scale: u32,
}

impl ScaledRay {
    /// The path from a place.
    #[inline(always)]
    pub(crate) const fn new(from: ScaledPoint, direction: Direction) -> Self {
        Self {
            ray: Ray {
                origin: from.point,
                direction,
            },
            scale: from.scale,
        }
    }

    /// Where it starts.
    #[inline(always)]
    pub(crate) const fn from(&self) -> ScaledPoint {
        ScaledPoint {
            point: self.ray.origin,
            scale: self.scale,
        }
    }

    /// Its direction.
    #[inline(always)]
    pub(crate) const fn direction(&self) -> Direction {
        self.ray.direction
    }
}

/// Spreads numbers over all bits, as in Fibonacci hashing modulo 2³² (Knuth, The Art of Computer
/// Programming, vol. 3, 6.4).
#[inline(always)]
pub(crate) const fn spread(number: u32) -> u32 {
    product_modulo_2_32(number, 0x9e37_79b1)
}

/// What a path has met on its way, as a number: paths that met the same have the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PathSignature(u32);

impl PathSignature {
    /// The highest bit.
    const BENT: u32 = 1 << 31;

    /// Of a path that has not met anything; not zero, or notes of zero would leave it as it is.
    pub(crate) const fn new() -> Self {
        Self(1)
    }

    /// Of no path.
    pub(crate) const fn of_none() -> Self {
        Self(u32::MAX)
    }

    /// Adds what was met.
    #[inline(always)]
    pub(crate) fn note(&mut self, met: u32) {
        // Times 1025, in one instruction. As 1024³ · 4 and 1024⁴ are nothing in 32 bits, two signatures may be
        // taken for one if their notes differ by at least four times 1, -3, 3, -1, or by 1, -4, 6, -4, 1:
        // not by one shape, or one light.
        self.0 = sum_modulo_2_32(sum_modulo_2_32(self.0, self.0 << 10), met);
    }

    /// Of the whole path, which may have been mirrored in something round, and then gone on.
    #[inline(always)]
    pub(crate) fn ended(self, is_bent: bool) -> Self {
        Self(self.0 & !Self::BENT | u32::from(is_bent) << Self::BENT.trailing_zeros())
    }

    /// Whether the path was mirrored in something round.
    #[inline(always)]
    pub(crate) fn is_bent(self) -> bool {
        self.0 & Self::BENT != 0
    }
}

/// The rays through the middles of the columns of a picture, as seen along the columns (or through
/// those of the rows, along the rows): from one near point, in one plane.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenAxis {
    pub(crate) origin: Point,
    /// Into the picture.
    pub(crate) ahead: Direction,
    /// From column to column.
    pub(crate) aside: Direction,
    /// How far ahead half pixels lie: `distance` · 2^`scale` half pixels.
    pub(crate) distance: i32,
    pub(crate) scale: i32,
    /// How many columns there are.
    pub(crate) width: u32,
}

#[cfg(test)]
mod tests;
