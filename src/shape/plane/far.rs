//! Tests of planes against points and rays at any distance from the middle of the scene.

use super::{PreparedPlane, descent};
use crate::number::{
    Length, Quotient, divide, shifted, signed, unsigned, unsigned_wide, wide_unsigned,
};
use crate::ray::{ScaledPoint, ScaledRay};

/// Distance of a ray that does not hit a plane; larger than any real distance.
pub(crate) const NOT_MET: u64 = u64::MAX;

/// Side of a plane on which a point lies.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Side {
    /// On the side to which the normal points, by more than epsilon.
    Above,
    /// On the side away from the normal, by more than epsilon.
    Below,
    /// Within epsilon of the plane, on either side.
    Close,
    /// In the plane, within rounding.
    In,
}

impl PreparedPlane {
    /// Returns the distance in raw steps, below 2⁶², at which a ray from any point hits the plane, or
    /// [`NOT_MET`].
    #[inline(never)]
    pub(crate) fn intersect_far(&self, path: &ScaledRay) -> u64 {
        let Some(((height, descent), scale)) = self.approach_far(path) else {
            return NOT_MET;
        };
        let Quotient { mantissa, exponent } = divide(height, descent);
        let exponent = exponent + signed(scale);
        if exponent < 30 {
            unsigned_wide(shifted(mantissa.into(), exponent.max(-63)))
        } else {
            NOT_MET
        }
    }

    /// Returns ((h, d), s) for a ray from any point: it starts h · 2^(s - 30) steps from the plane, and each step
    /// along it leads d · 2⁻³⁰ steps nearer. Returns `None` if the ray does not hit the plane.
    #[inline(always)]
    pub(crate) fn approach_far(&self, path: &ScaledRay) -> Option<((u64, u32), u32)> {
        let (height, scale) = self.height_far(path.from());
        let climb = path.direction().dot(self.normal).to_bits();
        // A cosine that becomes 0 when it is rounded down to 2⁻²⁸ counts as 0. Near rays do the same, so
        // they do not hit the plane from below. If this ray did, the surface would be shaded from above.
        let climb = if climb >> 2 == 0 { 0 } else { climb };
        Some((descent(height, climb)?, scale))
    }

    /// Returns the signed height of a point above the plane and the scale of that height.
    /// The result (h, s) means h · 2^(s - 30) steps.
    fn height_far(&self, place: ScaledPoint) -> (i64, u32) {
        let scale = place.scale.max(self.far_scale);
        let along = place.point.to_vector().dot_wide(self.normal);
        let at_scale = |value: i64, from: u32| {
            if scale == from {
                value
            } else {
                shifted(value, -signed((scale - from).min(63)))
            }
        };
        (
            at_scale(along, place.scale) - at_scale(self.far_offset, self.far_scale),
            scale,
        )
    }

    /// Returns on which side of the plane a point lies. Points within `epsilon` of the plane are
    /// [`Side::Close`].
    pub(crate) fn side(&self, place: ScaledPoint, epsilon: Length) -> Side {
        let (height, scale) = self.height_far(place);
        // Rounding may move a point by a few steps of its scale.
        const IN: i64 = 4;
        let close = i64::from(epsilon.to_bits() >> scale.min(31)) + IN;
        match height >> 30 {
            steps if steps.abs() <= IN => Side::In,
            steps if steps > close => Side::Above,
            steps if steps < -close => Side::Below,
            _ => Side::Close,
        }
    }

    /// Tests whether a ray from any point hits the plane within `reach` · 2^`scale` steps. Takes no
    /// division.
    pub(crate) fn blocks(&self, path: &ScaledRay, reach: Length, scale: u32) -> bool {
        let (height, height_scale) = self.height_far(path.from());
        let climb = path.direction().dot(self.normal).to_bits();
        let Some((height, descent)) = descent(height, climb) else {
            return false;
        };
        let limit = wide_unsigned(descent, unsigned(reach.to_bits()));
        // Both sides are whole numbers. So the one that is not shifted may be rounded instead.
        let (own, other) = (height_scale.min(60), scale.min(60));
        if own > other {
            limit > 0 && height <= (limit - 1) >> (own - other)
        } else {
            height >> (other - own) < limit
        }
    }
}
