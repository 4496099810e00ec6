//! Where a line cuts a triangle, and where the triangle's shadow on a line ends.

use super::PreparedTriangle;
use crate::number::{Unit, ratio, scaled_by_unit, unsigned};
use crate::ray::{Cut, Line, Shadows};
use crate::shape::bordered::CastsShadow;
use crate::vector::{Direction, Vector};

impl CastsShadow for PreparedTriangle {
    fn cut_by(&self, line: &Line, way: Vector) -> Cut<[[i32; 2]; 2]> {
        line.cut_flat(way, (self.normal, self.radius))
    }

    /// The plane of light and line cuts the triangle in a chord, whose ends lie on two sides. They throw the borders.
    fn shade(&self, way: Vector, shadows: &mut Shadows<'_>) {
        shadows.cut(self.cut_by(shadows.line, way));
        let off = shadows.lamp.off(shadows.line);
        let corner = way.plus(self.center.to(self.corner));
        let [one, other] = self.sides;
        let ends = [corner, corner.plus(one), corner.plus(other)]
            .map(|end| (end, end.dot(shadows.lamp.across)));
        for side in 0..3 {
            let [from, to] = [ends[side], ends[(side + 1) % 3]];
            if from.1.min(to.1) > off || from.1.max(to.1) < -off {
                continue;
            }
            if (to.1 - from.1).abs() <= 4 * off {
                return shadows.borders.end();
            }
            self.side(shadows, [from, to]);
        }
    }
}

impl PreparedTriangle {
    /// Adds the border that the point throws where a side cuts the plane of light and line. Each end of the side is a
    /// vector from the line's start and its distance from the plane.
    ///
    /// Each distance is known to e, that of the lamp. With the length l of the side and the
    /// difference Δ of the distances, the point is off by e l / Δ. If the side ends up to e before the plane, the end
    /// stands for the point, and is off by up to twice as much.
    fn side(&self, shadows: &mut Shadows<'_>, [(from, a), (to, b)]: [(Vector, i32); 2]) {
        let (line, lamp) = (shadows.line, shadows.lamp);
        let change = unsigned((b - a).abs());
        let share = match (a < 0) == (b < 0) {
            true if a.abs() < b.abs() => Unit::ZERO,
            true => Unit::ONE,
            false => Unit::from_bits(ratio(unsigned(a.abs()), change)),
        };
        let doubt = Unit::from_bits(ratio(2 * unsigned(lamp.off(line)), change));
        let off = line.off + scaled_by_unit(2 * self.radius, doubt) + 16;
        let point = from.plus(to.minus(from).part(share));
        let around = |axis: Direction| {
            let place = point.dot(axis);
            [place - off, place + off]
        };
        shadows.corners([around(line.along), around(lamp.up)]);
    }
}
