//! Where the shadow of a triangle on a line ends: not known.

use super::PreparedTriangle;
use crate::ray::{Cut, Line, Shadows};
use crate::shape::bordered::CastsShadow;
use crate::vector::Vector;

impl CastsShadow for PreparedTriangle {
    fn cut_by(&self, _: &Line, _: Vector) -> Cut<[[i32; 2]; 2]> {
        Cut::Unknown
    }

    fn shade(&self, _: Vector, shadows: &mut Shadows<'_>) {
        shadows.borders.end();
    }
}
