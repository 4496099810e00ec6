//! The line in which the plane of a row cuts another plane, and the columns in which the row shows its points.

use super::row_plane::{Border, RowPlane, SLACK, Seen};
use crate::number::{Unit, narrowed, over, scaled_by_unit, unsigned_wide, wide};
use crate::vector::{Direction, Vector};

/// Line in the plane of a row.
#[derive(Clone, Copy, Debug)]
pub struct Line {
    /// Vector from the eye to the point of the line that is nearest to it.
    pub(crate) start: Vector,
    pub(crate) along: Direction,
    /// What a point of the line may be off by, in steps, up to 2³⁰ steps from the start.
    pub(crate) off: i32,
    /// Parts of `start` and `along` ahead and aside.
    start_flat: [i32; 2],
    along_flat: [i32; 2],
}

/// How the plane of a row lies to something.
pub enum Cut<T> {
    /// They do not meet.
    None,
    /// They may meet anywhere.
    Unknown,
    Some(T),
}

/// Largest distance of a line that bounded shapes can meet from the eye, in steps.
const FURTHEST: i32 = 1 << 29;

impl RowPlane {
    /// Returns the line in which the row's plane cuts a plane. `height` is the height of the eye above it, in
    /// steps, rounded down.
    pub(crate) fn cut(&self, normal: Direction, height: i64) -> Cut<Line> {
        let [ahead, aside] = [self.axis.ahead, self.axis.aside].map(|it| normal.dot(it).to_bits());
        let towards = scaled(self.axis.ahead, ahead).plus(scaled(self.axis.aside, aside));
        let (towards, sine) = towards.normalised();
        let sine = sine.to_bits().min(Unit::ONE.to_bits());
        if sine < Unit::ONE.to_bits() >> 8 {
            return Cut::Unknown;
        }
        // The sine is at least 2^-bits.
        let bits = sine.leading_zeros() - 1;
        if height.abs() >= 1 << 30 {
            return Cut::None;
        }
        let height = narrowed(height);
        let Some(distance) = over(height.abs(), Unit::from_bits(sine)).filter(|it| *it <= FURTHEST)
        else {
            return Cut::None;
        };
        let start = scaled(towards, if height < 0 { distance } else { -distance });
        let along = self.normal.crossed(towards);
        let off = (SLACK + (distance >> 25)) << bits;
        Cut::Some(Line {
            start,
            along,
            off,
            start_flat: self.flat(start),
            along_flat: self.flat(along.raw()),
        })
    }

    /// Returns the border at the points of a line between two places, in steps from its start.
    pub(crate) fn border(&self, line: &Line, [from, to]: [i32; 2]) -> Border {
        let middle = (from >> 1) + (to >> 1);
        let off = i64::from(line.off) + ((i64::from(to) - i64::from(from)) >> 1) + 2;
        let [ahead, aside] = [0, 1].map(|axis| {
            let along = Unit::from_bits(line.along_flat[axis]);
            i64::from(line.start_flat[axis]) + i64::from(scaled_by_unit(middle, along))
        });
        Border::of(self.seen(ahead, aside, off))
    }

    /// Returns the border where something begins at a far place of a line or beyond it.
    pub(crate) fn far_border(&self, line: &Line, [place, _]: [i32; 2]) -> Border {
        let [ahead, aside] = line.along_flat.map(i64::from);
        let sign = i64::from(place.signum());
        let [near_ahead, near_aside] = [0, 1].map(|axis| {
            let along = Unit::from_bits(line.along_flat[axis]);
            i64::from(line.start_flat[axis]) + i64::from(scaled_by_unit(place, along))
        });
        let near = self.seen(near_ahead, near_aside, i64::from(line.off));
        match (near, self.seen(sign * ahead, sign * aside, 16)) {
            (Seen::Left, Seen::Left) | (Seen::Right, Seen::Right) => Border::NOWHERE,
            (Seen::Behind, Seen::Behind) => Border::NOWHERE,
            (Seen::At([a, b]), Seen::At([c, d])) => Border::of(Seen::At([a.min(c), b.max(d)])),
            _ => Border::ANYWHERE,
        }
    }
}

impl Line {
    /// Returns where the line cuts a flat shape: at one place, known to lie between two. `way` leads from the line's
    /// start to the shape's centre. The shape is given by its normal and the radius of a ball around it.
    pub(crate) fn cut_flat(
        &self,
        way: Vector,
        (normal, radius): (Direction, i32),
    ) -> Cut<[[i32; 2]; 2]> {
        let (climb, height) = (self.along.dot(normal), way.dot(normal));
        let off = self.off + SLACK;
        match (over(height - off, climb), over(height + off, climb)) {
            (Some(one), Some(other)) => {
                let places = [one.min(other) - 2, one.max(other) + 2];
                let at = self
                    .along
                    .scaled((places[0] >> 1) + (places[1] >> 1))
                    .minus(way);
                let reach = radius + (places[1] >> 1) - (places[0] >> 1) + 2 * off;
                match reach < 0 || at.square() <= unsigned_wide(wide(reach, reach)) {
                    true => Cut::Some([places; 2]),
                    false => Cut::None,
                }
            }
            _ if height.abs() > scaled_by_unit(radius, climb).abs() + 2 * off => Cut::None,
            _ => Cut::Unknown,
        }
    }
}

/// Returns the vector of `length` steps along a direction.
fn scaled(direction: Direction, length: i32) -> Vector {
    let Vector { x, y, z } = direction.raw();
    let [x, y, z] = [x, y, z].map(|it| narrowed(wide(it, length) >> 30));
    Vector::new(x, y, z)
}
