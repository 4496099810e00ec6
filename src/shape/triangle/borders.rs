//! What a triangle surely does to a stretch: nothing but pass it. Where it begins and ends in a row is not known, so
//! each pixel that may show it is traced.

use super::{PreparedTriangle, TriangleFromPoint};
use crate::number::{scaled_by_unit, square_root};
use crate::ray::{ANY_COLUMN, RowPlane, Span};
use crate::shape::bordered::{Ball, Bordered, Fan, SLACK, square};

impl Bordered for PreparedTriangle {
    type Rims = [u16; 1];

    fn span(
        &self,
        _: &TriangleFromPoint,
        _: &RowPlane,
        screen: [u16; 2],
    ) -> Option<Span<[u16; 1]>> {
        Some(Span::unsure(screen, [ANY_COLUMN]))
    }

    fn outline_distance(&self, from: &TriangleFromPoint) -> i32 {
        let [one, other] = self.sides.map(|side| from.way.plus(side));
        let squares = [from.way, one, other].map(|it| square_root(it.square()));
        let nearest = squares[0].min(squares[1]).min(squares[2]);
        // No point is further from the nearest corner than the ball is wide.
        nearest - 2 * self.radius - SLACK
    }

    #[inline(always)]
    fn bounding_ball(&self) -> Ball {
        self.ball()
    }

    fn is_apart_from(&self, (center, radius): Ball) -> bool {
        let height = self.corner.to(center).dot(self.normal);
        height.abs() > radius + SLACK
            || self.center.to(center).square() > square(self.radius + radius)
    }

    fn spares(&self, from: &TriangleFromPoint, fan: &Fan) -> bool {
        // Heights of the apex and of the ends above the triangle.
        let apex = -from.height;
        let is_above = fan.ends.iter().zip(fan.reaches).map(|(end, reach)| {
            let height = apex + scaled_by_unit(reach.to_bits(), end.dot(self.normal));
            let reach = fan.thickness + SLACK;
            i32::from(height > reach) - i32::from(height < -reach)
        });
        let sides = is_above.sum::<i32>() + i32::from(apex > SLACK) - i32::from(apex < -SLACK);
        let way = from.way.plus(self.corner.to(self.center));
        sides.abs() == 3 || fan.avoids_ball(way, self.radius)
    }

    /// Two triangles may share a side along a stretch, and rounding decides which one a ray hits.
    fn hides(&self, _: &TriangleFromPoint, _: &Fan) -> bool {
        false
    }
}
