//! Where a sphere begins and ends in a row, and what it surely does to a stretch.

use super::{PreparedSphere, SphereFromPoint};
use crate::number::scaled_by_unit;
use crate::ray::{RowPlane, Span};
use crate::shape::bordered::{Ball, Bordered, Fan, square};
use crate::shape::rays::Spread;

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
    fn is_apart_from(&self, (center, radius): Ball) -> bool {
        self.center.to(center).square() > square(self.radius + radius)
    }

    /// A ray meets the sphere if its direction lies in the cone of the tangents, and if it is longer than they are.
    #[inline(always)]
    fn told(&self, from: &SphereFromPoint, spread: &Spread) -> Option<bool> {
        let [one, other] = spread.ends.map(|end| from.way.dot(end));
        let margin = scaled_by_unit(from.tangent.max(0) + self.radius, spread.aside) + 2;
        let least = from.tangent.saturating_sub(margin);
        if one.max(other) < least || from.tangent >= spread.most {
            return Some(false);
        }
        let is_hidden =
            one.min(other).saturating_sub(margin) >= from.tangent && from.tangent < spread.least;
        is_hidden.then_some(true)
    }

    #[inline(always)]
    fn spares(&self, from: &SphereFromPoint, fan: &Fan) -> bool {
        fan.avoids_ball(from.way, self.radius)
    }

    /// A convex body that hides two points hides the straight line between them. The points of the fan are
    /// at most its thickness away from that line, so a sphere that is smaller by as much must hide the two.
    fn hides(&self, from: &SphereFromPoint, fan: &Fan) -> bool {
        let inner = self.radius - fan.thickness;
        inner > 0
            && fan.ends.iter().zip(fan.reaches).all(|(end, reach)| {
                let along = from.way.dot(*end);
                along < reach.to_bits() - fan.thickness
                    && from.way.without(*end, along).square() < square(inner)
            })
    }
}
