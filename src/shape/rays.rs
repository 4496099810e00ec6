//! The rays from a light or an eye to a stretch of a surface: those to its two ends, and all of them as one thick ray.

use crate::number::{
    Length, Unit, narrowed_unsigned, ratio, scaled_by_unit, signed, square_root, unsigned,
};
use crate::ray::{REACH, ScaledPoint};
use crate::vector::{Direction, Vector};

/// What a distance is enlarged by, in steps, because products are rounded.
pub(crate) const SLACK: i32 = 64;

/// Rays from a point, the apex, to two places.
#[derive(Clone, Copy, Debug)]
pub struct Rays {
    pub(crate) apex: ScaledPoint,
    pub(crate) places: [ScaledPoint; 2],
    /// Directions from the apex to the two places.
    pub(crate) ends: [Direction; 2],
    /// Distances from the apex to the two places, in steps; [`REACH`] if they are far.
    pub(crate) reaches: [Length; 2],
    /// Length of the difference of the two directions; 1 if the angle between them is a right one or larger.
    pub(crate) turn: Unit,
}

impl Rays {
    /// Returns the rays from an apex to two places.
    pub(crate) fn new(apex: ScaledPoint, places: [ScaledPoint; 2]) -> Self {
        let [one, other] = places.map(|place| {
            let (way, scale) = apex.to(place);
            let (direction, length) = way.normalised();
            (direction, if scale == 0 { length } else { REACH })
        });
        Self {
            apex,
            places,
            ends: [one.0, other.0],
            reaches: [one.1, other.1],
            turn: turn_between(one.0, other.0),
        }
    }

    /// Returns a beam that holds all rays to a curve between the two places. The curve is at most `bulge` steps away from
    /// the straight line. `None` if a place is far, or if the angle between the rays is larger than 20 degrees.
    pub(crate) fn beam(&self, bulge: i32) -> Option<Beam> {
        let [first, _] = self.ends;
        let reach = self.reaches[0].max(self.reaches[1]);
        (reach < REACH && self.turn <= WIDEST_BEAM).then(|| {
            let width = scaled_by_unit(reach.to_bits(), self.turn) + bulge + SLACK;
            Beam {
                first,
                width,
                end: reach.to_bits().saturating_add(width),
            }
        })
    }

    /// Returns by how much a coordinate of a direction between the two may exceed theirs.
    ///
    /// The directions from end to end lie on an arc. It bulges by at most an eighth of the square of its
    /// chord; a ray to a curve is off the triangle by the curve's bulge over the distance.
    pub(crate) fn widening(&self, bulge: i32) -> Unit {
        let [first, last] = self.ends;
        let chord = (last.raw().minus(first.raw()).square() >> 33) + 1;
        let [one, other] = self.reaches;
        let nearest = unsigned(one.min(other).to_bits().max(1));
        let thickness = unsigned(bulge + SLACK);
        let aside = match thickness < nearest {
            true => ratio(thickness, nearest),
            false => Unit::ONE.to_bits(),
        };
        Unit::from_bits(aside + signed(narrowed_unsigned(chord)))
    }
}

/// Returns the length of the difference of two directions; 1 if the angle between them is a right one or larger.
pub(crate) fn turn_between(first: Direction, last: Direction) -> Unit {
    let square = first.change_to(last).map(Vector::square);
    square.map_or(Unit::ONE, |square| Unit::from_bits(square_root(square)))
}

/// One thick ray that holds all rays from a point, the apex, to a curve.
#[derive(Clone, Copy, Debug)]
pub struct Beam {
    /// Direction of the thick ray: that to one end of the curve.
    pub(crate) first: Direction,
    /// Its radius in steps.
    pub(crate) width: i32,
    /// Where it ends: a distance from the apex in steps.
    pub(crate) end: i32,
}

/// Largest angle between the rays of a beam, as the length of the difference of their directions: about 20 degrees.
const WIDEST_BEAM: Unit = Unit::from_bits(3 << 27);

impl Beam {
    /// Tests whether a ball surely lies outside of the beam, so that all rays miss it. `way` is the vector from the apex to
    /// the ball's centre.
    #[inline(always)]
    pub(crate) fn avoids_ball(&self, way: Vector, radius: i32) -> bool {
        let along = way.dot(self.first);
        along > self.end.saturating_add(radius) || way.passes_by(along, radius + self.width)
    }
}
