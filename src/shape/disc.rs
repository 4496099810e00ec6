//! Flat discs, which are seen from both sides.
//!
//! A ray meets the disc's plane where its height over it is lost. That point belongs to the disc if its
//! distance from the middle, measured as a vector, is not larger than the radius.

use super::bounded::{Bounded, LightRay, Own, Range};
use super::{Extent, MaterialId, SMALLEST, size_fault};
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{Length, Number, high, ratio, unsigned, wide_unsigned};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Position, Vector};

/// A disc as it is described.
///
/// ```
/// use reflet::description::Disc;
/// use reflet::{Material, Number, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(discs: 1)>::new();
/// let tin = scene.add_material(Material::new([0.8; 3]))?;
/// scene.add_disc([0, 0, 2], [0, 0, 1], 0.5, tin)?;
/// let [Disc { center, normal, radius, material }] = *scene.description().discs else { unreachable!() };
/// assert_eq!(center, Position::new([0.0, 0.0, 2.0]));
/// assert_eq!(normal, Position::new([0.0, 0.0, 1.0]));
/// assert_eq!((radius, material), (Number::new(0.5), tin));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Disc {
    /// Its middle.
    pub center: Position,
    /// Its normal, of any length but zero.
    pub normal: Position,
    /// Its radius, greater than 0.
    pub radius: Number,
    /// What it is made of.
    pub material: MaterialId,
}

impl Disc {
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        normal: Position::ORIGIN,
        radius: Number::ZERO,
        material: MaterialId(0),
    };

    /// What is wrong with it.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !(self.center.is_in_range() && self.normal.is_in_range()) {
            Some(ErrorKind::Coordinate)
        } else if self.normal.magnitude() == 0 {
            Some(ErrorKind::Normal)
        } else {
            size_fault(self.radius, ErrorKind::Radius)
        }
    }

    /// A ball around it.
    pub(crate) const fn extent(&self) -> Extent {
        Extent {
            center: self.center,
            radius: self.radius,
            smallest: self.radius,
        }
    }
}

/// A disc as the kernels read it: inside the ball.
#[derive(Clone, Copy, Debug)]
pub struct PreparedDisc {
    center: Point,
    normal: Direction,
    radius: i32,
    pub(crate) material: MaterialId,
}

/// A disc as rays from one point meet it.
#[derive(Clone, Copy, Debug)]
pub struct DiscFromPoint {
    /// From the point to the middle of the disc.
    way: Vector,
    /// How far the disc's plane lies from the point, along its normal.
    height: i32,
}

/// What the radius is enlarged by, in steps: rounding moves a hit by up to two along each axis, and no
/// gap shall show where the disc closes a cylinder of its radius.
const RIM: i32 = 4;

impl PreparedDisc {
    /// Fills the room of a disc that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self {
        center: Point::ORIGIN,
        normal: Direction::X,
        radius: 4,
        material: MaterialId(0),
    };

    /// Fills the room of a disc that a light does not see.
    pub(crate) const NOT_SEEN: DiscFromPoint = DiscFromPoint {
        way: Vector::ZERO,
        height: 0,
    };

    /// There is no inside: the smallest epsilon of any surface, in steps.
    pub(crate) const SMALLEST_INSIDE: i32 = 2;

    /// Whether rays note on which side they pass it.
    pub(crate) const IS_SIDE_NOTED: bool = false;

    /// How many balls cover it.
    pub(crate) const LINKS: i32 = 1;

    /// One of the balls that cover it.
    pub(crate) const fn link(&self, _: i32) -> (Point, i32) {
        self.ball()
    }

    /// Lays a disc without a fault on the grid.
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

    /// The middle and the radius of a ball around it.
    #[inline(always)]
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.radius)
    }

    /// The same disc; whether it touches another shape is of no interest.
    pub(crate) const fn touching(self, _: bool) -> Self {
        self
    }

    /// As seen from a near point.
    pub(crate) const fn seen_from(&self, point: Point) -> DiscFromPoint {
        let way = point.to(self.center);
        DiscFromPoint {
            way,
            height: way.dot(self.normal),
        }
    }

    /// As seen from a light at a near point.
    pub(crate) const fn seen_from_light(&self, light: Point) -> DiscFromPoint {
        self.seen_from(light)
    }

    /// Whether a point that sees the disc so can tell what it hides: any can.
    pub(crate) const fn is_told(&self, _: &DiscFromPoint) -> bool {
        true
    }

    /// The distance at which a ray meets the disc, above `start` and below `reach`.
    ///
    /// The height is known to a step, so the distance is known to as many steps as the ray goes for one
    /// of them, as that of a plane is.
    #[inline(never)]
    fn met(&self, from: &DiscFromPoint, direction: &Direction, range: Range) -> Option<Length> {
        let climb = direction.dot(self.normal).to_bits();
        // The ray comes nearer, and is not along the disc.
        if (climb ^ from.height) < 0 || climb == 0 {
            return None;
        }
        let (height, climb) = (from.height.unsigned_abs(), climb.unsigned_abs());
        if wide_unsigned(height, 1 << 30) >= wide_unsigned(climb, unsigned(range.reach.to_bits())) {
            return None;
        }
        let distance = Length::from_bits(ratio(height, climb));
        let aside = from.way.without(*direction, distance.to_bits());
        let is_met = range.start < distance
            && distance < range.reach
            && aside.square() <= unsigned_square(self.radius);
        is_met.then_some(distance)
    }
}

/// The square of a length.
#[inline(always)]
const fn unsigned_square(length: i32) -> u64 {
    wide_unsigned(unsigned(length), unsigned(length))
}

impl Bounded for PreparedDisc {
    type FromPoint = DiscFromPoint;
    type FromLight = DiscFromPoint;

    const IS_BALL: bool = false;
    const IS_FLAT: bool = true;

    fn outline(&self) -> (Point, Vector, i32) {
        let [x, y, z] = self.normal.components();
        let [x, y, z] = [x, y, z].map(|it| high(self.radius << 2, it.to_bits()));
        (self.center, Vector::new(x, y, z), self.radius)
    }

    fn seen_from_eye(&self, eye: Point) -> DiscFromPoint {
        self.seen_from(eye)
    }

    #[inline(always)]
    fn intersect(&self, ray: &Ray, range: Range, _: &mut bool) -> Option<Length> {
        let from = self.seen_from(ray.origin);
        match from.way.passes_by(from.way.dot(ray.direction), self.radius) {
            true => None,
            false => self.met(&from, &ray.direction, range),
        }
    }

    #[inline(always)]
    fn intersect_from(
        &self,
        from: &DiscFromPoint,
        direction: &Direction,
        range: Range,
        _: &mut bool,
    ) -> Option<Length> {
        self.met(from, direction, range)
    }

    fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        let start = Length::from_bits(0);
        let from = self.seen_from(ray.origin);
        self.met(&from, &ray.direction, Range { start, reach })
            .is_some()
    }

    #[inline(always)]
    fn occludes<const PRECISE: bool>(
        &self,
        from: &DiscFromPoint,
        ray: &LightRay,
        own: Own,
    ) -> bool {
        let range = Range {
            start: ray.epsilon,
            reach: ray.reach,
        };
        own == Own::No && self.met(from, &ray.direction, range).is_some()
    }

    #[inline(always)]
    fn normal(&self, _: Point) -> Direction {
        self.normal
    }

    #[inline(always)]
    fn material(&self) -> MaterialId {
        self.material
    }
}

#[cfg(test)]
mod tests;
