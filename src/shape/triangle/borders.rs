//! Where a triangle begins and ends in a row, and what it surely does to a stretch.

use super::PreparedTriangle;
use crate::number::{Unit, ratio, scaled_by_unit, signed, square_root};
use crate::ray::{ANY_COLUMN, NO_COLUMN, RowPlane, SLACK as OFF, Seen, Span};
use crate::shape::bordered::{Ball, Bordered, Fan, square};
use crate::shape::flat::FlatFromPoint;
use crate::shape::rays::SLACK;
use crate::vector::Vector;

/// A corner that is nearer to a row's plane may lie on either side of it, in steps.
const NEAR_PLANE: i32 = 2 * OFF;

/// Borders are exact enough if they are known to this many sixteenths of a column.
const NARROW: i32 = 12;

impl PreparedTriangle {
    /// Returns the corners as vectors from the point for which `from` was prepared.
    fn ways(&self, from: &FlatFromPoint) -> [Vector; 3] {
        let [one, other] = self.sides;
        [from.way, from.way.plus(one), from.way.plus(other)]
    }
}

/// Returns the columns in which a row shows the point where a side cuts its plane, in sixteenths: at least and at
/// most. Each end of the side is a vector from the eye and its height above the plane; the heights have different
/// signs. `None` if that is not known.
///
/// Heights and rays are off the plane by less than 16 steps. With the length l of the side and the difference Δ of the
/// heights, the point is off by less than 16 l / Δ, and by 8 steps that rounding adds.
fn cut(row: &RowPlane, [from, to]: [(Vector, i32); 2]) -> Option<[i32; 2]> {
    let way = to.0.minus(from.0);
    let (part, rest) = (from.1.unsigned_abs(), to.1.unsigned_abs());
    let share = Unit::from_bits(ratio(part, part + rest));
    let [ahead, aside] = row.flat(from.0.plus(way.part(share))).map(i64::from);
    let length = i64::from(square_root(way.square()));
    let off = i64::from(OFF) * (length / i64::from((part + rest) | 1) + 2) + 8;
    match row.seen(ahead, aside, off) {
        Seen::At(ends) => Some(ends),
        Seen::Left => Some([-64; 2]),
        Seen::Right => Some([64 * (signed(row.axis.width) + 1); 2]),
        Seen::Behind | Seen::Unknown => None,
    }
}

impl Bordered for PreparedTriangle {
    type Rims = [u16; 1];

    /// The row's plane cuts two sides, unless a corner is near to it.
    fn span(
        &self,
        from: &FlatFromPoint,
        row: &RowPlane,
        screen: [u16; 2],
    ) -> Option<Span<[u16; 1]>> {
        // No corner is further away from another than the ball is wide.
        if !row.holds_rays(from.way.dot(row.axis.ahead) + 2 * self.radius) {
            return Some(Span::unsure(screen, [ANY_COLUMN]));
        }
        let corners = self.ways(from).map(|way| (way, way.dot(row.normal)));
        let above = corners.map(|(_, height)| i32::from(height > NEAR_PLANE));
        let below = corners.map(|(_, height)| i32::from(height < -NEAR_PLANE));
        let sums = [above, below].map(|it| it.iter().sum::<i32>());
        let side = match sums {
            [3, 0] | [0, 3] => return None,
            [1, 2] => above,
            [2, 1] => below,
            _ => return Some(Span::unsure(screen, [ANY_COLUMN])),
        };
        // The corner that is alone on its side comes first.
        let [first, second, third] = match side {
            [1, _, _] => corners,
            [_, 1, _] => [corners[1], corners[2], corners[0]],
            _ => [corners[2], corners[0], corners[1]],
        };
        let (Some(one), Some(other)) = (cut(row, [first, second]), cut(row, [first, third])) else {
            return Some(Span::unsure(screen, [ANY_COLUMN]));
        };
        let is_sure = [one, other].iter().all(|[low, high]| high - low <= NARROW);
        let rim = if is_sure { NO_COLUMN } else { ANY_COLUMN };
        let ends = [one[0].min(other[0]), one[1].max(other[1])];
        Span::new(ends, is_sure, [rim])
    }

    fn outline_distance(&self, from: &FlatFromPoint) -> i32 {
        let distances = self.ways(from).map(|way| square_root(way.square()));
        let nearest = distances[0].min(distances[1]).min(distances[2]);
        // No point is further from the nearest corner than the ball is wide.
        nearest - 2 * self.radius - SLACK
    }

    fn is_apart_from(&self, (center, radius): Ball) -> bool {
        let height = self.corner.to(center).dot(self.normal);
        height.abs() > radius + SLACK
            || self.center.to(center).square() > square(self.radius + radius)
    }

    fn spares(&self, from: &FlatFromPoint, fan: &Fan) -> bool {
        let way = from.way.plus(self.corner.to(self.center));
        from.is_beside(self.normal, fan)
            || fan.avoids_ball(way, self.radius)
            || self.is_beside(from, fan)
    }

    /// Two triangles may share a side along a stretch, and rounding decides which one a ray hits.
    fn hides(&self, _: &FlatFromPoint, _: &Fan) -> bool {
        false
    }
}

impl PreparedTriangle {
    /// Tests whether a plane through the apex of a fan and a side of the triangle surely has the fan on one side and
    /// the triangle on the other.
    ///
    /// A ray that ends more than a slack beside that plane leads away from it all the way.
    #[inline(never)]
    fn is_beside(&self, from: &FlatFromPoint, fan: &Fan) -> bool {
        let ways = self.ways(from);
        (0..3).any(|index| {
            let [one, other, inner] = [0, 1, 2].map(|it| ways[(index + it) % 3]);
            let (across, _) = Vector::leading(one.cross_wide(other), 29);
            if across.square() < 1 << 40 {
                return false;
            }
            let outward = across.precise_direction();
            let depth = inner.dot(outward);
            let outward = outward.reversed_if(depth > 0);
            depth.abs() > SLACK
                && fan.ends.iter().zip(fan.reaches).all(|(end, reach)| {
                    scaled_by_unit(reach.to_bits(), end.dot(outward)) > fan.thickness + SLACK
                })
        })
    }
}
