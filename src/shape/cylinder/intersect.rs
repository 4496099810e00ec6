//! Hits of a ray on the wall of a cylinder.

use super::{CylinderFromPoint, PreparedCylinder};
use crate::number::{
    Length, high, high_positive, high_unsigned, leading_zeros, narrowed, ratio, reciprocal_root,
    scaled_by_unit, signed, square_root, unit_shift, unsigned, unsigned_wide, wide, wide_positive,
};
use crate::ray::Ray;
use crate::shape::bounded::Range;
use crate::vector::Direction;

/// Square of the sine of the angle between ray and axis, Q2.30, below which a ray counts as almost
/// parallel to the axis: 1/16. [`PreparedCylinder::met_steeply`] tests such rays: it normalises the
/// direction across the axis.
pub(super) const STEEP: i32 = 1 << 26;

impl PreparedCylinder {
    /// Tests whether a ray from a near point misses the ball around the cylinder.
    #[inline(always)]
    pub(crate) fn is_passed_by(&self, ray: &Ray) -> bool {
        let (center, radius) = self.ball();
        ray.origin.to(center).passes_by(ray.direction, radius)
    }

    /// Tests whether the line of a ray surely misses the infinite cylinder. `sideways` is the distance
    /// between the lines of ray and axis, times the sine of the angle between them. If that exceeds the
    /// radius, the distance does so too.
    #[inline(always)]
    pub(crate) fn is_beside(&self, sideways: i32) -> bool {
        sideways.unsigned_abs() > unsigned(self.radius)
    }

    /// Returns the distance at which a ray first hits the wall, from outside or from inside, within `range`.
    /// `sideways` is the distance between the lines of ray and axis, times the sine of the angle between
    /// them.
    ///
    /// With d the direction and s the square of the sine between d and the axis, the distances t are the
    /// roots of s t² - 2 t way · (d - (d · axis) axis) + .... The discriminant is r² s - (across · d)².
    /// Only a root that lies on the wall takes a division.
    #[inline(never)]
    pub(crate) fn met_beside(
        &self,
        seen: &CylinderFromPoint,
        direction: &Direction,
        sideways: i32,
        range: Range,
    ) -> Option<Length> {
        let climb = direction.dot(self.axis);
        // All products of signed numbers stand in one block: if a sign is extended in another block, the
        // compiler makes three instructions of one product.
        let steepness = climb.to_bits().abs();
        let flat = (1 << 30) - narrowed(wide_positive(steepness, steepness) >> 30);
        if flat < STEEP {
            return self.met_steeply(seen, direction, range);
        }
        let lifted = sideways << self.lift;
        let half_chord_square = high_positive(self.lifted_square, flat) - high(lifted, lifted);
        if half_chord_square < 0 {
            return None;
        }
        // Middle and half length of the chord inside the cylinder, measured perpendicular to the axis,
        // times the sine.
        let ahead = seen.way.dot(*direction) - scaled_by_unit(seen.rise, climb);
        let half_chord = root_of_lifted(unsigned(half_chord_square), self.lift.into());
        // Height of the chord's middle along the axis, times the square of the sine.
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
            range.holds(distance).then_some(distance)
        })
    }

    /// Returns the distance at which a ray first hits the wall, within `range`. Rays almost parallel to the axis get the same precision as others. It works for all rays but costs
    /// more than [`PreparedCylinder::met_beside`].
    ///
    /// The direction across, d × axis, is computed exactly and normalised, which keeps all bits (Cychosz
    /// and Waggenspack, "Intersecting a ray with a cylinder", Graphics Gems IV).
    #[cold]
    #[inline(never)]
    pub(crate) fn met_steeply(
        &self,
        seen: &CylinderFromPoint,
        direction: &Direction,
        range: Range,
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
                let [start, reach] = [range.start, range.reach].map(|it| i64::from(it.to_bits()));
                if distance <= start || distance >= reach {
                    return None;
                }
                let distance = narrowed(distance);
                let height = scaled_by_unit(distance, climb) - seen.rise;
                (height.abs() <= self.half_height).then_some(Length::from_bits(distance))
            })
    }
}

/// Returns √(`square` · 2³²) >> `lift`, for a `square` below 2²⁸.
#[inline(always)]
pub(super) fn root_of_lifted(square: u32, lift: u32) -> i32 {
    let square = square | 1;
    let zeros = leading_zeros(square) & !1;
    let mantissa = square << zeros;
    // √mantissa · 2¹⁴
    let root = high_unsigned(mantissa, unsigned(reciprocal_root(mantissa)));
    // `root` has the scale 2¹⁴ and the result 2¹⁶, so two shifts fewer are needed; a square below 2²⁸
    // has that many. A ray that grazes a narrow cylinder would need more shifts than the root has bits.
    signed(root >> (zeros / 2 + lift - 2).min(31))
}
