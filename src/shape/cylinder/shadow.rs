//! Where a line cuts a cylinder, and where the cylinder's shadow on a line ends.

use super::{CylinderFromPoint, PreparedCylinder};
use crate::number::{Unit, over, share_of, signed_wide, square_root, unsigned_wide, wide};
use crate::ray::{ChordLine, Cut, Line, SLACK, Shadows, within_reach};
use crate::shape::bordered::{CastsShadow, square};
use crate::vector::{Direction, Vector};

impl CastsShadow for PreparedCylinder {
    /// Seen along the axis, a step of the line is as long as the sine of the angle between line and axis.
    fn cut_by(&self, line: &Line, way: Vector) -> Cut<[[i32; 2]; 2]> {
        let climb = line.along.dot(self.axis);
        let across = line.along.raw().minus(self.axis.raw_times(climb.to_bits()));
        let (across, sine) = across.normalised();
        let sine = Unit::from_bits(sine.to_bits().min(Unit::ONE.to_bits()));
        if sine < Unit::from_bits(1 << 26) {
            // Almost along the axis: near the shape, the line leaves it by less than a sixteenth.
            let aside = way.without(line.along, way.dot(line.along));
            let reach = self.radius + (self.half_height >> 3) + SLACK + line.off;
            return match aside.square() > square(reach) {
                true => Cut::None,
                false => Cut::Unknown,
            };
        }
        let bits = sine.to_bits().leading_zeros() - 1;
        let off = (SLACK + line.off) << bits;
        let rise = way.dot(self.axis);
        let flat = way.without(self.axis, rise);
        let along = flat.dot(across);
        let apart = signed_wide(flat.without(across, along).square());
        let chord = |radius: i32| wide(radius, radius) - apart;
        let (outer, inner) = (chord(self.radius + off), chord((self.radius - off).max(0)));
        if outer < 0 {
            return Cut::None;
        }
        let far = square_root(unsigned_wide(outer)) + 2;
        let near = square_root(unsigned_wide(inner.max(0)));
        let ends = [[along - far, along - near], [along + near, along + far]];
        let ends = ends.map(|[from, to]| Some([over(from, sine)? - off, over(to, sine)? + off]));
        let [Some(first), Some(last)] = ends else {
            return Cut::Unknown;
        };
        Cut::Some([first, last])
    }

    fn shade(&self, way: Vector, shadows: &mut Shadows<'_>) {
        let (line, lamp) = (shadows.line, shadows.lamp);
        if way.dot(lamp.up) < -self.ball().1 - 2 * SLACK {
            return;
        }
        shadows.cut(self.cut_by(line, way));
        for side in [-1, 1] {
            let half = self.axis.scaled(side * self.half_height);
            let chord = ChordLine::of(lamp.across, way.plus(half), (self.axis, self.radius));
            shadows.chord(chord);
        }
        if lamp.is_parallel {
            return self.touch(way, shadows);
        }
        // The two planes through the light that touch the wall.
        let light = line
            .along
            .scaled(lamp.along)
            .plus(lamp.up.scaled(lamp.height));
        let to = way.coarser(lamp.scale).minus(light);
        let from = CylinderFromPoint::new(to, self.axis);
        let off = lamp.off(line);
        let touching = [self.radius - off, self.radius + off]
            .map(|radius| from.touching(self.axis, radius.max(0) >> lamp.scale));
        let [Some(inner), Some(outer)] = touching else {
            return shadows.borders.end();
        };
        for (inner, outer) in inner.into_iter().zip(outer) {
            // A ray in both planes: at right angles to both normals.
            let ray = |normal: Vector| {
                let [y, z] = [line.along, lamp.up].map(|it| normal.dot_wide(it) >> 30);
                // Of two opposite directions, the one that leads down.
                match y < 0 {
                    true => [-z, y],
                    false => [z, -y],
                }
            };
            shadows.rays([ray(inner), ray(outer)]);
        }
    }
}

impl PreparedCylinder {
    /// Adds the borders of the wall's shadow under parallel rays: where the two planes that touch it cut the line.
    fn touch(&self, way: Vector, shadows: &mut Shadows<'_>) {
        let (line, lamp) = (shadows.line, shadows.lamp);
        let towards = line
            .along
            .scaled(lamp.along)
            .plus(lamp.up.scaled(lamp.height));
        let (normal, sine) = self.axis.crossed_with(towards).normalised();
        if sine.to_bits() < Unit::ONE.to_bits() >> 6 {
            return shadows.borders.end();
        }
        // The normal is off by 2^(bits - 28).
        let bits = sine.to_bits().min(Unit::ONE.to_bits()).leading_zeros() - 1;
        let off = lamp.off(line) << bits;
        let (climb, apart) = (line.along.dot(normal), way.dot(normal));
        let steep = climb.to_bits().unsigned_abs().leading_zeros() - 1;
        if steep > 10 {
            // Almost along the planes: the line stays away from them, or it is not known where it cuts them.
            let is_apart = (apart.abs() - self.radius).abs() > off + (1 << 20);
            if !is_apart {
                shadows.borders.end();
            }
            return;
        }
        for radius in [-self.radius, self.radius] {
            let Some(place) = over(apart + radius, climb) else {
                continue;
            };
            let off = (i64::from(off) << steep) + i64::from(place.abs() >> (26 - bits - steep));
            let place = i64::from(place);
            shadows.place([place - off, place + off].map(within_reach));
        }
    }
}

impl CylinderFromPoint {
    /// Returns the normals of the two planes through the point that touch an infinite cylinder, in any
    /// length. `None` if the point is inside.
    ///
    /// With a = axis × way of length e, and q the part of `way` across the axis, they are
    /// ± √(e² - r²) a + r q. A ray hits the cylinder if it is on the inner side of both.
    fn touching(&self, axis: Direction, radius: i32) -> Option<[Vector; 2]> {
        let rest = signed_wide(self.across.square()) - wide(radius, radius);
        if rest <= 0 {
            return None;
        }
        let length = square_root(self.across.square()).max(1);
        let (root, toward) = (
            square_root(unsigned_wide(rest)),
            self.way.without(axis, self.rise),
        );
        // As shares of e, so that the sum fits.
        let half = |part: i32| share_of(part >> 1, length).unwrap_or(Unit::from_bits(1 << 29));
        let [root, radius] = [root, radius].map(half);
        let (across, toward) = (self.across.part(root), toward.part(radius));
        Some([toward.plus(across), toward.minus(across)])
    }
}
