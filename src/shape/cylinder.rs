//! Open finite cylinders without caps.
//!
//! A test works in the plane perpendicular to the axis, where the cylinder is a circle. The distance
//! between the ray's line and the axis comes from a cross product of the axis and the vector to the
//! centre. The product is computed once for all rays from one point.

mod borders;
mod from_point;
mod intersect;

pub(crate) use from_point::{CylinderFromLight, CylinderFromPoint};

use super::bounded::{Bounded, LightRay, Own, Range};
use super::{Extent, MaterialId, Normaliser, SMALLEST, size_fault};
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{
    Length, Number, narrowed, signed, square_root, to_u8, to_u32, unsigned_wide, wide,
};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Position, Vector};

/// Open cylinder without caps, as the user describes it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Cylinder {
    /// Centre of the cylinder, on the axis at half the height.
    pub center: Position,
    /// Direction of the axis. The vector may have any length except 0.
    pub axis: Position,
    /// Radius of the cylinder in scene units, greater than 0.
    pub radius: Number,
    /// Height of the cylinder in scene units, greater than 0.
    pub height: Number,
    /// Material of the cylinder.
    pub material: MaterialId,
}

impl Cylinder {
    /// Placeholder for an unused slot in a list of described cylinders.
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        axis: Position::ORIGIN,
        radius: Number::ZERO,
        height: Number::ZERO,
        material: MaterialId(0),
    };

    /// Checks the cylinder. Returns its first fault, or `None` if all fields are allowed.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !(self.center.is_in_range() && self.axis.is_in_range()) {
            Some(ErrorKind::Coordinate)
        } else if self.axis.magnitude() == 0 {
            Some(ErrorKind::Axis)
        } else if let Some(fault) = size_fault(self.radius, ErrorKind::Radius) {
            Some(fault)
        } else {
            size_fault(self.height, ErrorKind::Height)
        }
    }

    /// Returns a bounding ball of the cylinder, somewhat too large: its radius is radius + half height.
    pub(crate) const fn extent(&self) -> Extent {
        let (radius, half_height) = (self.radius.to_bits(), self.half_height().to_bits());
        Extent {
            center: self.center,
            radius: Number::from_bits(radius + half_height),
            smallest: if radius < half_height { self.radius } else { self.half_height() },
        }
    }

    /// Returns half of the cylinder's height, in scene units.
    const fn half_height(&self) -> Number {
        Number::from_bits(self.height.to_bits() / 2)
    }
}

/// Cylinder as the kernels read it: in raw steps, inside the ball that holds all bounded shapes.
#[derive(Clone, Copy, Debug)]
pub struct PreparedCylinder {
    center: Point,
    axis: Direction,
    radius: i32,
    /// Square of the radius lifted as in a [`Normaliser`]: (radius << lift)² · 2⁻³⁰, from 2²⁸ to 2³⁰.
    lifted_square: i32,
    half_height: i32,
    /// Radius of a ball around the cylinder, in steps.
    reach: i32,
    /// The parts of a [`Normaliser`], without the room between them.
    inverse: i32,
    lift: u8,
    pub(crate) material: MaterialId,
}

impl PreparedCylinder {
    /// Placeholder for an unused slot: a scene's type may allow more cylinders than the scene has.
    pub(crate) const NONE: Self = Self::new(
        Point::ORIGIN,
        Direction::X,
        Length::from_bits(4),
        Length::from_bits(4),
        MaterialId(0),
    );

    /// Smallest epsilon, in steps, of a ray that starts inside a cylinder and may hit the same cylinder
    /// next. A hit is within this distance of the cylinder's wall.
    pub(crate) const SMALLEST_INSIDE: i32 = 16;

    /// Converts a checked cylinder to steps of the scene's grid. Fails with [`ErrorKind::Tiny`] if the
    /// radius or the half height is below [`SMALLEST`] steps.
    pub(crate) const fn prepare(cylinder: &Cylinder, grid: &Grid) -> Result<Self, ErrorKind> {
        let radius = grid.length(cylinder.radius);
        let half_height = grid.length(cylinder.half_height());
        if radius.to_bits() < SMALLEST || half_height.to_bits() < SMALLEST {
            return Err(ErrorKind::Tiny);
        }
        let Some(axis) = cylinder.axis.direction() else {
            return Err(ErrorKind::Axis);
        };
        let center = grid.place(cylinder.center).point;
        let material = cylinder.material;
        Ok(Self::new(center, axis, radius, half_height, material))
    }

    /// Placeholder for an unused slot in a light's list of cylinders. It hides nothing.
    pub(crate) const NOT_SEEN: CylinderFromLight = CylinderFromLight {
        from: CylinderFromPoint {
            way: Vector::ZERO,
            across: Vector::ZERO,
            rise: 0,
        },
        nearest: i32::MAX,
    };

    /// Creates a cylinder from raw steps. It lies inside the ball of all bounded shapes; its radius is
    /// at least 4 steps.
    pub(crate) const fn new(
        center: Point,
        axis: Direction,
        radius: Length,
        half_height: Length,
        material: MaterialId,
    ) -> Self {
        let normaliser = Normaliser::new(radius);
        let lifted = radius.to_bits() << normaliser.lift;
        let outline = Vector::new(radius.to_bits(), half_height.to_bits(), 0);
        Self {
            center,
            axis,
            radius: radius.to_bits(),
            lifted_square: narrowed(wide(lifted, lifted) >> 30),
            half_height: half_height.to_bits(),
            reach: rounded_up(square_root(outline.square())),
            inverse: normaliser.inverse,
            lift: to_u8(normaliser.lift),
            material,
        }
    }

    /// Returns the centre, the vector from there to one end of the axis, and the radius, in steps.
    pub(crate) const fn capsule(&self) -> (Point, Vector, i32) {
        let half_axis = self.axis.raw_times(self.half_height);
        (self.center, half_axis, self.radius)
    }

    /// Returns centre and radius, in steps, of a ball around the cylinder.
    #[inline(always)]
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.reach)
    }

    /// Returns the cylinder unchanged. Its tests do not depend on whether it touches another shape.
    pub(crate) const fn touching(self, _: bool) -> Self {
        self
    }

    /// Number of balls in the chain that covers the wall of a cylinder.
    pub(crate) const LINKS: usize = 8;

    /// Returns centre and radius, in steps, of one ball of a chain along the axis. All [`Self::LINKS`]
    /// balls together cover the cylinder's wall. `number` counts from 0.
    pub(crate) const fn link(&self, number: usize) -> (Point, i32) {
        let [number, links] = [signed(to_u32(number)), signed(to_u32(Self::LINKS))];
        let (center, half_axis, radius) = self.capsule();
        let step = Vector::new(
            half_axis.x / links,
            half_axis.y / links,
            half_axis.z / links,
        );
        let steps = 2 * number + 1 - links;
        let at =
            center
                .to_vector()
                .plus(Vector::new(step.x * steps, step.y * steps, step.z * steps));
        let square = unsigned_wide(wide(radius, radius)) + step.square();
        let reach = square_root(square) + links;
        (Point::at(at), reach)
    }
}

impl Bounded for PreparedCylinder {
    type FromPoint = CylinderFromPoint;
    type FromLight = CylinderFromLight;

    const IS_BALL: bool = false;

    fn outline(&self) -> (Point, Vector, i32) {
        self.capsule()
    }

    fn seen_from_eye(&self, eye: Point) -> CylinderFromPoint {
        self.seen_from(eye)
    }

    #[inline(always)]
    fn intersect(&self, ray: &Ray, range: Range) -> Option<Length> {
        if self.is_passed_by(ray) {
            None
        } else {
            let from = self.seen_from(ray.origin);
            self.intersect_from(&from, &ray.direction, range)
        }
    }

    #[inline(always)]
    fn intersect_from(
        &self,
        from: &CylinderFromPoint,
        direction: &Direction,
        range: Range,
    ) -> Option<Length> {
        let sideways = from.sideways(*direction);
        if self.is_beside(sideways) {
            return None;
        }
        self.met_beside(from, direction, sideways, range)
    }

    #[inline(always)]
    fn occludes<const PRECISE: bool>(
        &self,
        from: &CylinderFromLight,
        ray: &LightRay,
        own: Own,
    ) -> bool {
        if own == Own::Outside || from.nearest >= ray.reach.to_bits() {
            return false;
        }
        // A copy, since the address of the ray's own direction would keep the ray in memory.
        let direction = ray.direction;
        let met = self.intersect_from(&from.from, &direction, ray.range());
        met.is_some()
    }

    #[inline(always)]
    fn normal(&self, at: Point) -> Direction {
        let outward = self.center.to(at);
        let (lift, inverse) = (self.lift.into(), self.inverse);
        let across = outward.without(self.axis, outward.dot(self.axis));
        Normaliser { lift, inverse }.direction(across)
    }
}

/// Returns an upper bound of a square root, in steps, given the rounded root.
const fn rounded_up(root: i32) -> i32 {
    root + (root >> 24) + 2
}

#[cfg(test)]
mod tests;
