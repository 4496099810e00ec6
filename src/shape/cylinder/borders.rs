//! Where a cylinder begins and ends in a row, and what it surely does to a stretch.

use super::{CylinderFromLight, CylinderFromPoint, PreparedCylinder};
use crate::number::{
    Length, Unit, root_of_unit, scaled_by_unit, signed, signed_wide, square_root, unit_product, wide,
};
use crate::ray::{Chord, NO_COLUMN, RowPlane, Span, column};
use crate::shape::bordered::{Ball, Beam, Bordered, SLACK, square};
use crate::shape::bounded::LightRay;
use crate::vector::Vector;

impl Bordered for PreparedCylinder {
    /// Where the rims of both ends begin and end.
    type Rims = [u16; 4];

    fn span(
        &self,
        from: &CylinderFromPoint,
        row: &RowPlane,
        [left, right]: [u16; 2],
    ) -> Option<Span<[u16; 4]>> {
        let (borders, is_wall_sure) = self.wall(from, row)?;
        let (rims, are_rims_sure) = self.rims(from, row);
        let screen = [i32::from(left) << 4, i32::from(right) << 4];
        let ends = [screen[0].max(borders[0]), screen[1].min(borders[1])];
        Span::new(ends, is_wall_sure && are_rims_sure, rims)
    }

    fn outline_distance(&self, from: &CylinderFromPoint) -> i32 {
        let aside = (square_root(from.across.square()) - self.radius).max(0);
        let above = (from.rise.abs() - self.half_height).max(0);
        square_root(Vector::new(aside, above, 0).square()) - SLACK
    }

    #[inline(always)]
    fn bounding_ball(&self) -> Ball {
        self.ball()
    }

    fn is_apart_from(&self, (center, radius): Ball) -> bool {
        let way = self.center.to(center);
        let along = way.dot(self.axis);
        along.abs() > self.half_height + radius + SLACK
            || way.without(self.axis, along).square() > square(self.radius + radius + SLACK)
    }

    fn spares(&self, from: &CylinderFromLight, beam: &Beam) -> bool {
        if from.nearest > beam.length + beam.radius {
            return true;
        }
        let from = &from.from;
        // Distance between axis and middle ray, times the sine of the angle between them. It changes by
        // less than the distance of the light from the axis times the spread.
        let sideways = from.sideways(beam.direction).abs();
        let change = scaled_by_unit(square_root(from.across.square()), beam.spread) + SLACK;
        let climb = beam.direction.dot(self.axis);
        let sine = root_of_unit(Unit::ONE - unit_product(climb, climb).min(Unit::ONE));
        let steepest = Unit::from_bits(sine.to_bits() + beam.spread.to_bits() + 64);
        if sideways - change > scaled_by_unit(self.radius + SLACK, steepest.min(Unit::ONE)) {
            return true;
        }
        // Heights of the light and of the ball above the middle, along the axis.
        let light = -from.rise;
        let middle = light + scaled_by_unit(beam.length, climb);
        let low = light.min(middle - beam.radius);
        let high = light.max(middle + beam.radius);
        let limit = self.half_height + 2 * SLACK;
        low > limit || high < -limit
    }

    /// The light's rays to a straight line lie in one plane, which cuts the wall in an ellipse. If the
    /// normals at two of its points differ by less than a right angle, the part between them lies in the
    /// ball over their distance. If that ball does not reach the rims, all rays between hit the wall.
    fn hides(
        &self,
        from: &CylinderFromLight,
        _: &Beam,
        ends: &[LightRay; 2],
        is_flat: bool,
    ) -> bool {
        if !is_flat {
            return false;
        }
        let hits = ends.each_ref().map(|ray| {
            let hit = self.met(&from.from, &ray.direction, ray.epsilon, ray.reach);
            ray.direction
                .scaled(hit.unwrap_or(Length::from_bits(0)).to_bits())
        });
        let [one, other] = hits.map(|hit| hit.minus(from.from.way));
        let heights = [one, other].map(|at| at.dot(self.axis));
        let [first, last] = [(one, heights[0]), (other, heights[1])]
            .map(|(at, height)| at.without(self.axis, height));
        // The wall is hit from outside.
        let is_entry = |at: Vector, ray: &LightRay| at.dot(ray.direction) < 0;
        let chord = square_root(one.minus(other).square());
        let turn = wide(first.x, last.x) + wide(first.y, last.y) + wide(first.z, last.z);
        is_entry(first, &ends[0])
            && is_entry(last, &ends[1])
            && turn > wide(self.radius, self.radius) >> 1
            && (heights[0] + heights[1]).abs() + chord < 2 * self.half_height - SLACK
    }
}

impl PreparedCylinder {
    /// Returns the columns, in sixteenths, between which rays hit the infinite cylinder, and whether they
    /// are exact. Returns `None` if no ray of the row hits it.
    ///
    /// Two planes through the eye touch the cylinder. With a = axis × way of length e, and q the part of
    /// `way` across the axis, their normals are ± √(e² - r²) a + r q. A ray hits the cylinder if it is on
    /// the inner side of both.
    fn wall(&self, from: &CylinderFromPoint, row: &RowPlane) -> Option<([i32; 2], bool)> {
        const ALL: [i32; 2] = [0, i32::MAX >> 4];
        let radius = self.radius + SLACK;
        let rest = from.across.square();
        if rest <= square(radius + (radius >> 6)) {
            // The eye is inside of the infinite cylinder, or close to it.
            let inner = (radius - (radius >> 6) - 2 * SLACK).max(0);
            return Some((ALL, rest < square(inner)));
        }
        let touching = square_root(rest - square(radius));
        let toward = from.way.without(self.axis, from.rise);
        let (ahead, aside) = (row.axis.ahead, row.axis.aside);
        let [across_ahead, across_aside] =
            [ahead, aside].map(|it| wide(touching, from.across.dot(it)));
        let [toward_ahead, toward_aside] = [ahead, aside].map(|it| wide(radius, toward.dot(it)));
        let ([mut first, mut last], mut is_sure) = (ALL, true);
        // Smaller than this, a coefficient is not exact enough.
        let least = signed_wide(rest) >> 10;
        // Rounding of the products moves a normal by less than this.
        let off = 5 * (i64::from(square_root(rest)) + 1);
        for (ahead, aside) in [
            (toward_ahead + across_ahead, toward_aside + across_aside),
            (toward_ahead - across_ahead, toward_aside - across_aside),
        ] {
            if aside.abs() < least {
                if row.axis.is_beside(-ahead - off, least + off) {
                    return None;
                }
                // Almost the same for all columns.
                is_sure &= row.axis.is_beside(ahead - off, least + off);
                continue;
            }
            let tangent = 2 + (ahead.abs() >> (63 - signed(aside.unsigned_abs().leading_zeros())));
            let scale = row.axis.columns_for_each(aside.abs());
            let ends = [-1, 1].map(|sign| {
                let numerator = if aside > 0 { -ahead } else { ahead };
                row.axis.sixteenths(numerator + sign * off * tangent, scale)
            });
            is_sure &= row.axis.is_exact(signed_wide(rest), scale, touching);
            is_sure &= ends[1] - ends[0] <= 4;
            match aside > 0 {
                true => first = first.max(ends[0]),
                false => last = last.min(ends[1]),
            }
        }
        Some(([first, last], is_sure))
    }

    /// Returns where the rims of both ends begin and end, and whether that is exact.
    fn rims(&self, from: &CylinderFromPoint, row: &RowPlane) -> ([u16; 4], bool) {
        let (_, half_axis, radius) = self.capsule();
        let mut rims = [NO_COLUMN; 4];
        let mut is_sure = true;
        let ends = [from.way.plus(half_axis), from.way.minus(half_axis)];
        for (rims, way) in rims.chunks_exact_mut(2).zip(ends) {
            match row.chord(way, self.axis, radius) {
                Chord::None => {}
                Chord::Unknown => is_sure = false,
                Chord::Ends(ends, is_exact) => {
                    is_sure &= is_exact;
                    for (rim, end) in rims.iter_mut().zip(ends) {
                        *rim = column((end - 6) >> 4);
                    }
                }
            }
        }
        (rims, is_sure)
    }
}
