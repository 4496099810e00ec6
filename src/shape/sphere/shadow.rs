//! Where a line cuts a sphere, and where the sphere's shadow on a line ends.

use super::PreparedSphere;
use crate::number::{signed_wide, square_root, unsigned_wide, wide};
use crate::ray::{Cut, Line, SLACK, Shadows, within_reach};
use crate::shape::bordered::CastsShadow;
use crate::vector::Vector;

impl CastsShadow for PreparedSphere {
    fn cut_by(&self, line: &Line, way: Vector) -> Cut<[[i32; 2]; 2]> {
        let along = way.dot(line.along);
        let apart = signed_wide(way.without(line.along, along).square());
        let [outer, inner] = [SLACK + line.off, -SLACK - line.off].map(|off| {
            let radius = (self.radius + off).max(0);
            wide(radius, radius) - apart
        });
        if outer < 0 {
            return Cut::None;
        }
        let far = square_root(unsigned_wide(outer)) + 2;
        let near = square_root(unsigned_wide(inner.max(0)));
        Cut::Some([[along - far, along - near], [along + near, along + far]])
    }

    /// The plane of light and line cuts the sphere in a circle. Two rays of the light touch it: with the vector
    /// (y, z) from the light to its centre and k² = y² + z² - ρ², they lead along
    /// (y k ± z ρ, z k ∓ y ρ).
    fn shade(&self, way: Vector, shadows: &mut Shadows<'_>) {
        let lamp = shadows.lamp;
        let apart = way.dot(lamp.across).abs();
        let off = lamp.off(shadows.line);
        let circle = |radius: i32| match apart < radius {
            true => square_root(unsigned_wide(wide(radius - apart, radius + apart))),
            false => 0,
        };
        let [inner, outer] = [self.radius - off, self.radius + off].map(circle);
        let height = way.dot(lamp.up);
        if outer == 0 || height < -outer {
            return;
        }
        if height < outer {
            shadows.cut(self.cut_by(shadows.line, way));
        }
        if lamp.is_parallel {
            return touch(
                shadows,
                [way.dot(shadows.line.along), height],
                [inner, outer],
            );
        }
        // In the light's steps.
        let y = i64::from(way.dot(shadows.line.along) >> lamp.scale) - i64::from(lamp.along);
        let z = i64::from(height >> lamp.scale) - i64::from(lamp.height);
        let touching = |circle: i32| {
            let circle = circle >> lamp.scale;
            let rest = y * y + z * z - wide(circle, circle);
            (rest > 0).then(|| {
                (
                    i64::from(square_root(unsigned_wide(rest))),
                    i64::from(circle),
                )
            })
        };
        let (Some(inner), Some(outer)) = (touching(inner), touching(outer)) else {
            return shadows.borders.end();
        };
        for sign in [-1, 1] {
            let ray = |(root, circle): (i64, i64)| {
                [y * root + sign * z * circle, z * root - sign * y * circle]
            };
            shadows.rays([ray(inner), ray(outer)]);
        }
    }
}

/// Adds the borders of a circle's shadow under parallel rays: on both sides of the ray through its centre, by its radius,
/// which lies between two.
fn touch(shadows: &mut Shadows<'_>, center: [i32; 2], circle: [i32; 2]) {
    let lamp = shadows.lamp;
    let [from, to] = lamp
        .under(center.map(|it| [it - SLACK, it + SLACK]))
        .map(i64::from);
    let [inner, outer] = circle.map(|it| i64::from(lamp.cast(it)));
    for ends in [
        [from - outer - 2, to - inner + 2],
        [from + inner - 2, to + outer + 2],
    ] {
        shadows.place(ends.map(within_reach));
    }
}
