//! Infinite planes.

use super::MaterialId;
use crate::fault::Fault;
use crate::grid::Grid;
use crate::number::{
    Length, Quotient, Unit, divide, magnitude, narrowed, narrowed_128, ratio, shifted, signed,
    unsigned, unsigned_wide, wide_unsigned, word_and_sign,
};
use crate::ray::{Ray, ScaledPoint, ScaledRay};
use crate::vector::{Direction, Point, Position, Vector};

/// A plane as it is described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
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
    pub(crate) const fn fault(&self) -> Option<Fault> {
        if !(self.point.is_in_range() && self.normal.is_in_range()) {
            Some(Fault::Coordinate)
        } else if self.normal.magnitude() == 0 {
            Some(Fault::Normal)
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

/// Further than any distance.
pub(crate) const NOT_MET: u64 = u64::MAX;

/// The largest offset that near rays work with.
const MAX_OFFSET: i64 = 1 << 61;

/// Where a place lies, as a plane sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// Where the normal points.
    Above,
    /// On the other side.
    Below,
    /// Within epsilon.
    Close,
    /// In the plane, as far as can be told.
    In,
}

/// How a ray comes down on a plane: the distance is the height over the descent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Approach {
    height: u32,
    /// How much height is lost a step, Q4.28.
    descent: u32,
}

impl Approach {
    /// Of what is met at a distance.
    #[inline(always)]
    pub(crate) const fn at(distance: Length) -> Self {
        Self {
            height: unsigned(distance.to_bits()),
            descent: 1 << 28,
        }
    }

    /// Whether this meets its plane before another; no division.
    #[inline(always)]
    pub(crate) const fn is_before(&self, other: &Self) -> bool {
        wide_unsigned(self.height, other.descent) < wide_unsigned(other.height, self.descent)
    }

    /// The distance, which is below 2³⁰.
    #[inline(always)]
    pub(crate) const fn distance(&self) -> Length {
        let distance = ratio(self.height, self.descent << 2);
        // Rounding may reach beyond.
        const MOST: i32 = (1 << 30) - 1;
        Length::from_bits(if distance < MOST { distance } else { MOST })
    }
}

/// Where a ray begins as a plane sees it, and where it goes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bearing {
    /// The height over the plane, within ±2³², so that only the sign may be lost.
    steps: i32,
    /// All bits the sign of the height.
    sign: i32,
    /// A quarter of the cosine to the normal, rounded down: how much height is gained a step, Q4.28.
    climb: i32,
}

impl Bearing {
    /// Of nothing.
    pub(crate) const NONE: Self = Self {
        steps: 0,
        sign: 0,
        climb: 0,
    };

    /// How the ray comes down on the plane, if it does.
    #[inline(always)]
    pub(crate) fn approach(&self) -> Option<Approach> {
        let steps = magnitude(self.steps, self.sign);
        (self.climb ^ self.sign < 0 && steps != 0).then_some(Approach {
            height: steps,
            descent: self.climb.unsigned_abs(),
        })
    }
}

impl PreparedPlane {
    /// Fills the room of a plane that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self::new(Direction::X, 0, 0, MaterialId(0));

    /// Lays a plane without a fault on the grid.
    pub(crate) const fn prepare(plane: &Plane, grid: &Grid) -> Result<Self, Fault> {
        let Some(normal) = plane.normal.direction() else {
            return Err(Fault::Normal);
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

    /// Whether the ray meets the plane above 0 and below `reach`; no division.
    pub(crate) fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        self.crossing(ray, reach).is_some()
    }

    /// The height above the plane and how fast the ray loses it, where it does before `reach`.
    fn crossing(&self, ray: &Ray, reach: Length) -> Option<(u64, u32)> {
        let height = self.height(ray.origin);
        let climb = ray.direction.dot(self.normal).to_bits();
        descent(height, climb).filter(|&(height, descent)| {
            height < u64::from(descent) * u64::from(unsigned(reach.to_bits()))
        })
    }

    /// The distance in raw steps at which a path from any place meets the plane, below 2⁶², or
    /// [`NOT_MET`].
    #[inline(never)]
    pub(crate) fn intersect_far(&self, path: &ScaledRay) -> u64 {
        let (height, scale) = self.height_far(path.from());
        let climb = path.direction().dot(self.normal).to_bits();
        // One that is zero when it is rounded down to 2⁻²⁸ is none: near rays do not meet the plane from
        // below then, and its surface would be seen from above.
        let climb = if climb >> 2 == 0 { 0 } else { climb };
        let Some((height, descent)) = descent(height, climb) else {
            return NOT_MET;
        };
        let Quotient { mantissa, exponent } = divide(height, descent);
        let exponent = exponent + signed(scale);
        match exponent < 30 {
            true => unsigned_wide(shifted(mantissa.into(), exponent.max(-63))),
            false => NOT_MET,
        }
    }

    /// How far a place lies along the normal from the plane, with 30 more fraction bits, and the
    /// scale this is in.
    fn height_far(&self, place: ScaledPoint) -> (i64, u32) {
        let scale = place.scale.max(self.far_scale);
        let along = place.point.to_vector().dot_wide(self.normal);
        let at_scale = |value: i64, from: u32| shifted(value, -signed((scale - from).min(63)));
        (
            at_scale(along, place.scale) - at_scale(self.far_offset, self.far_scale),
            scale,
        )
    }

    /// Where a place lies.
    pub(crate) fn side(&self, place: ScaledPoint, epsilon: Length) -> Side {
        let (height, scale) = self.height_far(place);
        // A few steps of the scale, for what rounding has moved.
        const IN: i64 = 4;
        let close = i64::from(epsilon.to_bits() >> scale.min(31)) + IN;
        match height >> 30 {
            steps if steps.abs() <= IN => Side::In,
            steps if steps > close => Side::Above,
            steps if steps < -close => Side::Below,
            _ => Side::Close,
        }
    }

    /// Whether a path meets the plane before it has gone `reach` · 2^`scale` steps; no division.
    pub(crate) fn blocks_far(&self, path: &ScaledRay, reach: Length, scale: u32) -> bool {
        let (height, height_scale) = self.height_far(path.from());
        let climb = path.direction().dot(self.normal).to_bits();
        let Some((height, descent)) = descent(height, climb) else {
            return false;
        };
        let limit = u128::from(descent) * u128::from(unsigned(reach.to_bits()));
        u128::from(height) << height_scale.min(60) < limit << scale.min(60)
    }
}

/// Height and rate of descent as magnitudes, where a ray at this height descends at all.
fn descent(height: i64, climb: i32) -> Option<(u64, u32)> {
    let descends = (height > 0 && climb < 0) || (height < 0 && climb > 0);
    descends.then_some((height.unsigned_abs(), climb.unsigned_abs()))
}

#[cfg(test)]
mod tests;
