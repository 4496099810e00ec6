//! Open finite cylinders without caps.
//!
//! The ray is looked at along the axis: in the plane across it the cylinder is a circle. How far
//! the ray's line passes from the axis is measured by a cross product of axis and origin, which is
//! worked out once for all rays from one point.

use super::bounded::{Bounded, LightRay, Own, Range};
use super::{Extent, MaterialId, Normaliser, SMALLEST, size_fault};
use crate::fault::Fault;
use crate::grid::Grid;
use crate::number::{
    Length, Number, high, high_positive, high_unsigned, leading_zeros, narrowed, ratio,
    reciprocal_root, scaled_by_unit, signed, square_root, unit_shift, unsigned, unsigned_wide,
    wide, wide_positive,
};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Position, Vector};

/// A cylinder as it is described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cylinder {
    /// Its middle, half way up.
    pub center: Position,
    /// Its axis, of any length but zero.
    pub axis: Position,
    /// Its radius, greater than 0.
    pub radius: Number,
    /// Its height, greater than 0.
    pub height: Number,
    /// What it is made of.
    pub material: MaterialId,
}

impl Cylinder {
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        axis: Position::ORIGIN,
        radius: Number::ZERO,
        height: Number::ZERO,
        material: MaterialId(0),
    };

    /// What is wrong with it.
    pub(crate) const fn fault(&self) -> Option<Fault> {
        if !(self.center.is_in_range() && self.axis.is_in_range()) {
            Some(Fault::Coordinate)
        } else if self.axis.magnitude() == 0 {
            Some(Fault::Axis)
        } else if let Some(fault) = size_fault(self.radius, Fault::Radius) {
            Some(fault)
        } else {
            size_fault(self.height, Fault::Height)
        }
    }

    /// A ball around it, somewhat too large.
    pub(crate) const fn extent(&self) -> Extent {
        let (radius, half_height) = (self.radius.to_bits(), self.half_height().to_bits());
        Extent {
            center: self.center,
            radius: Number::from_bits(radius + half_height),
            smallest: match radius < half_height {
                true => self.radius,
                false => self.half_height(),
            },
        }
    }

    const fn half_height(&self) -> Number {
        Number::from_bits(self.height.to_bits() / 2)
    }
}

/// A cylinder as the kernels read it: inside the ball.
#[derive(Clone, Copy, Debug)]
pub struct PreparedCylinder {
    center: Point,
    axis: Direction,
    radius: i32,
    /// (radius << lift)² · 2⁻³⁰: 2²⁸ to 2³⁰.
    lifted_square: i32,
    half_height: i32,
    /// The radius of a ball around it.
    reach: i32,
    normaliser: Normaliser,
    pub(crate) material: MaterialId,
}

/// A cylinder as the rays from one point see it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CylinderFromPoint {
    /// From the point to the middle of the cylinder.
    way: Vector,
    /// axis × way: its length along a ray is how far the ray's line passes from the axis's, times
    /// the sine of the angle between them.
    across: Vector,
    /// way · axis
    rise: i32,
}

impl CylinderFromPoint {
    /// How far from the axis the line of a ray passes, times the sine of the angle between them;
    /// below zero on one side of it.
    #[inline(always)]
    pub(crate) const fn sideways(&self, direction: Direction) -> i32 {
        self.across.dot(direction)
    }
}

/// Rays closer to the axis than this (the square of the sine is below 1/16) are measured with the
/// direction across the axis normalised.
const STEEP: i32 = 1 << 26;

impl PreparedCylinder {
    /// Fills the room of a cylinder that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self::new(
        Point::ORIGIN,
        Direction::X,
        Length::from_bits(4),
        Length::from_bits(4),
        MaterialId(0),
    );

    /// The smallest epsilon of rays inside, in steps, where the shape itself may be met next: a hit is
    /// within this of its wall.
    pub(crate) const SMALLEST_INSIDE: i32 = 16;

    /// Lays a cylinder without a fault on the grid.
    pub(crate) const fn prepare(cylinder: &Cylinder, grid: &Grid) -> Result<Self, Fault> {
        let radius = grid.length(cylinder.radius);
        let half_height = grid.length(cylinder.half_height());
        if radius.to_bits() < SMALLEST || half_height.to_bits() < SMALLEST {
            return Err(Fault::Tiny);
        }
        let Some(axis) = cylinder.axis.direction() else {
            return Err(Fault::Axis);
        };
        let center = grid.place(cylinder.center).point;
        let material = cylinder.material;
        Ok(Self::new(center, axis, radius, half_height, material))
    }

    /// Fills the room of a cylinder that a light does not see.
    pub(crate) const NOT_SEEN: CylinderFromPoint = CylinderFromPoint {
        way: Vector::ZERO,
        across: Vector::ZERO,
        rise: 0,
    };

    /// A cylinder inside the ball with a radius of at least 4 steps.
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
            normaliser,
            material,
        }
    }

    /// Its middle, the way from there to one end, and its radius.
    pub(crate) const fn capsule(&self) -> (Point, Vector, i32) {
        let half = self.half_height;
        let [x, y, z] = self.axis.components();
        let half_axis = Vector::new(
            scaled_by_unit(half, x),
            scaled_by_unit(half, y),
            scaled_by_unit(half, z),
        );
        (self.center, half_axis, self.radius)
    }

    /// The middle and the radius of a ball around it.
    #[inline(always)]
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.reach)
    }

    /// The same cylinder; whether it touches another shape is of no interest.
    pub(crate) const fn touching(self, _: bool) -> Self {
        self
    }

    /// Whether rays note on which side they pass it.
    pub(crate) const IS_SIDE_NOTED: bool = true;

    /// How many links the chain of balls has that covers the wall.
    pub(crate) const LINKS: i32 = 8;

    /// The middle and the radius of one of the balls in a chain along the axis that covers the wall.
    pub(crate) const fn link(&self, number: i32) -> (Point, i32) {
        let (center, half_axis, radius) = self.capsule();
        let step = Vector::new(
            half_axis.x / Self::LINKS,
            half_axis.y / Self::LINKS,
            half_axis.z / Self::LINKS,
        );
        let steps = 2 * number + 1 - Self::LINKS;
        let at =
            center
                .to_vector()
                .plus(Vector::new(step.x * steps, step.y * steps, step.z * steps));
        let square = unsigned_wide(wide(radius, radius)) + step.square();
        let reach = square_root(square) + Self::LINKS;
        (Point::new(at.x, at.y, at.z), reach)
    }

    /// Whether a ray from a near point passes by the ball around the cylinder.
    #[inline(always)]
    pub(crate) fn is_passed_by(&self, ray: &Ray) -> bool {
        let (center, radius) = self.ball();
        let way = ray.origin.to(center);
        way.passes_by(way.dot(ray.direction), radius)
    }

    /// As seen from a near point.
    pub(crate) const fn seen_from(&self, origin: Point) -> CylinderFromPoint {
        let way = origin.to(self.center);
        CylinderFromPoint {
            way,
            across: self.axis.crossed_with(way),
            rise: way.dot(self.axis),
        }
    }

    /// Whether a point that sees the cylinder so can tell what it hides: any can.
    pub(crate) const fn is_told(&self, _: &CylinderFromPoint) -> bool {
        true
    }

    /// The distance at which a ray meets the wall first, from outside or from inside, above `start`
    /// and below `reach`.
    #[inline(always)]
    pub(crate) fn met(
        &self,
        seen: &CylinderFromPoint,
        direction: &Direction,
        start: Length,
        reach: Length,
    ) -> Option<Length> {
        let sideways = seen.sideways(*direction);
        if self.is_beside(sideways) {
            return None;
        }
        self.met_beside(seen, direction, sideways, start, reach)
    }

    /// Whether a line that passes so far from the axis, times the sine, does not touch the endless
    /// cylinder.
    #[inline(always)]
    pub(crate) fn is_beside(&self, sideways: i32) -> bool {
        sideways.unsigned_abs() > unsigned(self.radius)
    }

    /// The same as [`PreparedCylinder::met`], for a line that passes `sideways` from the axis, times
    /// the sine.
    ///
    /// With d the direction and s the square of its sine to the axis, the distances are the roots
    /// of s t² - 2 t way · (d - (d · axis) axis) + ..., whose discriminant is r² s - (across · d)².
    /// A division is left to what lies on the wall.
    #[inline(never)]
    pub(crate) fn met_beside(
        &self,
        seen: &CylinderFromPoint,
        direction: &Direction,
        sideways: i32,
        start: Length,
        reach: Length,
    ) -> Option<Length> {
        let climb = direction.dot(self.axis);
        // All products of a number with a sign stand in one block: a sign that is extended in another
        // makes three instructions of a product.
        let steepness = climb.to_bits().abs();
        let flat = (1 << 30) - narrowed(wide_positive(steepness, steepness) >> 30);
        if flat < STEEP {
            return self.met_steeply(seen, direction, start, reach);
        }
        let lifted = sideways << self.normaliser.lift;
        let half_chord_square = high_positive(self.lifted_square, flat) - high(lifted, lifted);
        if half_chord_square < 0 {
            return None;
        }
        // The middle of the crossing and half its length, measured across the axis and times the sine.
        let ahead = seen.way.dot(*direction) - scaled_by_unit(seen.rise, climb);
        let half_chord = root_of_lifted(unsigned(half_chord_square), self.normaliser.lift);
        // How far up the axis, times the square of the sine.
        let height = wide(ahead, climb.to_bits()) + wide(seen.rise, -flat);
        let climbed = wide(half_chord, climb.to_bits());
        let limit = wide_positive(self.half_height, flat);
        [
            (ahead - half_chord, height - climbed),
            (ahead + half_chord, height + climbed),
        ]
        .into_iter()
        .find_map(|(ahead, height)| {
            if ahead <= 0 || ahead >= flat || height.abs() > limit {
                return None;
            }
            let distance = Length::from_bits(ratio(unsigned(ahead), unsigned(flat)));
            (start < distance && distance < reach).then_some(distance)
        })
    }

    /// The same for all rays, at more cost, and as exact for those almost along the axis. The direction
    /// across, d × axis, is worked out
    /// exactly and normalised, so that all bits are kept (Cychosz and Waggenspack, "Intersecting a
    /// ray with a cylinder", Graphics Gems IV).
    #[cold]
    #[inline(never)]
    pub(crate) fn met_steeply(
        &self,
        seen: &CylinderFromPoint,
        direction: &Direction,
        start: Length,
        reach: Length,
    ) -> Option<Length> {
        // |across| = sin(ray, axis) · 2^(60 - shift)
        let (across, shift) = direction.cross(self.axis)?;
        let (up, mantissa) = unit_shift(across.square());
        let root = reciprocal_root(mantissa);
        let across = Direction::lengthened(across, up, root);
        let sideways = seen.way.dot(across);
        let half_chord_square = wide(self.radius, self.radius) - wide(sideways, sideways);
        if half_chord_square < 0 {
            return None;
        }
        let half_chord = square_root(unsigned_wide(half_chord_square));
        let ahead = seen.way.dot(self.axis.crossed(across));
        let climb = direction.dot(self.axis);
        // Distances across the axis grow by 1 / sin(ray, axis) along the ray.
        let down = shift + 1 - up;
        [ahead - half_chord, ahead + half_chord]
            .into_iter()
            .find_map(|flat| {
                let distance = wide(flat, root) >> down;
                if distance <= i64::from(start.to_bits()) || distance >= i64::from(reach.to_bits())
                {
                    return None;
                }
                let distance = narrowed(distance);
                let height = scaled_by_unit(distance, climb) - seen.rise;
                (height.abs() <= self.half_height).then_some(Length::from_bits(distance))
            })
    }
}

impl Bounded for PreparedCylinder {
    type FromPoint = CylinderFromPoint;

    const IS_BALL: bool = false;

    fn outline(&self) -> (Point, Vector, i32) {
        self.capsule()
    }

    fn from_eye(&self, eye: Point) -> CylinderFromPoint {
        self.seen_from(eye)
    }

    #[inline(always)]
    fn is_in_front_of(_: &CylinderFromPoint, _: &CylinderFromPoint) -> bool {
        false
    }

    #[inline(always)]
    fn may_be_nearer(_: &CylinderFromPoint, _: Length) -> bool {
        true
    }

    fn holds(&self, _: Point) -> bool {
        false
    }

    #[inline(always)]
    fn intersect(&self, ray: &Ray, range: Range, side: &mut bool) -> Option<Length> {
        match self.is_passed_by(ray) {
            true => None,
            false => {
                let from = self.seen_from(ray.origin);
                self.intersect_from(&from, &ray.direction, range, side)
            }
        }
    }

    #[inline(always)]
    fn intersect_from(
        &self,
        from: &CylinderFromPoint,
        direction: &Direction,
        range: Range,
        side: &mut bool,
    ) -> Option<Length> {
        let sideways = from.sideways(*direction);
        if self.is_beside(sideways) {
            *side = sideways < 0;
            return None;
        }
        self.met_beside(from, direction, sideways, range.start, range.reach)
    }

    fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        let from = self.seen_from(ray.origin);
        self.met(&from, &ray.direction, Length::from_bits(0), reach)
            .is_some()
    }

    #[inline(always)]
    fn occludes<const PRECISE: bool>(
        &self,
        from: &CylinderFromPoint,
        ray: &LightRay,
        own: Own,
    ) -> bool {
        own != Own::Outside
            && self
                .met(from, &ray.direction, ray.epsilon, ray.reach)
                .is_some()
    }

    #[inline(always)]
    fn normal(&self, at: Point) -> Direction {
        let outward = self.center.to(at);
        self.normaliser
            .direction(outward.without(self.axis, outward.dot(self.axis)))
    }

    #[inline(always)]
    fn material(&self) -> MaterialId {
        self.material
    }
}

/// No less than what a root in so many steps was before it was rounded.
const fn rounded_up(root: i32) -> i32 {
    root + (root >> 24) + 2
}

/// √(`square` · 2³²) >> `lift`, for a square below 2²⁸.
#[inline(always)]
fn root_of_lifted(square: u32, lift: u32) -> i32 {
    let square = square | 1;
    let zeros = leading_zeros(square) & !1;
    let mantissa = square << zeros;
    // √mantissa · 2¹⁴
    let root = high_unsigned(mantissa, unsigned(reciprocal_root(mantissa)));
    // From a square of 2²⁸ on 2 zeros are left out; to that of a grazed narrow one there are more than
    // the root has bits.
    signed(root >> (zeros / 2 + lift - 2).min(31))
}

#[cfg(test)]
mod tests;
