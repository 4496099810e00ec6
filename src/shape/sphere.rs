//! Spheres.
//!
//! The nearest approach of the ray's line to the centre is worked out as a vector, and the
//! discriminant is r² minus its square (Haines, Günther, Akenine-Möller, "Precision Improvements
//! for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7): an error along the ray does not
//! count, so a small sphere far away keeps a clean edge.

mod from_point;
mod intersect;

pub(crate) use from_point::SphereFromPoint;

use super::bounded::{Bounded, LightRay, Own, Range};
use super::{Extent, MaterialId, Normaliser, SMALLEST, size_fault};
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{Length, Number, signed_wide, square_root, unsigned_wide, wide};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Position, Vector};

/// A sphere as it is described.
///
/// ```
/// use reflet::description::Sphere;
/// use reflet::{Material, Number, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(spheres: 1)>::new();
/// let tin = scene.add_material(Material::new([0.8; 3]))?;
/// scene.add_sphere([0, 0, 1], 0.5, tin)?;
/// let [Sphere { center, radius, material }] = *scene.description().spheres else { unreachable!() };
/// assert_eq!(center, Position::new([0.0, 0.0, 1.0]));
/// assert_eq!((radius, material), (Number::new(0.5), tin));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sphere {
    /// Its middle.
    pub center: Position,
    /// Its radius, greater than 0.
    pub radius: Number,
    /// What it is made of.
    pub material: MaterialId,
}

impl Sphere {
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        radius: Number::ZERO,
        material: MaterialId(0),
    };

    /// What is wrong with it.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !self.center.is_in_range() {
            return Some(ErrorKind::Coordinate);
        }
        size_fault(self.radius, ErrorKind::Radius)
    }

    /// A ball around it: itself.
    pub(crate) const fn extent(&self) -> Extent {
        Extent {
            center: self.center,
            radius: self.radius,
            smallest: self.radius,
        }
    }
}

/// A sphere as the kernels read it: inside the ball.
#[derive(Clone, Copy, Debug)]
pub struct PreparedSphere {
    center: Point,
    radius: i32,
    /// radius²
    square: i64,
    normaliser: Normaliser,
    pub(crate) material: MaterialId,
    /// Whether it touches or cuts another shape.
    touches: bool,
}

/// What the square of a radius over a distance is at least, in steps, where a sphere's tangents
/// tell whether a ray meets it.
const COARSEST: i32 = 128;

impl PreparedSphere {
    /// Fills the room of a sphere that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self::new(Point::ORIGIN, Length::from_bits(4), MaterialId(0));

    /// The smallest epsilon of rays inside, in steps, where the shape itself may be met next: a hit is
    /// within this of its surface.
    pub(crate) const SMALLEST_INSIDE: i32 = 8;

    /// Lays a sphere without a fault on the grid.
    pub(crate) const fn prepare(sphere: &Sphere, grid: &Grid) -> Result<Self, ErrorKind> {
        let radius = grid.length(sphere.radius);
        if radius.to_bits() < SMALLEST {
            return Err(ErrorKind::Tiny);
        }
        let center = grid.place(sphere.center).point;
        Ok(Self::new(center, radius, sphere.material))
    }

    /// Fills the room of a sphere that a light does not see.
    pub(crate) const NOT_SEEN: SphereFromPoint = SphereFromPoint {
        way: Vector::ZERO,
        tangent: i32::MAX,
    };

    /// A sphere inside the ball with a radius of at least 4 steps.
    pub(crate) const fn new(center: Point, radius: Length, material: MaterialId) -> Self {
        let raw = radius.to_bits();
        let normaliser = Normaliser::new(radius);
        Self {
            center,
            radius: raw,
            square: wide(raw, raw),
            normaliser,
            material,
            touches: false,
        }
    }

    /// The same sphere, which touches or cuts another shape, or does not.
    pub(crate) const fn touching(mut self, touches: bool) -> Self {
        self.touches = touches;
        self
    }

    /// As seen from a light at a near point.
    pub(crate) const fn seen_from_light(&self, light: Point) -> SphereFromPoint {
        self.seen_from(light)
    }

    /// Whether a point that sees the sphere so lies outside of it, and sees so much of it that the
    /// length of the tangents tells what it hides.
    ///
    /// A way along a ray is known to a few steps. At the distance D, so much of it is D / radius
    /// times as much across the ray: less than a 32nd of the radius where radius² / D is
    /// [`COARSEST`] or more.
    pub(crate) const fn is_told(&self, from: &SphereFromPoint) -> bool {
        !from.is_around() && self.square >= wide(from.tangent, COARSEST)
    }

    /// Whether a near point lies inside that is lifted by epsilon from another shape, which is not
    /// inside. No point is if the sphere touches nothing.
    #[inline(always)]
    pub(crate) const fn holds_lifted(&self, point: Point) -> bool {
        self.touches && signed_wide(point.to(self.center).square()) < self.square
    }

    /// Its middle and radius.
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.radius)
    }

    /// Whether rays note on which side they pass it.
    pub(crate) const IS_SIDE_NOTED: bool = false;

    /// How many balls cover it.
    pub(crate) const LINKS: i32 = 1;

    /// One of the balls that cover it.
    pub(crate) const fn link(&self, _: i32) -> (Point, i32) {
        self.ball()
    }

    /// As seen from a near point.
    pub(crate) const fn seen_from(&self, origin: Point) -> SphereFromPoint {
        let way = origin.to(self.center);
        let square = signed_wide(way.square()) - self.square;
        SphereFromPoint {
            way,
            tangent: if square <= 0 {
                i32::MIN
            } else {
                square_root(unsigned_wide(square))
            },
        }
    }

    /// As seen from a near point, but that no ray that meets the sphere is told otherwise by
    /// rounding: a direction is within 2⁻²⁷ of length one.
    pub(crate) const fn surely_seen_from(&self, origin: Point) -> SphereFromPoint {
        let SphereFromPoint { way, tangent } = self.seen_from(origin);
        SphereFromPoint {
            way,
            tangent: if tangent < 0 {
                tangent
            } else {
                Length::from_bits(tangent).surely_less().to_bits()
            },
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

    fn seen_from_eye(&self, eye: Point) -> SphereFromPoint {
        self.surely_seen_from(eye)
    }

    #[inline(always)]
    fn is_in_front_of(one: &SphereFromPoint, other: &SphereFromPoint) -> bool {
        one.is_in_front_of(other)
    }

    #[inline(always)]
    fn may_be_nearer(from: &SphereFromPoint, distance: Length) -> bool {
        from.is_nearer_than(distance)
    }

    fn holds(&self, point: Point) -> bool {
        self.seen_from(point).is_around()
    }

    #[inline(always)]
    fn intersect(&self, ray: &Ray, range: Range, _: &mut bool) -> Option<Length> {
        let way = ray.origin.to(self.center);
        match way.passes_by(way.dot(ray.direction), self.radius) {
            true => None,
            false => self.met(way, ray.direction, range.start, range.reach),
        }
    }

    #[inline(always)]
    fn intersect_from(
        &self,
        from: &SphereFromPoint,
        direction: &Direction,
        range: Range,
        _: &mut bool,
    ) -> Option<Length> {
        match from.may_be_met(from.nearest_approach(*direction)) {
            true => self.met(from.way(), *direction, range.start, range.reach),
            false => None,
        }
    }

    fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        self.is_on(ray, reach)
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
        self.normaliser.direction(self.center.to(at))
    }

    #[inline(always)]
    fn material(&self) -> MaterialId {
        self.material
    }
}

#[cfg(test)]
mod tests;
