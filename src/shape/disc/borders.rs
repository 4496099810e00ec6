//! Where a disc begins and ends in a row, and what it surely does to a stretch.

use super::{DiscFromPoint, PreparedDisc};
use crate::number::{scaled_by_unit, square_root};
use crate::ray::{Chord, RowPlane, Span};
use crate::shape::bordered::{Ball, Beam, Bordered, SLACK, square};
use crate::shape::bounded::LightRay;

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

    fn spares(&self, from: &DiscFromPoint, beam: &Beam) -> bool {
        // Heights of the light and of the ball above the disc.
        let light = -from.height;
        let middle = light + scaled_by_unit(beam.length, beam.direction.dot(self.normal));
        let reach = beam.radius + SLACK;
        let is_on_one_side =
            (light > SLACK && middle > reach) || (light < -SLACK && middle < -reach);
        is_on_one_side || beam.passes(from.way, self.radius)
    }

    /// A convex body that hides two points hides the straight line between them.
    fn hides(&self, _: &DiscFromPoint, _: &Beam, _: &[LightRay; 2], is_flat: bool) -> bool {
        is_flat
    }
}
