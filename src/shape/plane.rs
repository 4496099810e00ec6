//! Infinite planes.

use super::MaterialId;
use crate::number::{Length, Quotient, divide};
use crate::ray::{Path, Ray};
use crate::vector::{Direction, Point, Position};

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
    pub(crate) material: MaterialId,
}

/// The largest offset that near rays work with.
const MAX_OFFSET: i64 = 1 << 61;

impl PreparedPlane {
    /// Fills the room of a plane that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self::new(Direction::X, 0, 0, MaterialId(0));

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
            material,
        }
    }

    /// How far a near point lies along the normal from the plane, with 30 more fraction bits.
    pub(crate) const fn height(&self, point: Point) -> i64 {
        point.to_vector().dot_wide(self.normal) - self.offset
    }

    /// The distance at which the ray meets the plane, below `reach`.
    pub(crate) fn intersect(&self, ray: &Ray, reach: Length) -> Option<Length> {
        let (height, descent) = self.crossing(ray, reach)?;
        let Quotient { mantissa, exponent } = divide(height, descent);
        // Below reach, so the exponent is at most 0; -32 and less leave nothing.
        let distance = mantissa.checked_shr(-exponent as u32).unwrap_or(0);
        Some(Length::from_bits(distance as i32))
    }

    /// Whether the ray meets the plane above 0 and below `reach`; no division.
    pub(crate) fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        self.crossing(ray, reach).is_some()
    }

    /// The height above the plane and how fast the ray loses it, where it does before `reach`.
    fn crossing(&self, ray: &Ray, reach: Length) -> Option<(u64, u32)> {
        let height = self.height(ray.origin);
        let climb = ray.direction.dot(self.normal).to_bits();
        descent(height, climb)
            .filter(|&(height, descent)| height < u64::from(descent) * reach.to_bits() as u64)
    }

    /// The distance in raw steps at which a path from any place meets the plane, below 2⁶².
    pub(crate) fn intersect_far(&self, path: &Path) -> Option<u64> {
        let (height, scale) = self.height_far(path);
        let climb = path.direction.dot(self.normal).to_bits();
        let (height, descent) = descent(height, climb)?;
        let Quotient { mantissa, exponent } = divide(height, descent);
        match exponent + scale as i32 {
            down @ ..0 => Some(u64::from(mantissa.checked_shr(-down as u32).unwrap_or(0))),
            up @ 0..30 => Some(u64::from(mantissa) << up),
            _ => None,
        }
    }

    /// How far the start of a path lies along the normal from the plane, with 30 more fraction
    /// bits, and the scale this is in.
    fn height_far(&self, path: &Path) -> (i64, u32) {
        let scale = path.from.scale.max(self.far_scale);
        let along = path.from.point.to_vector().dot_wide(self.normal);
        let shifted = |value: i64, from: u32| value >> (scale - from).min(63);
        (
            shifted(along, path.from.scale) - shifted(self.far_offset, self.far_scale),
            scale,
        )
    }

    /// Whether a path meets the plane before it has gone `reach` · 2^`scale` steps; no division.
    pub(crate) fn blocks_far(&self, path: &Path, reach: Length, scale: u32) -> bool {
        let (height, height_scale) = self.height_far(path);
        let climb = path.direction.dot(self.normal).to_bits();
        let Some((height, descent)) = descent(height, climb) else {
            return false;
        };
        let limit = u128::from(descent) * reach.to_bits() as u128;
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
