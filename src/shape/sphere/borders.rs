//! Where a sphere begins and ends in a row, and what it surely does to a stretch.

use super::{PreparedSphere, SphereFromPoint};
use crate::ray::{RowPlane, Span};
use crate::shape::bordered::{Ball, Beam, Bordered, SLACK, square};
use crate::shape::bounded::LightRay;

impl Bordered for PreparedSphere {
    type Rims = [u16; 0];

    fn span(&self, from: &SphereFromPoint, row: &RowPlane, _: [u16; 2]) -> Option<Span<[u16; 0]>> {
        row.ball(from.way, self.radius)
    }

    #[inline(always)]
    fn outline_distance(&self, from: &SphereFromPoint) -> i32 {
        from.tangent
    }

    #[inline(always)]
    fn bounding_ball(&self) -> Ball {
        self.ball()
    }

    #[inline(always)]
    fn is_apart_from(&self, (center, radius): Ball) -> bool {
        self.center.to(center).square() > square(self.radius + radius)
    }

    #[inline(always)]
    fn spares(&self, from: &SphereFromPoint, beam: &Beam) -> bool {
        beam.passes(from.way, self.radius)
    }

    /// A convex body that hides two points hides the straight line between them. Points that are not on
    /// a line are hidden if the whole beam cuts the sphere.
    fn hides(&self, from: &SphereFromPoint, beam: &Beam, _: &[LightRay; 2], is_flat: bool) -> bool {
        if is_flat {
            return true;
        }
        let along = from.way.dot(beam.direction);
        let inner = self.radius - beam.width(along);
        along < beam.length - beam.radius - SLACK
            && inner > 0
            && from.way.without(beam.direction, along).square() < square(inner)
    }
}
