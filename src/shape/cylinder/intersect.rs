//! Where a ray meets the wall of a cylinder.

use super::{CylinderFromPoint, PreparedCylinder};
use crate::number::{
    Length, high, high_positive, high_unsigned, leading_zeros, narrowed, ratio, reciprocal_root,
    scaled_by_unit, signed, square_root, unit_shift, unsigned, unsigned_wide, wide, wide_positive,
};
use crate::vector::Direction;

/// Rays closer to the axis than this (the square of the sine is below 1/16) are measured with the
/// direction across the axis normalised.
pub(super) const STEEP: i32 = 1 << 26;

impl PreparedCylinder {
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

/// √(`square` · 2³²) >> `lift`, for a square below 2²⁸.
#[inline(always)]
pub(super) fn root_of_lifted(square: u32, lift: u32) -> i32 {
    let square = square | 1;
    let zeros = leading_zeros(square) & !1;
    let mantissa = square << zeros;
    // √mantissa · 2¹⁴
    let root = high_unsigned(mantissa, unsigned(reciprocal_root(mantissa)));
    // From a square of 2²⁸ on 2 zeros are left out; to that of a grazed narrow one there are more than
    // the root has bits.
    signed(root >> (zeros / 2 + lift - 2).min(31))
}
