//! Where a cylinder begins and ends in a row, and what it surely does to a stretch.

use super::{CylinderFromLight, CylinderFromPoint, PreparedCylinder};
use crate::number::{Length, signed, signed_wide, square_root, wide};
use crate::ray::{ANY_COLUMN, Chord, NO_COLUMN, RowPlane, Span, column};
use crate::shape::bordered::{Ball, Bordered, Fan, Rod, SLACK, square};
use crate::vector::{Direction, Vector};

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
        let rims = self.rims(from, row);
        let screen = [i32::from(left) << 4, i32::from(right) << 4];
        let ends = [screen[0].max(borders[0]), screen[1].min(borders[1])];
        Span::new(ends, is_wall_sure, rims)
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

    fn spares(&self, from: &CylinderFromLight, fan: &Fan) -> bool {
        if fan
            .reaches
            .iter()
            .all(|reach| reach.to_bits() + fan.thickness < from.nearest)
        {
            return true;
        }
        let from = &from.from;
        // If both ends pass the axis on the same side, further away than the radius, all rays do.
        let [one, other] = fan.ends.map(|end| from.sideways(end));
        let reach = self.radius + fan.thickness;
        if one.min(other) > reach || one.max(other) < -reach {
            return true;
        }
        fan.avoids_rod(
            from.way,
            &Rod {
                axis: self.axis,
                half: self.half_height,
                radius: self.radius,
            },
        )
    }

    /// The rays of the apex to a straight line lie in one plane, which cuts the wall in an ellipse. If the
    /// normals at two of its points differ by less than a right angle, the part between them lies in the
    /// ball over their distance. If that ball does not reach the rims, all rays between hit the wall.
    fn hides(&self, from: &CylinderFromLight, fan: &Fan) -> bool {
        if fan.thickness > SLACK {
            return false;
        }
        let entry = |direction: Direction, reach: Length| {
            let start = Length::from_bits(0);
            let hit = self.met(&from.from, &direction, start, reach)?;
            let at = direction.scaled(hit.to_bits()).minus(from.from.way);
            let height = at.dot(self.axis);
            let outward = at.without(self.axis, height);
            // The wall is hit from outside.
            (outward.dot(direction) < 0).then_some((at, height, outward))
        };
        let ([one, other], [near, far]) = (fan.ends, fan.reaches);
        let (Some(first), Some(last)) = (entry(one, near), entry(other, far)) else {
            return false;
        };
        let chord = square_root(first.0.minus(last.0).square());
        let turn =
            wide(first.2.x, last.2.x) + wide(first.2.y, last.2.y) + wide(first.2.z, last.2.z);
        turn > wide(self.radius, self.radius) >> 1
            && (first.1 + last.1).abs() + chord < 2 * self.half_height - SLACK
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
        let least = (signed_wide(rest) >> 10).max(1);
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
                // Almost the same for all columns. The slack of the radius turns the plane by less than
                // 2^-10.
                is_sure &= touching > SLACK << 10
                    && row.axis.is_beside(ahead - least - off, 2 * least + off);
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

    /// Returns where the rims of both ends begin and end.
    fn rims(&self, from: &CylinderFromPoint, row: &RowPlane) -> [u16; 4] {
        let (_, half_axis, radius) = self.capsule();
        let mut rims = [NO_COLUMN; 4];
        let ends = [from.way.plus(half_axis), from.way.minus(half_axis)];
        for (rims, way) in rims.chunks_exact_mut(2).zip(ends) {
            match row.chord(way, self.axis, radius) {
                Chord::None => {}
                Chord::Ends(ends, true) => {
                    for (rim, end) in rims.iter_mut().zip(ends) {
                        *rim = column((end - 6) >> 4).min(ANY_COLUMN - 1);
                    }
                }
                Chord::Unknown | Chord::Ends(_, false) => rims.fill(ANY_COLUMN),
            }
        }
        rims
    }
}
