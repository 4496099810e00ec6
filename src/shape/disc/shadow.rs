//! Where a line cuts a disc, and where the disc's shadow on a line ends.

use super::PreparedDisc;
use crate::number::{over, scaled_by_unit};
use crate::ray::{ChordLine, Cut, Line, SLACK, Shadows};
use crate::shape::bordered::{CastsShadow, square};
use crate::vector::Vector;

impl CastsShadow for PreparedDisc {
    fn cut_by(&self, line: &Line, way: Vector) -> Cut<[[i32; 2]; 2]> {
        let (climb, height) = (line.along.dot(self.normal), way.dot(self.normal));
        let off = line.off + SLACK;
        match (over(height - off, climb), over(height + off, climb)) {
            (Some(one), Some(other)) => {
                let places = [one.min(other) - 2, one.max(other) + 2];
                let at = line
                    .along
                    .scaled((places[0] >> 1) + (places[1] >> 1))
                    .minus(way);
                let reach = self.radius + (places[1] >> 1) - (places[0] >> 1) + 2 * off;
                match reach < 0 || at.square() <= square(reach) {
                    true => Cut::Some([places; 2]),
                    false => Cut::None,
                }
            }
            _ if height.abs() > scaled_by_unit(self.radius, climb).abs() + 2 * off => Cut::None,
            _ => Cut::Unknown,
        }
    }

    fn shade(&self, way: Vector, shadows: &mut Shadows<'_>) {
        shadows.cut(self.cut_by(shadows.line, way));
        // From the light, which is in the plane.
        shadows.chord(ChordLine::of(
            shadows.lamp.across,
            way,
            (self.normal, self.radius),
        ));
    }
}
