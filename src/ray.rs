//! Floor 1: rays, the points where they start, and the one function that moves the start of a ray off
//! the surface it leaves.
//!
//! Bounded shapes lie in a ball of 2²⁸ raw steps around the middle of the scene. A ray may hit a plane
//! much further out, so a [`ScaledPoint`] has a power of two. It is *near* if the power is 0: all
//! kernels work on it directly. Else it is *far*: its point is in steps of 2ˢ, and a ray that starts
//! there is first moved to the ball.

mod row_plane;
mod screen_axis;

pub(crate) use row_plane::{ANY_COLUMN, Chord, NO_COLUMN, SLACK, Seen, column};
pub use row_plane::{RowPlane, Span};
pub(crate) use screen_axis::ScreenAxis;

use crate::number::{
    Length, high, offset_modulo_2_32, product_modulo_2_32, sum_modulo_2_32, to_u16, unsigned,
};
use crate::vector::{Direction, Point, Vector};

/// Radius of the ball around the middle of the scene that holds every bounded shape, in raw steps.
pub const BALL: i32 = 1 << 28;

/// Limit of the coordinates of near points, in raw steps: they are from -`NEAR` to below `NEAR`.
///
/// Two near points are at most 2√3 · 3 · 2²⁷ < 2³¹·⁵ apart, and each coordinate of their difference is
/// within ±2³⁰.
pub const NEAR: i32 = 3 << 27;

/// Length of a near ray, in raw steps. It is enough to cross the ball of bounded shapes from any near
/// point: √3 · 3 · 2²⁷ + 2²⁸ < 2³⁰.
pub const REACH: Length = Length::from_bits(1 << 30);

/// Point at any distance, with a scale: `point` · 2^`scale` raw steps from the middle of the scene.
///
/// In normal form, every coordinate of `point` is from -[`NEAR`] to below [`NEAR`], and `scale` is 0 or the smallest
/// that allows it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScaledPoint {
    pub(crate) point: Point,
    pub(crate) scale: u32,
}

impl ScaledPoint {
    /// Middle of the scene: all coordinates are 0.
    pub const ORIGIN: Self = Self::at(Point::ORIGIN);

    /// Creates a near point: its coordinates are from -[`NEAR`] to below [`NEAR`].
    pub const fn at(point: Point) -> Self {
        Self { point, scale: 0 }
    }

    /// Creates a point from coordinates in steps of 2^`scale` and brings it to normal form.
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

    /// Creates a point from 64-bit coordinates in raw steps, each within ±2⁶², and brings it to normal
    /// form.
    pub const fn from_wide(coordinates: [i64; 3]) -> Self {
        let (way, scale) = Vector::leading(coordinates, 30);
        Self::new(Point::at(way), scale)
    }

    /// Returns a point so far away in a direction that rays from all near points to it are parallel, within
    /// rounding. Not inlined, or the compiler derives the direction's coordinates from what this needs.
    #[inline(never)]
    pub(crate) const fn beyond(direction: Direction) -> Self {
        let Vector { x, y, z } = direction.raw();
        Self {
            point: Point::new(x >> 2, y >> 2, z >> 2),
            scale: 30,
        }
    }

    /// Tests whether the point is near: its scale is 0.
    #[inline(always)]
    pub const fn is_near(self) -> bool {
        self.scale == 0
    }

    /// Creates a near point, or returns `None` if a coordinate is not from -[`NEAR`] to below [`NEAR`].
    #[inline(always)]
    pub(crate) const fn near(point: Point) -> Option<Self> {
        if is_near(point) { Some(Self::at(point)) } else { None }
    }

    /// Returns the point `epsilon` above a surface point, along `normal`. Every ray that leaves the
    /// surface starts there. `epsilon` is below 2²⁸ steps.
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

    /// Returns the vector to `other` in steps of 2ˢ, and s, which is the larger one of the two scales.
    pub const fn to(self, other: Self) -> (Vector, u32) {
        if self.scale | other.scale == 0 {
            return (self.point.to(other.point), 0);
        }
        let scale = if self.scale > other.scale { self.scale } else { other.scale };
        let from = self.point.coarser(shift_of(scale - self.scale));
        let to = other.point.coarser(shift_of(scale - other.scale));
        (from.to(to), scale)
    }
}

/// Converts a length to steps of 2^`scale`, rounded down. Rarely called.
#[cold]
#[inline(never)]
const fn coarser(length: Length, scale: u32) -> i32 {
    length.to_bits() >> shift_of(scale)
}

/// Limits a right shift of an `i32` to 31, the largest allowed. It leaves only the sign, as larger
/// shifts would.
pub(crate) const fn shift_of(difference: u32) -> u32 {
    if difference > 31 { 31 } else { difference }
}

/// Tests whether every coordinate of a point is from -[`NEAR`] to below [`NEAR`]. Arm compares
/// with this limit in one instruction; with the next larger number it takes three.
#[inline(always)]
const fn is_near(point: Point) -> bool {
    const SPAN: u32 = 2 * unsigned(NEAR);
    offset_modulo_2_32(point.x, NEAR) < SPAN
        && offset_modulo_2_32(point.y, NEAR) < SPAN
        && offset_modulo_2_32(point.z, NEAR) < SPAN
}

/// Ray from a near point. Shapes are tested against such rays.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    pub(crate) origin: Point,
    pub(crate) direction: Direction,
}

/// Ray from a point at any distance: `ray` starts at a point in steps of 2^`scale`.
#[derive(Clone, Copy, Debug)]
pub struct ScaledRay {
    pub(crate) ray: Ray,
    pub(crate) scale: u32,
}

impl ScaledRay {
    /// Creates a ray from its origin and its direction.
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

    /// Returns the origin of the ray.
    #[inline(always)]
    pub(crate) const fn from(&self) -> ScaledPoint {
        ScaledPoint {
            point: self.ray.origin,
            scale: self.scale,
        }
    }

    /// Returns the direction of the ray.
    #[inline(always)]
    pub(crate) const fn direction(&self) -> Direction {
        self.ray.direction
    }
}

/// Hashes a number to 32 bits: Fibonacci hashing, a product modulo 2³² (Knuth, The Art of Computer
/// Programming, vol. 3, 6.4).
#[inline(always)]
pub(crate) const fn spread(number: u32) -> u32 {
    product_modulo_2_32(number, 0x9e37_79b1)
}

/// Hash of what a path hits: shapes and lights. Paths with the same hits have the same signature.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PathSignature(u32);

impl PathSignature {
    /// Creates the signature of a path that has hit nothing yet. It is not 0, because notes of 0 would
    /// leave 0 unchanged.
    pub(crate) const fn new() -> Self {
        Self(1)
    }

    /// Adds what the path hits or passes to the hash. `met` is a number for it.
    #[inline(always)]
    pub(crate) fn note(&mut self, met: u32) {
        // Multiplies by 1025, in one instruction. Modulo 2³², 4 · 1024³ and 1024⁴ are 0. So different
        // paths can have the same signature if their notes differ by at least four times (1, -3, 3, -1),
        // or by (1, -4, 6, -4, 1). They cannot if they differ in only one shape or one light.
        self.0 = sum_modulo_2_32(sum_modulo_2_32(self.0, self.0 << 10), met);
    }

    /// Returns the final signature of a path. `is_bounded` says whether the whole path has known bounds; the lowest bit
    /// keeps that.
    #[inline(always)]
    pub(crate) fn ended(self, is_bounded: bool) -> Self {
        Self(self.0 << 4 | u32::from(is_bounded))
    }

    /// Returns the final signature of a path that meets the same shapes and lights, but other cells of checkers. `is_odd` says
    /// whether an odd number of borders lies between, `is_aside` whether an odd number of those along one axis does: see
    /// [`PreparedChecker::axis_aside`](crate::checker::PreparedChecker::axis_aside). The second and third lowest bits keep that.
    #[inline(always)]
    pub(crate) fn across(self, [is_odd, is_aside]: [bool; 2]) -> Self {
        Self(self.0 ^ (u32::from(is_odd) << 1 | u32::from(is_aside) << 2))
    }

    /// Returns the final signature of a path that meets small cells, if it `is_fine`: some that are less than two pixels
    /// wide. The fourth lowest bit keeps that.
    #[inline(always)]
    pub(crate) fn in_fine_cells(self, is_fine: bool) -> Self {
        Self(self.0 | u32::from(is_fine) << 3)
    }

    /// Returns whether the path meets small cells.
    pub(crate) fn is_fine(self) -> bool {
        self.0 & 8 != 0
    }

    /// Returns the mark of the path.
    pub(crate) fn mark(self) -> PathMark {
        // The two bits of the cells are added to a hash that is spread over all bits: so paths whose marks differ in these two only
        // met the same, but for a chance of 2⁻¹⁴.
        PathMark(to_u16(spread(self.0 >> 4) >> 16 ^ self.0 >> 1 & 3))
    }

    /// Tests whether the whole path has known bounds.
    #[inline(always)]
    pub(crate) fn is_bounded(self) -> bool {
        self.0 & 1 == 1
    }

    /// Tests whether two paths hit the same shapes and lights, and whether this one has known bounds. Ignores
    /// the cells of checkers.
    #[inline(always)]
    pub(crate) fn is_same_as(self, other: Self) -> bool {
        (self.0 ^ other.0) >> 4 == 0 && self.is_bounded()
    }
}

/// What a path hit, as 16 bits of its signature. Paths that hit the same have the same mark.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PathMark(u16);

impl PathMark {
    /// The mark of a path that is not known.
    pub(crate) const NONE: Self = Self(0);

    /// Tests whether two paths hit the same shapes and lights. Ignores the cells of checkers that signatures keep apart.
    pub(crate) fn meets_same(self, other: Self) -> bool {
        self.0 ^ other.0 <= 3
    }
}

#[cfg(test)]
mod tests;
