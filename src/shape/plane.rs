//! Infinite planes: the description, the prepared form and the heights of points above a plane.

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

/// Infinite plane as the user describes it.
///
/// ```
/// use reflet::description::Plane;
/// use reflet::{Material, Position, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(planes: 1)>::new();
/// let tin = scene.add_material(Material::new([0.8; 3]))?;
/// scene.add_plane([0, 0, -1], [0, 0, 2], tin)?;
/// let [Plane { point, normal, material, .. }] = *scene.description().planes else { unreachable!() };
/// assert_eq!(point, Position::new([0.0, 0.0, -1.0]));
/// assert_eq!((normal, material), (Position::new([0.0, 0.0, 2.0]), tin));
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Plane {
    /// Any point of the plane.
    pub point: Position,
    /// Normal of the plane. The vector may have any length except 0.
    pub normal: Position,
    /// Material of the plane.
    pub material: MaterialId,
}

impl Plane {
    /// Placeholder for an unused slot in a list of described planes.
    pub(crate) const NONE: Self = Self {
        point: Position::ORIGIN,
        normal: Position::ORIGIN,
        material: MaterialId(0),
    };

    /// Checks the plane. Returns the first fault, or `None` if coordinates and normal are allowed.
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

/// Plane as the kernels read it: unit normal and distance from the middle of the scene.
#[derive(Clone, Copy, Debug)]
pub struct PreparedPlane {
    pub(crate) normal: Direction,
    /// Distance of the plane from the middle of the scene along the normal, in steps with 30 fraction
    /// bits. Limited to ±2⁶¹: near rays do not reach planes that are further away.
    offset: i64,
    /// Distance of the plane without a limit: `far_offset` · 2^`far_scale`, in steps with 30 fraction
    /// bits.
    far_offset: i64,
    far_scale: u32,
    /// Shortcut for heights of near points if the plane is perpendicular to a coordinate axis.
    upright: Upright,
    pub(crate) material: MaterialId,
}

/// Whether a plane is perpendicular to a coordinate axis. Heights above such a plane are a coordinate
/// plus a constant and take no products.
///
/// For a constant plane, the compiler decides the branch. For another plane, the branch takes less time
/// than three products.
#[derive(Clone, Copy, Debug)]
enum Upright {
    /// The plane is perpendicular to `axis`. The height of a point is its coordinate, negated if
    /// `is_reversed`, plus `level`, in steps.
    Yes {
        axis: Axis,
        is_reversed: bool,
        level: i32,
    },
    /// The plane is perpendicular to no axis, or too far away.
    No,
}

/// Coordinate axis to which a plane is perpendicular.
#[derive(Clone, Copy, Debug)]
enum Axis {
    X,
    Y,
    Z,
}

impl Upright {
    /// Returns [`Self::Yes`] if the plane with this normal and offset is perpendicular to an axis and at most
    /// 2³⁰ steps from the middle of the scene. `offset` has 30 fraction bits.
    const fn new(normal: Direction, offset: i64) -> Self {
        const ONE: i32 = Unit::ONE.to_bits();
        const MOST: i64 = 1 << 30;
        let (axis, along) = match normal.raw() {
            Vector { x, y: 0, z: 0 } => (Axis::X, x),
            Vector { x: 0, y, z: 0 } => (Axis::Y, y),
            Vector { x: 0, y: 0, z } => (Axis::Z, z),
            _ => return Self::No,
        };
        // A coordinate is a whole number of steps, so the sum is rounded down as the product is.
        let level = -offset >> 30;
        if (along == ONE || along == -ONE) && level >= -MOST && level <= MOST {
            Self::Yes {
                axis,
                is_reversed: along < 0,
                level: narrowed(level),
            }
        } else {
            Self::No
        }
    }
}

/// Largest distance of a plane that near rays use, in steps with 30 fraction bits.
const MAX_OFFSET: i64 = 1 << 61;

impl PreparedPlane {
    /// Placeholder for an unused slot: a scene's type may allow more planes than the scene has.
    pub(crate) const NONE: Self = Self::new(Direction::X, 0, 0, MaterialId(0));

    /// Converts a checked plane to steps of the scene's grid.
    pub(crate) const fn prepare(plane: &Plane, grid: &Grid) -> Result<Self, ErrorKind> {
        let Some(normal) = plane.normal.direction() else {
            return Err(ErrorKind::Normal);
        };
        // Uses the rounded normal, so that the plane goes through its point exactly.
        let steps = grid.height_of(plane.point, normal);
        let bits = 128 - steps.unsigned_abs().leading_zeros();
        let scale = bits.saturating_sub(61);
        let offset = narrowed_128(steps >> scale);
        Ok(Self::new(normal, offset, scale, plane.material))
    }

    /// Creates a plane at the distance `far_offset` · 2^`far_scale` from the middle of the scene along
    /// its normal, in steps with 30 fraction bits. |`far_offset`| is at most 2⁶¹.
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

    /// Reflects a direction. `cosine` is that to `normal`, which is the plane's on one of its sides.
    #[inline(always)]
    pub(crate) fn reflected(&self, way: Direction, normal: Direction, cosine: Unit) -> Direction {
        let Direction { x, y, z } = way;
        match self.upright {
            Upright::Yes { axis: Axis::X, .. } => Direction { x: -x, ..way },
            Upright::Yes { axis: Axis::Y, .. } => Direction { y: -y, ..way },
            Upright::Yes { axis: Axis::Z, .. } => Direction { z: -z, ..way },
            Upright::No => way.reflected(normal, cosine),
        }
    }

    /// Returns the signed height of a near point above the plane, in steps with 30 fraction bits. It is
    /// positive on the side to which the normal points.
    pub(crate) const fn height(&self, point: Point) -> i64 {
        point.to_vector().dot_wide(self.normal) - self.offset
    }

    /// Returns the point of the plane that is nearest to a near point at this height.
    pub(crate) const fn foot(&self, point: Point, height: i32) -> Point {
        Point::at(point.to_vector().without(self.normal, height))
    }

    /// Returns the mirror image of a near point in the plane, moved by epsilon towards the side of the
    /// point. Rays from the point that the plane reflects seem to start there. Returns `None` unless the
    /// image is surely near.
    pub(crate) fn mirrored(&self, origin: Point, epsilon: Length) -> Option<Point> {
        let height = i32::try_from(self.height(origin) >> 30).ok()?;
        if height.unsigned_abs() > 1 << 28 {
            return None;
        }
        let lift = epsilon.to_bits() * if height < 0 { -1 } else { 1 };
        let image = origin.to_vector().without(self.normal, 2 * height - lift);
        let place = ScaledPoint::new(Point::at(image), 0);
        place.is_near().then_some(place.point)
    }

    /// Returns the height of a near ray's origin above the plane, and the height that the ray gains per
    /// step.
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
        let (coordinate, cosine) =
            if is_reversed { (-coordinate, -cosine) } else { (coordinate, cosine) };
        let steps = coordinate + level;
        Bearing {
            steps,
            sign: steps >> 31,
            climb: cosine >> 2,
        }
    }
}

/// Returns the magnitudes of a ray's height above a plane and of the height that it loses per step.
/// Returns `None` if the ray does not approach the plane.
fn descent(height: i64, climb: i32) -> Option<(u64, u32)> {
    let descends = (height > 0 && climb < 0) || (height < 0 && climb > 0);
    descends.then_some((height.unsigned_abs(), climb.unsigned_abs()))
}

#[cfg(test)]
mod tests;
