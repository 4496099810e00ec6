//! Where a line cuts a disc, and where the disc's shadow on a line ends.

use super::PreparedDisc;
use crate::ray::{ChordLine, Cut, Line, Shadows};
use crate::shape::bordered::CastsShadow;
use crate::vector::Vector;

impl CastsShadow for PreparedDisc {
    fn cut_by(&self, line: &Line, way: Vector) -> Cut<[[i32; 2]; 2]> {
        line.cut_flat(way, (self.normal, self.radius))
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
