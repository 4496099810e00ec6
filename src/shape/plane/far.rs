//! What a plane is to places of any distance.

use super::{PreparedPlane, descent};
use crate::number::{Length, Quotient, divide, shifted, signed, unsigned, unsigned_wide};
use crate::ray::{ScaledPoint, ScaledRay};

/// Further than any distance.
pub(crate) const NOT_MET: u64 = u64::MAX;

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

impl PreparedPlane {
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
    pub(crate) fn blocks(&self, path: &ScaledRay, reach: Length, scale: u32) -> bool {
        let (height, height_scale) = self.height_far(path.from());
        let climb = path.direction().dot(self.normal).to_bits();
        let Some((height, descent)) = descent(height, climb) else {
            return false;
        };
        let limit = u128::from(descent) * u128::from(unsigned(reach.to_bits()));
        u128::from(height) << height_scale.min(60) < limit << scale.min(60)
    }
}
