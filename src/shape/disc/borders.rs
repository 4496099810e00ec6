//! Where a disc begins and ends in a row, and what it surely does to a stretch.

use super::{DiscFromPoint, PreparedDisc};
use crate::number::{scaled_by_unit, square_root};
use crate::ray::{Chord, RowPlane, Span};
use crate::shape::bordered::{Ball, Bordered, Fan, SLACK, square};

impl Bordered for PreparedDisc {
    type Rims = [u16; 0];

    fn span(
        &self,
        from: &DiscFromPoint,
        row: &RowPlane,
        screen: [u16; 2],
    ) -> Option<Span<[u16; 0]>> {
        match row.chord(from.way, self.normal, self.radius) {
            Chord::None => None,
            Chord::Unknown => Some(Span::unsure(screen, [])),
            Chord::Ends(ends, is_sure) => Span::new(ends, is_sure, []),
        }
    }

    fn outline_distance(&self, from: &DiscFromPoint) -> i32 {
        square_root(from.way.square()) - self.radius - SLACK
    }

    #[inline(always)]
    fn bounding_ball(&self) -> Ball {
        self.ball()
    }

    fn is_apart_from(&self, (center, radius): Ball) -> bool {
        let way = self.center.to(center);
        way.dot(self.normal).abs() > radius + SLACK || way.square() > square(self.radius + radius)
    }

    fn spares(&self, from: &DiscFromPoint, fan: &Fan) -> bool {
        // Heights of the apex and of the ends above the disc.
        let apex = -from.height;
        let is_above = fan.ends.iter().zip(fan.reaches).map(|(end, reach)| {
            let height = apex + scaled_by_unit(reach.to_bits(), end.dot(self.normal));
            let reach = fan.thickness + SLACK;
            i32::from(height > reach) - i32::from(height < -reach)
        });
        let sides = is_above.sum::<i32>() + i32::from(apex > SLACK) - i32::from(apex < -SLACK);
        sides.abs() == 3 || fan.avoids_ball(from.way, self.radius)
    }

    /// A convex body that hides two points hides the straight line between them.
    fn hides(&self, _: &DiscFromPoint, fan: &Fan) -> bool {
        fan.thickness <= SLACK
    }
}
