//! The rays from a light or an eye to a stretch of a surface: those to its two ends, and bounds of all between.

use crate::number::{Length, Unit, narrowed_unsigned, ratio, signed, square_root, unsigned};
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

    /// Returns bounds of all rays to a curve between the two places. The curve is at most `bulge` steps away from the
    /// straight line.
    ///
    /// The directions to that line lie on an arc of radius 1. It is 1 - √(1 - c²/4) away from its chord c: up to a right
    /// angle, at most 5/32 c². The direction to a point of the curve is off the arc by the bulge over the distance.
    pub(crate) fn spread(&self, bulge: i32) -> Spread {
        let [first, last] = self.ends;
        let square = last.raw().minus(first.raw()).square();
        let arc = (square >> 33) + (square >> 35) + 1;
        let [one, other] = self.reaches;
        let nearest = unsigned(one.min(other).to_bits().max(1));
        let thickness = bulge + SLACK;
        let aside = if unsigned(thickness) < nearest && self.turn < Unit::ONE {
            ratio(unsigned(thickness), nearest)
        } else {
            Unit::ONE.to_bits()
        };
        Spread {
            ends: self.ends,
            least: one.min(other).to_bits() - thickness,
            most: one.max(other).to_bits().saturating_add(thickness),
            thickness,
            aside: Unit::from_bits(aside + signed(narrowed_unsigned(arc))),
        }
    }
}

/// Bounds of all rays from a point to a curve.
#[derive(Clone, Copy, Debug)]
pub struct Spread {
    /// Directions to the two ends of the curve.
    pub(crate) ends: [Direction; 2],
    /// Lower bound of the rays' lengths, in steps.
    pub(crate) least: i32,
    /// Upper bound of the rays' lengths, in steps.
    pub(crate) most: i32,
    /// Upper bound of the distance of a ray from the triangle between the rays to the two ends, in steps.
    pub(crate) thickness: i32,
    /// Upper bound of the distance of a ray's direction from the straight line between the directions to the two ends.
    pub(crate) aside: Unit,
}

/// Returns the length of the difference of two directions; 1 if the angle between them is a right one or larger.
pub(crate) fn turn_between(first: Direction, last: Direction) -> Unit {
    let square = first.change_to(last).map(Vector::square);
    square.map_or(Unit::ONE, |square| Unit::from_bits(square_root(square)))
}
