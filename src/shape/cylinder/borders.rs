//! Where a cylinder begins and ends in a row, and what it surely does to a stretch.

use super::{CylinderFromLight, CylinderFromPoint, PreparedCylinder};
use crate::number::{
    Unit, ratio, root_of_unit, scaled_by_unit, signed, signed_wide, square_root, unit_product, wide,
};
use crate::ray::{ANY_COLUMN, Chord, NO_COLUMN, RowPlane, Span, column};
use crate::shape::bordered::{Ball, Bordered, Fan, square};
use crate::shape::rays::{SLACK, Spread};
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
        let rims = self.rims(from, row)?;
        let (borders, is_wall_sure) = self.wall(from, row)?;
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

    /// If the rays to both ends pass the axis on the same side, further away than the radius, all rays do.
    #[inline(always)]
    fn told(&self, from: &CylinderFromLight, spread: &Spread) -> Option<bool> {
        let [one, other] = spread.ends.map(|end| from.from.sideways(end));
        let reach = self.radius + spread.thickness;
        let is_spared =
            one.min(other) > reach || one.max(other) < -reach || spread.most < from.nearest;
        is_spared.then_some(false)
    }

    fn spares(&self, from: &CylinderFromLight, fan: &Fan) -> bool {
        let size = |direction: Direction| {
            scaled_by_unit(self.half_height, self.axis.dot(direction)).abs() + self.radius + SLACK
        };
        fan.avoids(from.from.way, size) || self.is_passed(from, fan)
    }

    /// Rays to a straight line that meet the solid at both ends meet it between, as it is convex. They hit the wall
    /// unless they go in at one open end and out at the other, or begin or end inside.
    fn hides(&self, from: &CylinderFromLight, fan: &Fan) -> bool {
        if fan.thickness > SLACK || from.nearest <= SLACK || fan.is_far() {
            return false;
        }
        let seen = self.along_axis(from, fan, self.half_height);
        let [one, other] = seen.heights;
        let inner = self.half_height - SLACK;
        let (low, high) = (one.min(other), one.max(other));
        let goes_through =
            seen.light >= inner && low <= -inner || seen.light <= -inner && high >= inner;
        let outer = self.half_height + SLACK;
        let is_outside =
            low > outer || high < -outer || are_beside(seen.ends, seen.ends, self.radius + SLACK);
        !goes_through && is_outside
    }
}

/// The rays of a light to two points, as seen along a cylinder's axis: vectors from the axis, and heights above the
/// cylinder's middle.
struct AlongAxis {
    /// The two points.
    ends: [Vector; 2],
    heights: [i32; 2],
    /// Height of the light.
    light: i32,
    /// Where the rays come between the rims: the light, points on the rays, or the ends themselves.
    starts: [Vector; 2],
}

impl PreparedCylinder {
    /// Returns the sine of the angle between a direction and the axis, but at least 1 / 16. It is
    /// known to 2⁻²², so a radius times the sine to 32 steps.
    #[inline(never)]
    fn sine(&self, direction: Direction) -> Unit {
        let along = self.axis.dot(direction);
        let square = (Unit::ONE - unit_product(along, along)).max(Unit::from_bits(1 << 22));
        root_of_unit(square)
    }

    /// Returns the rays of a light to the two ends of a near fan. Further than `half` from the cylinder's middle they
    /// do not count.
    #[inline(never)]
    fn along_axis(&self, from: &CylinderFromLight, fan: &Fan, half: i32) -> AlongAxis {
        let CylinderFromPoint { way, rise, .. } = from.from;
        let points = [0, 1].map(|end| fan.ends[end].scaled(fan.reaches[end].to_bits()).minus(way));
        let heights = points.map(|point| point.dot(self.axis));
        let ends = [0, 1].map(|end| points[end].without(self.axis, heights[end]));
        let (light, apex) = (-rise, Vector::ZERO.minus(way.without(self.axis, rise)));
        let edge = if light > half { half } else { -half };
        let start = |end: usize| {
            if light.abs() <= half {
                return apex;
            }
            let (rest, whole) = (edge - heights[end], light - heights[end]);
            if (rest > 0) != (light > 0) || rest.abs() >= whole.abs() {
                return ends[end];
            }
            let share = Unit::from_bits(ratio(rest.unsigned_abs(), whole.unsigned_abs()));
            ends[end].plus(apex.minus(ends[end]).part(share))
        };
        AlongAxis {
            ends,
            heights,
            light,
            starts: [start(0), start(1)],
        }
    }

    /// Tests whether the rays of a near fan surely pass the cylinder: on one side of its axis, above or below it, or
    /// beside it where they are between its rims. There they are a convex figure, which a line parallel to its side
    /// keeps from the circle.
    #[inline(never)]
    pub(super) fn is_passed(&self, from: &CylinderFromLight, fan: &Fan) -> bool {
        let more = fan.thickness + SLACK;
        let (half, radius) = (self.half_height + more, self.radius + more);
        let [one, other] = fan.ends.map(|end| {
            let aside = from.from.sideways(end);
            let is_beside = aside.abs() > scaled_by_unit(radius, self.sine(end)) + SLACK;
            aside.signum() * i32::from(is_beside)
        });
        if one * other > 0 {
            return true;
        }
        if fan.is_far() {
            return false;
        }
        let seen = self.along_axis(from, fan, half);
        let [one, other] = seen.heights;
        one.min(other).min(seen.light) > half
            || one.max(other).max(seen.light) < -half
            || are_beside(seen.ends, seen.starts, radius)
            || are_beside(seen.starts, seen.ends, radius)
    }

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
        let is_known = row.holds_rays(from.way.dot(row.axis.ahead) + self.reach);
        if !is_known || rest <= square(radius + (radius >> 6)) {
            // Rays may leave the row's plane, or the eye is inside of the infinite cylinder or close to it.
            let inner = (radius - (radius >> 6) - 2 * SLACK).max(0);
            return Some((ALL, is_known && rest < square(inner)));
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
            let numerator = if aside > 0 { -ahead } else { ahead };
            let ends = row.axis.sixteenths(numerator, off * tangent, scale);
            is_sure &= row.axis.is_exact(signed_wide(rest), scale, touching);
            is_sure &= ends[1] - ends[0] <= 6;
            if aside > 0 { first = first.max(ends[0]) } else { last = last.min(ends[1]) }
        }
        Some(([first, last], is_sure))
    }

    /// Returns where the rims of both ends begin and end. `None` if the row passes the cylinder: its plane cuts neither end,
    /// and both lie on one side of it.
    fn rims(&self, from: &CylinderFromPoint, row: &RowPlane) -> Option<[u16; 4]> {
        let (_, half_axis, radius) = self.capsule();
        let mut rims = [NO_COLUMN; 4];
        let ends = [from.way.plus(half_axis), from.way.minus(half_axis)];
        let mut is_met = from.way.dot(row.normal).abs() <= half_axis.dot(row.normal).abs();
        for (rims, way) in rims.chunks_exact_mut(2).zip(ends) {
            let chord = row.chord(way, self.axis, radius);
            is_met |= !matches!(chord, Chord::None);
            match chord {
                Chord::None => {}
                Chord::Ends(ends, true) => {
                    // What lies to the left of the picture changes none of its columns.
                    for (rim, end) in rims.iter_mut().zip(ends).filter(|(_, end)| *end > -32) {
                        *rim = column((end - 6) >> 4).min(ANY_COLUMN - 1);
                    }
                }
                Chord::Unknown | Chord::Ends(_, false) => rims.fill(ANY_COLUMN),
            }
        }
        is_met.then_some(rims)
    }
}

/// Tests whether four points surely lie further than `radius` from an axis, all on the side of the middle of the first
/// two. The points are vectors from the axis, across it.
#[inline(never)]
fn are_beside(these: [Vector; 2], others: [Vector; 2], radius: i32) -> bool {
    let [one, other] = these;
    let (side, _) = one.coarser(1).plus(other.coarser(1)).normalised();
    let mut points = these.iter().chain(&others);
    points.all(|point| point.dot(side) > radius)
}
