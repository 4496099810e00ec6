//! Spheres: the description, the prepared form and the tests of rays.
//!
//! A test computes the vector from the nearest point of the ray's line to the sphere's centre. The
//! discriminant is r² minus the square of that vector (Haines, Günther, Akenine-Möller, "Precision
//! Improvements for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7). An error along the ray does
//! not change the discriminant, so a small sphere far away keeps a clean edge.

mod borders;
mod from_point;
mod intersect;

pub(crate) use from_point::SphereFromPoint;

use super::bounded::{Bounded, LightRay, Own, Range};
use super::{Extent, MaterialId, Normaliser, SMALLEST, size_fault};
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{Length, Number, signed_wide, square_root, to_u8, unsigned_wide, wide};
use crate::ray::{REACH, Ray};
use crate::vector::{Direction, Point, Position, Vector};

/// Sphere as the user describes it.
///
/// ```
/// use reflet::description::Sphere;
/// use reflet::{Material, Number, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(spheres: 1)>::new();
/// let tin = scene.add_material(Material::new([0.8; 3]))?;
/// scene.add_sphere([0, 0, 1], 0.5, tin)?;
/// let [Sphere { center, radius, material, .. }] = *scene.description().spheres else { unreachable!() };
/// assert_eq!(center, Position::new([0.0, 0.0, 1.0]));
/// assert_eq!((radius, material), (Number::new(0.5), tin));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Sphere {
    /// Centre of the sphere.
    pub center: Position,
    /// Radius of the sphere in scene units, greater than 0.
    pub radius: Number,
    /// Material of the sphere.
    pub material: MaterialId,
}

impl Sphere {
    /// Placeholder for an unused slot in a list of described spheres.
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        radius: Number::ZERO,
        material: MaterialId(0),
    };

    /// Checks the sphere. Returns the first fault, or `None` if coordinates and radius are in range.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !self.center.is_in_range() {
            return Some(ErrorKind::Coordinate);
        }
        size_fault(self.radius, ErrorKind::Radius)
    }

    /// Returns the bounding ball of the sphere, which is the sphere itself.
    pub(crate) const fn extent(&self) -> Extent {
        Extent {
            center: self.center,
            radius: self.radius,
            smallest: self.radius,
        }
    }
}

/// Sphere as the kernels read it: in raw steps, inside the ball that holds all bounded shapes.
#[derive(Clone, Copy, Debug)]
pub struct PreparedSphere {
    center: Point,
    radius: i32,
    /// Square of the sphere's radius, in squared steps.
    square: i64,
    /// The parts of a [`Normaliser`], without the room between them.
    inverse: i32,
    lift: u8,
    pub(crate) material: MaterialId,
    /// Whether the sphere touches or cuts another shape.
    touches: bool,
}

/// Smallest radius² / distance of a sphere, in steps, for which the length of its tangents decides
/// whether a ray from a point at that distance hits it.
const COARSEST: i32 = 128;

impl PreparedSphere {
    /// Placeholder for an unused slot: a scene's type may allow more spheres than the scene has.
    pub(crate) const NONE: Self = Self::new(Point::ORIGIN, Length::from_bits(4), MaterialId(0));

    /// Smallest epsilon, in steps, of a ray that starts inside a sphere and may hit the same sphere
    /// next. A hit is within this distance of the sphere's surface.
    pub(crate) const SMALLEST_INSIDE: i32 = 8;

    /// Converts a checked sphere to steps of the scene's grid. Fails with [`ErrorKind::Tiny`] if the radius
    /// is below [`SMALLEST`] steps.
    pub(crate) const fn prepare(sphere: &Sphere, grid: &Grid) -> Result<Self, ErrorKind> {
        let radius = grid.length(sphere.radius);
        if radius.to_bits() < SMALLEST {
            return Err(ErrorKind::Tiny);
        }
        let center = grid.place(sphere.center).point;
        Ok(Self::new(center, radius, sphere.material))
    }

    /// Placeholder for an unused slot in a light's list of spheres. It hides nothing.
    pub(crate) const NOT_SEEN: SphereFromPoint = SphereFromPoint {
        way: Vector::ZERO,
        tangent: i32::MAX,
    };

    /// Creates a sphere from raw steps. It lies inside the ball of all bounded shapes; its radius is at
    /// least 4 steps.
    pub(crate) const fn new(center: Point, radius: Length, material: MaterialId) -> Self {
        let raw = radius.to_bits();
        let normaliser = Normaliser::new(radius);
        Self {
            center,
            radius: raw,
            square: wide(raw, raw),
            inverse: normaliser.inverse,
            lift: to_u8(normaliser.lift),
            material,
            touches: false,
        }
    }

    /// Returns the sphere with its flag set: whether it touches or cuts another shape.
    pub(crate) const fn touching(mut self, touches: bool) -> Self {
        self.touches = touches;
        self
    }

    /// Prepares the tests of rays from a light at a near point.
    pub(crate) const fn seen_from_light(&self, light: Point) -> SphereFromPoint {
        self.seen_from(light)
    }

    /// Tests whether the length of the tangents tells what the sphere hides from the point for which `from` was prepared.
    /// It does if the point lies outside of the sphere, and not too far away for the sphere's size.
    ///
    /// A distance along a ray is known to a few steps. For a sphere at the distance D, such an error
    /// becomes D / radius times as large across the ray. It stays below 1/32 of the radius if
    /// radius² / D is [`COARSEST`] or more.
    pub(crate) const fn is_told(&self, from: &SphereFromPoint) -> bool {
        !from.is_around() && self.square >= wide(from.tangent, COARSEST)
    }

    /// Tests whether `point` lies inside the sphere. `point` is near, and epsilon above the surface of
    /// another shape that is outside of the sphere. Such a point lies inside only if the sphere touches
    /// another shape.
    #[inline(always)]
    pub(crate) const fn holds_lifted(&self, point: Point) -> bool {
        self.touches && signed_wide(point.to(self.center).square()) < self.square
    }

    /// Returns the centre and the radius of the sphere, in steps.
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.radius)
    }

    /// Number of balls that together cover a sphere.
    pub(crate) const LINKS: usize = 1;

    /// Returns the ball that covers the sphere, which is the sphere itself: centre and radius in steps.
    pub(crate) const fn link(&self, _: usize) -> (Point, i32) {
        self.ball()
    }

    /// Prepares the tests of rays from a near point: the vector to the centre and the length of the
    /// tangents.
    pub(crate) const fn seen_from(&self, origin: Point) -> SphereFromPoint {
        let way = origin.to(self.center);
        let square = signed_wide(way.square()) - self.square;
        SphereFromPoint {
            way,
            tangent: if square <= 0 { i32::MIN } else { square_root(unsigned_wide(square)) },
        }
    }
}

impl Bounded for PreparedSphere {
    type FromPoint = SphereFromPoint;
    type FromLight = SphereFromPoint;

    const IS_BALL: bool = true;

    fn outline(&self) -> (Point, Vector, i32) {
        (self.center, Vector::ZERO, self.radius)
    }

    /// Reduces the length of the tangents, so that rounding never turns a hit into a miss: a direction is
    /// within 2⁻²⁷ of length one.
    fn seen_from_eye(&self, eye: Point) -> SphereFromPoint {
        let mut from = self.seen_from(eye);
        if from.tangent >= 0 {
            from.tangent = Length::from_bits(from.tangent).surely_less().to_bits();
        }
        from
    }

    /// Of two spheres, the one with the shorter tangents is in front, or about as far away.
    #[inline(always)]
    fn is_in_front_of(one: &SphereFromPoint, other: &SphereFromPoint) -> bool {
        one.tangent < other.tangent
    }

    fn holds(&self, point: Point) -> bool {
        self.seen_from(point).is_around()
    }

    #[inline(always)]
    fn intersect(&self, ray: &Ray, range: Range) -> Option<Length> {
        let way = ray.origin.to(self.center);
        if way.passes_by(ray.direction, self.radius) {
            None
        } else {
            self.met(way, ray.direction, range)
        }
    }

    #[inline(always)]
    fn intersect_from(
        &self,
        from: &SphereFromPoint,
        direction: &Direction,
        range: Range,
    ) -> Option<Length> {
        if from.may_be_met(*direction) {
            self.met(from.way, *direction, range)
        } else {
            None
        }
    }

    fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        self.is_on(ray, reach)
    }

    #[inline(always)]
    fn is_ahead(&self, ray: &Ray) -> bool {
        let way = ray.origin.to(self.center);
        !way.passes_by(ray.direction, self.radius) && self.blocks(ray, REACH)
    }

    #[inline(always)]
    fn occludes<const PRECISE: bool>(
        &self,
        from: &SphereFromPoint,
        ray: &LightRay,
        own: Own,
    ) -> bool {
        from.is_before(ray.direction, ray.reach)
            || PRECISE
                && from.may_hold_the_end(self.radius, ray.reach)
                && own == Own::No
                && self.holds_lifted(ray.end)
    }

    #[inline(always)]
    fn normal(&self, at: Point) -> Direction {
        let (lift, inverse) = (self.lift.into(), self.inverse);
        Normaliser { lift, inverse }.direction(self.center.to(at))
    }
}

#[cfg(test)]
mod tests;
