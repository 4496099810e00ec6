//! Where a ray hits a triangle.
//!
//! A line along d passes the side from a to b on the side that the sign of (d × a) · (b - a) tells; a and b are seen
//! from the ray's origin. It hits the triangle if all three signs are alike or 0 (Möller and Trumbore, "Fast, Minimum
//! Storage Ray/Triangle Intersection", 1997; the sides are tested as by Woop, Benthin and Wald, "Watertight
//! Ray/Triangle Intersection", 2013). The products are integers, so the signs are exact and do not depend on the
//! triangle that asks.

use super::PreparedTriangle;
use crate::number::{Length, narrowed, ratio, unsigned, wide_unsigned};
use crate::shape::bounded::Range;
use crate::shape::flat::FlatFromPoint;
use crate::vector::{Direction, Vector};

/// Cosine, Q2.30, below which the distance may lie beside the triangle: 2⁻¹⁰.
const GRAZING: i32 = 1 << 20;

/// A cosine below this many units of 2⁻³⁰, or a height below this many steps, may have the wrong sign.
const UNSURE: i32 = 8;

/// Returns a number whose sign says on which side of a side of the triangle the ray's line passes; 0 if the
/// line cuts it. `side` starts at the corner to which `way` leads. `across` is the cross product of the ray's
/// direction and `way`, in steps.
///
/// Each coordinate of the cross product is rounded down by less than 1.
#[inline(always)]
fn passes(across: Vector, side: Vector, ray: (&Direction, Vector)) -> i64 {
    let high = across.dot_raw(side);
    let most = side.x.unsigned_abs() + side.y.unsigned_abs() + side.z.unsigned_abs();
    if high.unsigned_abs() > u64::from(most) {
        high
    } else {
        with_fractions(high, side, ray)
    }
}

/// Returns what [`passes`] returns, from the high words and what they leave out.
#[cold]
#[inline(never)]
fn with_fractions(high: i64, side: Vector, (direction, way): (&Direction, Vector)) -> i64 {
    const FRACTION: i64 = (1 << 30) - 1;
    let low = |product: i64| narrowed(product & FRACTION);
    let [x, y, z] = direction.raw().cross_wide(way).map(low);
    let sum = Vector::new(x, y, z).dot_raw(side);
    match high + (sum >> 30) {
        0 => i64::from(sum & FRACTION != 0),
        rounded_down => rounded_down,
    }
}

impl PreparedTriangle {
    /// Returns the distance at which a ray hits the triangle, within `range`. `from` was prepared for the ray's
    /// origin.
    ///
    /// The height above the triangle's plane is known to two steps. So the error of the distance is the distance in
    /// which the ray loses two steps of height, but a hit lies between the nearest and the furthest corner.
    #[inline(never)]
    pub(super) fn met(
        &self,
        from: &FlatFromPoint,
        direction: &Direction,
        range: Range,
    ) -> Option<Length> {
        let climb = direction.dot(self.normal).to_bits();
        if climb.abs() < GRAZING {
            return self.grazed(from, direction, range);
        }
        // A ray that hits the triangle approaches its plane.
        if (climb ^ from.height) < 0 {
            return None;
        }
        let (height, rise) = (from.height.unsigned_abs(), climb.unsigned_abs());
        // A light within epsilon of a surface leaves a reach below 0.
        let reach = unsigned(range.reach.to_bits().max(0));
        if wide_unsigned(height, 1 << 30) >= wide_unsigned(rise, reach)
            || !self.is_crossed(from.way, direction, climb < 0)
        {
            return None;
        }
        let distance = Length::from_bits(ratio(height, rise));
        range.holds(distance).then_some(distance)
    }

    /// Tests whether the line of a ray cuts the triangle. `is_reversed` says whether the ray leads against its
    /// normal.
    #[inline(always)]
    fn is_crossed(&self, way: Vector, direction: &Direction, is_reversed: bool) -> bool {
        let [one, other] = self.sides;
        let is_out = |passes: i64| if is_reversed { passes > 0 } else { passes < 0 };
        let across = direction.crossed_with(way);
        if is_out(passes(across, one, (direction, way))) {
            return false;
        }
        // From the third corner to the first.
        let back = Vector::new(-other.x, -other.y, -other.z);
        if is_out(passes(across, back, (direction, way))) {
            return false;
        }
        let way = way.plus(one);
        let across = direction.crossed_with(way);
        !is_out(passes(across, other.minus(one), (direction, way)))
    }

    /// Returns the distance at which a ray almost along the triangle hits it.
    ///
    /// Rounding may change the sign of a small height or cosine. If all corners lie ahead, a line that cuts the
    /// triangle hits it ahead, whatever the signs are.
    #[cold]
    #[inline(never)]
    fn grazed(&self, from: &FlatFromPoint, direction: &Direction, range: Range) -> Option<Length> {
        let climb = direction.dot(self.normal).to_bits();
        let approaches = (climb ^ from.height) >= 0 && climb != 0;
        let is_level = climb.abs() < UNSURE;
        if !approaches && !is_level && from.height.abs() >= UNSURE {
            return None;
        }
        let is_reversed = climb < 0;
        let is_crossed = self.is_crossed(from.way, direction, is_reversed)
            || is_level && self.is_crossed(from.way, direction, !is_reversed);
        let first = from.way.dot(*direction);
        let [one, other] = self.sides.map(|side| first + side.dot(*direction));
        let (nearest, furthest) = (first.min(one).min(other), first.max(one).max(other));
        if !is_crossed || !approaches && nearest <= 0 {
            return None;
        }
        let (height, rise) = (from.height.unsigned_abs(), climb.unsigned_abs());
        let distance = if !approaches || is_level {
            (nearest >> 1) + (furthest >> 1)
        } else if height < rise {
            ratio(height, rise).max(nearest).min(furthest)
        } else {
            furthest
        };
        let distance = Length::from_bits(distance);
        range.holds(distance).then_some(distance)
    }
}
