//! Where a disc begins and ends in a row, and what it surely does to a stretch.

use super::PreparedDisc;
use crate::number::square_root;
use crate::ray::{Chord, RowPlane, Span};
use crate::shape::bordered::{Ball, Bordered, Fan, square};
use crate::shape::flat::FlatFromPoint;
use crate::shape::rays::SLACK;

impl Bordered for PreparedDisc {
    type Rims = [u16; 0];

    fn span(
        &self,
        from: &FlatFromPoint,
        row: &RowPlane,
        screen: [u16; 2],
    ) -> Option<Span<[u16; 0]>> {
        match row.chord(from.way, self.normal, self.radius) {
            Chord::None => None,
            Chord::Unknown => Some(Span::unsure(screen, [])),
            Chord::Ends(ends, is_sure) => Span::new(ends, is_sure, []),
        }
    }

    fn outline_distance(&self, from: &FlatFromPoint) -> i32 {
        square_root(from.way.square()) - self.radius - SLACK
    }

    fn is_apart_from(&self, (center, radius): Ball) -> bool {
        let way = self.center.to(center);
        way.dot(self.normal).abs() > radius + SLACK || way.square() > square(self.radius + radius)
    }

    fn spares(&self, from: &FlatFromPoint, fan: &Fan) -> bool {
        from.is_beside(self.normal, fan) || fan.avoids_ball(from.way, self.radius)
    }

    /// A convex body that hides two points hides the straight line between them.
    fn hides(&self, _: &FlatFromPoint, fan: &Fan) -> bool {
        fan.thickness <= SLACK
    }
}
