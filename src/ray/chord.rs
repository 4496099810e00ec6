//! The chord in which a plane cuts a disc.

use super::line::Cut;
use super::row_plane::SLACK;
use super::shadows::Shadows;
use crate::number::{Unit, over, root_of_square, scaled_by_unit, unsigned_wide, wide};
use crate::vector::{Direction, Vector};

/// The chord in which a plane through a point cuts a disc.
#[derive(Clone, Copy, Debug)]
pub struct ChordLine {
    /// Vector from the point to the middle of the chord.
    middle: Vector,
    along: Direction,
    /// Half of the length: at least and at most.
    half: [i32; 2],
    /// What a point of the chord may be off by across it, in steps.
    off: i32,
}

impl ChordLine {
    /// Returns the chord of a disc and a plane with this normal. `way` leads from a point of the plane to the
    /// disc's centre; `disc` is its normal and radius.
    #[inline(never)]
    pub(crate) fn of(plane: Direction, way: Vector, disc: (Direction, i32)) -> Cut<Self> {
        let (normal, radius) = disc;
        let across = normal.crossed_with(plane.raw());
        let apart = way.dot(plane);
        let (along, sine) = across.normalised();
        let sine = Unit::from_bits(sine.to_bits().min(Unit::ONE.to_bits()));
        if apart.abs() > scaled_by_unit(radius + SLACK, sine) + SLACK {
            return Cut::None;
        }
        if sine < Unit::from_bits(1 << 26) {
            return Cut::Unknown;
        }
        // A distance from the plane is off by SLACK, and the chord by as much over the sine.
        let bits = sine.to_bits().leading_zeros() - 1;
        let off = SLACK << bits;
        let Some(offset) = over(apart, sine) else {
            return Cut::None;
        };
        let half = |radius: i32, offset: i32| {
            let square = wide(radius, radius) - wide(offset, offset);
            root_of_square(unsigned_wide(square.max(0)))
        };
        let outer = half(radius + off, (offset.abs() - off).max(0)) + 2;
        let inner = half((radius - off).max(0), offset.abs() + off);
        let towards = normal.crossed(along);
        Cut::Some(Self {
            middle: way.plus(towards.scaled(offset)),
            along,
            half: [inner, outer],
            off,
        })
    }

    /// Returns an end of the chord, and what it may be off by. `sign` says which end.
    fn end(&self, sign: i32) -> (Vector, i32) {
        let [inner, outer] = self.half;
        let half = (inner >> 1) + (outer >> 1);
        let end = self.middle.plus(self.along.scaled(sign * half));
        (end, self.off + ((outer - inner) >> 1) + 2)
    }
}

impl Shadows<'_> {
    /// The shadow of a disc ends with those of the ends of a chord, which is given from the start of the line.
    pub(crate) fn chord(&mut self, chord: Cut<ChordLine>) {
        let chord = match chord {
            Cut::None => return,
            Cut::Unknown => return self.borders.end(),
            Cut::Some(chord) => chord,
        };
        let (line, lamp) = (self.line, self.lamp);
        for sign in [-1, 1] {
            let (end, off) = chord.end(sign);
            let off = off + line.off;
            let around = |axis: Direction| {
                let place = end.dot(axis);
                [place - off, place + off]
            };
            self.corners([around(line.along), around(lamp.up)]);
        }
    }
}
