//! Flat discs, which are visible from both sides.
//!
//! A ray hits the disc's plane where its height above the plane becomes 0. That point lies on the disc
//! if its distance from the centre, computed as a vector, is not larger than the radius.

mod borders;

use super::bordered::square;
use super::bounded::{Bounded, LightRay, Own, Range};
use super::flat::FlatFromPoint;
use super::{Extent, MaterialId, SMALLEST, size_fault};
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{Length, Number, ratio, unsigned, wide_unsigned};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Position, Vector};

/// Flat disc as the user describes it.
///
/// ```
/// use reflet::description::Disc;
/// use reflet::{Material, Number, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(discs: 1)>::new();
/// let tin = scene.add_material(Material::new([0.8; 3]))?;
/// scene.add_disc([0, 0, 2], [0, 0, 1], 0.5, tin)?;
/// let [Disc { center, normal, radius, material, .. }] = *scene.description().discs else { unreachable!() };
/// assert_eq!(center, Position::new([0.0, 0.0, 2.0]));
/// assert_eq!(normal, Position::new([0.0, 0.0, 1.0]));
/// assert_eq!((radius, material), (Number::new(0.5), tin));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Disc {
    /// Centre of the disc.
    pub center: Position,
    /// Normal of the disc. The vector may have any length except 0.
    pub normal: Position,
    /// Radius of the disc in scene units, greater than 0.
    pub radius: Number,
    /// Material of the disc.
    pub material: MaterialId,
}

impl Disc {
    /// Placeholder for an unused slot in a list of described discs.
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        normal: Position::ORIGIN,
        radius: Number::ZERO,
        material: MaterialId(0),
    };

    /// Checks the disc. Returns the first fault, or `None` if coordinates, normal and radius are
    /// allowed.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !(self.center.is_in_range() && self.normal.is_in_range()) {
            Some(ErrorKind::Coordinate)
        } else if self.normal.magnitude() == 0 {
            Some(ErrorKind::Normal)
        } else {
            size_fault(self.radius, ErrorKind::Radius)
        }
    }

    /// Returns the bounding ball of the disc, which has the same centre and radius.
    pub(crate) const fn extent(&self) -> Extent {
        Extent {
            center: self.center,
            radius: self.radius,
            smallest: self.radius,
        }
    }
}

/// Disc as the kernels read it: in raw steps, inside the ball that holds all bounded shapes.
#[derive(Clone, Copy, Debug)]
pub struct PreparedDisc {
    center: Point,
    normal: Direction,
    radius: i32,
    pub(crate) material: MaterialId,
}

/// Enlargement of a disc's radius, in steps. Rounding moves a hit by up to two steps along each axis.
/// Without the enlargement, a gap could show where a disc closes a cylinder of the same radius.
const RIM: i32 = 4;

impl PreparedDisc {
    /// Placeholder for an unused slot: a scene's type may allow more discs than the scene has.
    pub(crate) const NONE: Self = Self {
        center: Point::ORIGIN,
        normal: Direction::X,
        radius: 4,
        material: MaterialId(0),
    };

    /// Placeholder for an unused slot in a light's list of discs. It hides nothing.
    pub(crate) const NOT_SEEN: FlatFromPoint = FlatFromPoint::NONE;

    /// Smallest epsilon of a ray that leaves a disc, in steps. A disc has no inside, so this is the
    /// smallest epsilon of any surface.
    pub(crate) const SMALLEST_INSIDE: i32 = 2;

    /// Number of balls that together cover a disc.
    pub(crate) const LINKS: usize = 1;

    /// Returns centre and radius, in steps, of the ball that covers the disc.
    pub(crate) const fn link(&self, _: usize) -> (Point, i32) {
        self.ball()
    }

    /// Converts a checked disc to steps of the scene's grid. Fails with [`ErrorKind::Tiny`] if the radius is
    /// below [`SMALLEST`] steps.
    pub(crate) const fn prepare(disc: &Disc, grid: &Grid) -> Result<Self, ErrorKind> {
        let radius = grid.length(disc.radius);
        if radius.to_bits() < SMALLEST {
            return Err(ErrorKind::Tiny);
        }
        let Some(normal) = disc.normal.direction() else {
            return Err(ErrorKind::Normal);
        };
        Ok(Self {
            center: grid.place(disc.center).point,
            normal,
            radius: radius.to_bits() + RIM,
            material: disc.material,
        })
    }

    /// Returns centre and radius, in steps, of a ball around the disc.
    #[inline(always)]
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.radius)
    }

    /// Returns the disc unchanged. Its tests do not depend on whether it touches another shape.
    pub(crate) const fn touching(self, _: bool) -> Self {
        self
    }

    /// Prepares the tests of rays from a near point against the disc.
    pub(crate) const fn seen_from(&self, point: Point) -> FlatFromPoint {
        FlatFromPoint::new(point, self.center, self.normal)
    }

    /// Prepares the tests of rays from a light at a near point against the disc.
    pub(crate) const fn seen_from_light(&self, light: Point) -> FlatFromPoint {
        self.seen_from(light)
    }

    /// Returns the distance at which a ray hits the disc, within `range`. `from` was prepared for the
    /// ray's origin.
    ///
    /// The height above the disc's plane is known to one step. So the error of the distance is the
    /// distance in which the ray loses one step of height, as for a plane.
    #[inline(never)]
    fn met(&self, from: &FlatFromPoint, direction: &Direction, range: Range) -> Option<Length> {
        let climb = direction.dot(self.normal).to_bits();
        // A ray that hits the disc approaches its plane and is not parallel to it.
        if (climb ^ from.height) < 0 || climb == 0 {
            return None;
        }
        let (height, climb) = (from.height.unsigned_abs(), climb.unsigned_abs());
        // A light within epsilon of a surface leaves a reach below 0.
        let reach = unsigned(range.reach.to_bits().max(0));
        if wide_unsigned(height, 1 << 30) >= wide_unsigned(climb, reach) {
            return None;
        }
        let distance = Length::from_bits(ratio(height, climb));
        let aside = from.way.without(*direction, distance.to_bits());
        let is_met = range.holds(distance) && aside.square() <= square(self.radius);
        is_met.then_some(distance)
    }
}

impl Bounded for PreparedDisc {
    type FromPoint = FlatFromPoint;
    type FromLight = FlatFromPoint;

    const IS_BALL: bool = false;
    const IS_FLAT: bool = true;

    fn outline(&self) -> (Point, Vector, i32) {
        (self.center, Vector::ZERO, self.radius)
    }

    fn seen_from_eye(&self, eye: Point) -> FlatFromPoint {
        self.seen_from(eye)
    }

    #[inline(always)]
    fn intersect(&self, ray: &Ray, range: Range) -> Option<Length> {
        let from = self.seen_from(ray.origin);
        if from.way.passes_by(ray.direction, self.radius) {
            None
        } else {
            self.met(&from, &ray.direction, range)
        }
    }

    #[inline(always)]
    fn intersect_from(
        &self,
        from: &FlatFromPoint,
        direction: &Direction,
        range: Range,
    ) -> Option<Length> {
        self.met(from, direction, range)
    }

    #[inline(always)]
    fn occludes<const PRECISE: bool>(
        &self,
        from: &FlatFromPoint,
        ray: &LightRay,
        own: Own,
    ) -> bool {
        // A copy, as for cylinders.
        let direction = ray.direction;
        own == Own::No && self.met(from, &direction, ray.range()).is_some()
    }

    #[inline(always)]
    fn normal(&self, _: Point) -> Direction {
        self.normal
    }
}

#[cfg(test)]
mod tests;
