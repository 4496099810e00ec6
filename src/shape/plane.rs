//! Infinite planes.

mod approach;
mod far;

pub(crate) use approach::{Approach, Bearing};
pub(crate) use far::{NOT_MET, Side};

use super::MaterialId;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{Length, Unit, narrowed, narrowed_128, word_and_sign};
use crate::ray::{Ray, ScaledPoint};
use crate::vector::{Direction, Point, Position, Vector};

/// A plane as it is described.
///
/// ```
/// use reflet::description::Plane;
/// use reflet::{Material, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(planes: 1)>::new();
/// let tin = scene.add_material(Material::new([0.8; 3]))?;
/// scene.add_plane([0, 0, -1], [0, 0, 2], tin)?;
/// let [Plane { point, normal, material }] = *scene.description().planes else { unreachable!() };
/// assert_eq!(point, Position::new([0.0, 0.0, -1.0]));
/// assert_eq!((normal, material), (Position::new([0.0, 0.0, 2.0]), tin));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Plane {
    /// Any point of it.
    pub point: Position,
    /// Its normal, of any length but zero.
    pub normal: Position,
    /// What it is made of.
    pub material: MaterialId,
}

impl Plane {
    pub(crate) const NONE: Self = Self {
        point: Position::ORIGIN,
        normal: Position::ORIGIN,
        material: MaterialId(0),
    };

    /// What is wrong with it.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        if !(self.point.is_in_range() && self.normal.is_in_range()) {
            Some(ErrorKind::Coordinate)
        } else if self.normal.magnitude() == 0 {
            Some(ErrorKind::Normal)
        } else {
            None
        }
    }
}

/// A plane as the kernels read it.
#[derive(Clone, Copy, Debug)]
pub struct PreparedPlane {
    pub(crate) normal: Direction,
    /// normal · point in steps with 30 more fraction bits; ±2⁶¹ where it is more: too far for
    /// near rays.
    offset: i64,
    /// The same as `far_offset` · 2^`far_scale`.
    far_offset: i64,
    far_scale: u32,
    /// What takes the place of near products.
    upright: Upright,
    pub(crate) material: MaterialId,
}

/// What takes the place of products where a plane stands across an axis.
///
/// Of a plane that is a constant, the compiler knows it; of another, it is asked in less time than three
/// products take.
#[derive(Clone, Copy, Debug)]
enum Upright {
    /// Its height is a coordinate, or that reversed, and so much more.
    Yes {
        axis: Axis,
        is_reversed: bool,
        level: i32,
    },
    /// It is across none, or too far away.
    No,
}

#[derive(Clone, Copy, Debug)]
enum Axis {
    X,
    Y,
    Z,
}

impl Upright {
    const fn new(normal: Direction, offset: i64) -> Self {
        const ONE: i32 = Unit::ONE.to_bits();
        const MOST: i64 = 1 << 30;
        let (axis, along) = match normal.raw() {
            Vector { x, y: 0, z: 0 } => (Axis::X, x),
            Vector { x: 0, y, z: 0 } => (Axis::Y, y),
            Vector { x: 0, y: 0, z } => (Axis::Z, z),
            _ => return Self::No,
        };
        // The point's coordinate is a whole number of steps, so it is rounded as the product is.
        let level = -offset >> 30;
        match (along == ONE || along == -ONE) && level >= -MOST && level <= MOST {
            true => Self::Yes {
                axis,
                is_reversed: along < 0,
                level: narrowed(level),
            },
            false => Self::No,
        }
    }
}

/// The largest offset that near rays work with.
const MAX_OFFSET: i64 = 1 << 61;

impl PreparedPlane {
    /// Fills the room of a plane that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self::new(Direction::X, 0, 0, MaterialId(0));

    /// Lays a plane without a fault on the grid.
    pub(crate) const fn prepare(plane: &Plane, grid: &Grid) -> Result<Self, ErrorKind> {
        let Some(normal) = plane.normal.direction() else {
            return Err(ErrorKind::Normal);
        };
        // Of the rounded normal, so that the plane goes through its point exactly.
        let steps = grid.height_of(plane.point, normal);
        let bits = 128 - steps.unsigned_abs().leading_zeros();
        let scale = bits.saturating_sub(61);
        let offset = narrowed_128(steps >> scale);
        Ok(Self::new(normal, offset, scale, plane.material))
    }

    /// A plane at `far_offset` · 2^`far_scale` along its normal, in steps with 30 more fraction
    /// bits; |`far_offset`| is at most 2⁶¹.
    pub(crate) const fn new(
        normal: Direction,
        far_offset: i64,
        far_scale: u32,
        material: MaterialId,
    ) -> Self {
        let offset = if far_scale == 0 {
            far_offset
        } else if far_offset < 0 {
            -MAX_OFFSET
        } else {
            MAX_OFFSET
        };
        Self {
            normal,
            offset,
            far_offset,
            far_scale,
            upright: Upright::new(normal, offset),
            material,
        }
    }

    /// How far a near point lies along the normal from the plane, with 30 more fraction bits.
    pub(crate) const fn height(&self, point: Point) -> i64 {
        point.to_vector().dot_wide(self.normal) - self.offset
    }

    /// Where the rays that this plane mirrors seem to come from: a near point mirrored in it, and
    /// lifted by epsilon to the side it was on. `None` where that is not near for sure.
    pub(crate) fn mirrored(&self, origin: Point, epsilon: Length) -> Option<Point> {
        let height = i32::try_from(self.height(origin) >> 30).ok()?;
        if height.unsigned_abs() > 1 << 28 {
            return None;
        }
        let lift = epsilon.to_bits() * if height < 0 { -1 } else { 1 };
        let Vector { x, y, z } = origin.to_vector().without(self.normal, 2 * height - lift);
        let place = ScaledPoint::new(Point::new(x, y, z), 0);
        place.is_near().then_some(place.point)
    }

    /// Where a ray begins as the plane sees it, and where it goes.
    #[inline(always)]
    pub(crate) fn bearing(&self, ray: &Ray) -> Bearing {
        let Ray { origin, direction } = ray;
        let Upright::Yes {
            axis,
            is_reversed,
            level,
        } = self.upright
        else {
            let (steps, sign) = word_and_sign(self.height(*origin) >> 30);
            return Bearing {
                steps,
                sign,
                climb: direction.raw().quarter_dot(self.normal),
            };
        };
        let (coordinate, cosine) = match axis {
            Axis::X => (origin.x, direction.x.to_bits()),
            Axis::Y => (origin.y, direction.y.to_bits()),
            Axis::Z => (origin.z, direction.z.to_bits()),
        };
        let (coordinate, cosine) = match is_reversed {
            true => (-coordinate, -cosine),
            false => (coordinate, cosine),
        };
        let steps = coordinate + level;
        Bearing {
            steps,
            sign: steps >> 31,
            climb: cosine >> 2,
        }
    }

    /// The distance at which the ray meets the plane, below `reach`.
    #[cfg(test)]
    pub(crate) fn intersect(&self, ray: &Ray, reach: Length) -> Option<Length> {
        let approach = self.bearing(ray).approach()?;
        approach
            .is_before(&Approach::at(reach))
            .then(|| approach.distance())
    }
}

/// Height and rate of descent as magnitudes, where a ray at this height descends at all.
fn descent(height: i64, climb: i32) -> Option<(u64, u32)> {
    let descends = (height > 0 && climb < 0) || (height < 0 && climb > 0);
    descends.then_some((height.unsigned_abs(), climb.unsigned_abs()))
}

#[cfg(test)]
mod tests;
