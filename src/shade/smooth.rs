//! Whether a highlight can be interpolated between two points of a surface.
//!
//! A highlight is a power s of the cosine of an angle δ, about exp(-s δ² / 2). Between two points the
//! vector of length δ changes along a line, almost. The highlight is smooth if that change is small
//! against 1 / √s. It is dark if the line stays away from zero.

use super::highlight::sealed::Shading;
use crate::number::{
    Exponent, Unit, narrowed_unsigned, ratio, square_root, unit_product, unsigned, unsigned_wide,
    wide, wide_unsigned,
};
use crate::vector::{Direction, Vector};

/// What a highlight depends on at one point of a surface.
#[derive(Debug)]
pub struct Glance {
    /// The normal on the viewer's side.
    pub(crate) normal: Direction,
    /// Direction of the ray that hit the surface.
    pub(crate) view: Direction,
    /// Direction from the light to the surface.
    pub(crate) along: Direction,
}

impl Glance {
    /// Returns the unit vector half way between the directions to the light and to the viewer, in Q4.28.
    pub(super) fn half_way(&self) -> Vector {
        let sum = quarter(self.view).plus(quarter(self.along));
        let (direction, _) = sum.normalised();
        quarter(direction.reversed())
    }

    /// Returns the squared length of half the sum of the directions to the light and to the viewer.
    pub(super) fn half_square(&self) -> Unit {
        Unit::from_bits((1 << 29) + (self.view.dot(self.along).to_bits() >> 1))
    }
}

/// How much the normal and the directions to the light and to the eye turn between two points of a surface.
pub struct Turns {
    /// Lengths of the changes of the normal and of the directions to the light and to the eye, Q2.30.
    pub(crate) normal: i32,
    pub(crate) light: i32,
    pub(crate) view: i32,
    /// Radius of the circle on which the normals turn. The directions turn on circles of radius 1.
    pub(crate) circle: Unit,
}

impl Turns {
    /// Returns by how much the vector that a highlight depends on may be off a straight line, in Q4.28. `square` is at most
    /// the squared length of half the sum of the directions to light and viewer at both points, if the highlight depends on
    /// the direction of that sum, else 1. `None` if they turn too much.
    ///
    /// A chord c of a circle of radius k is off the arc by c² / (8 k), and by a fifteenth more up to 60 degrees. Twice that is
    /// taken for the sum of all three, because they do not turn in step. The direction of a sum turns by no more than the
    /// sum moves over its least length. Between two points of at least the length m, the line of a sum that moves by c keeps
    /// the length √(m² - c² / 4), and the sum is off that line by less than c² / 4.
    pub(super) fn bend(&self, square: Unit) -> Option<i32> {
        // Half of each, so that the sum fits.
        let moved = Unit::from_bits((self.light >> 1) + (self.view >> 1) + 2);
        let half = moved.to_bits().saturating_add((self.normal >> 1) + 1);
        let half = Some(Unit::from_bits(half)).filter(|half| *half < Unit::ONE)?;
        let moved = unit_product(moved, moved).to_bits();
        // A quarter of the sum's squared length, up to 1.
        let least = (square.to_bits() - (moved - (moved >> 2))).clamp(0, 1 << 28);
        let circle = unit_product(self.circle, Unit::from_bits(4 * least));
        let square = unit_product(half, half);
        let bits = |it: Unit| unsigned(it.to_bits());
        (square < circle).then(|| ratio(bits(square), bits(circle)) >> 2)
    }
}

/// Returns a direction in Q4.28.
pub(super) fn quarter(direction: Direction) -> Vector {
    let Vector { x, y, z } = direction.raw();
    Vector::new(x >> 2, y >> 2, z >> 2)
}

/// How many pixels of a stretch show how its colours change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Samples {
    /// Both ends, and one half way.
    Three,
    /// These, and one half way between each two.
    Five,
    /// No fewer than all.
    All,
}

/// Largest square of the change times s, in Q2.30, for which three pixels show how a highlight changes.
const SMOOTH: u64 = 1 << 29;

/// Largest square of the change and its bend times s, in Q34.30, for which five pixels show it.
const BENT: u64 = 6 << 30;

/// Smallest square of the distance from zero times s, in Q34.30, for which a highlight is dark: below e⁻⁸.
const DARK: u64 = 16 << 30;

/// Returns how many pixels show how a highlight changes between two points, from its deviations there in Q4.28.
/// Between them, the deviation is at most `bend` off the line, in Q4.28.
pub(super) fn samples([one, other]: [Vector; 2], bend: i32, shininess: Exponent) -> Samples {
    let change = other.minus(one);
    let shininess = u64::from(shininess.next_integer());
    let square = (change.square() >> 26) * shininess;
    if square <= SMOOTH {
        return Samples::Three;
    }
    let nearest = nearest(one, other, change) - bend;
    if nearest > 0 && (unsigned_wide(wide(nearest, nearest)) >> 26) * shininess >= DARK {
        return Samples::Three;
    }
    if square <= BENT { Samples::Five } else { Samples::All }
}

/// Tests whether a highlight has a step or a kink where it begins. A power below 2 of the cosine to the mirrored light
/// has; the cosine to the half-way vector is above 0 wherever light and viewer see the surface.
pub(crate) fn begins_sharply<K: Shading>(shininess: Exponent) -> bool {
    K::TURNS > 0 && shininess.next_integer() <= 2
}

/// Tests whether a highlight may begin or end between two points with these deviations, in Q4.28. Between them, the
/// deviation is at most `bend` off a straight line. A highlight begins at a deviation of length √2, a right angle.
pub(super) fn may_begin([one, other]: [Vector; 2], bend: i32) -> bool {
    /// √2 in Q4.28, and what both bounds may be off.
    const RIGHT_ANGLE: i32 = 379_625_062;
    const OFF: i32 = 1 << 12;
    let farthest = square_root(one.square().max(other.square())) + bend + OFF;
    let nearest = nearest(one, other, other.minus(one)) - bend - OFF;
    nearest <= RIGHT_ANGLE && RIGHT_ANGLE <= farthest
}

/// Tests whether three pixels show how a highlight changes, if the vectors that it depends on change by at most
/// `change`, in Q4.28.
pub(crate) fn is_little(change: i32, shininess: Exponent) -> bool {
    let square = unsigned_wide(wide(change, change)) >> 26;
    square * u64::from(shininess.next_integer()) <= SMOOTH
}

/// Returns the distance of the line between two points from zero, in Q4.28.
fn nearest(one: Vector, other: Vector, change: Vector) -> i32 {
    let dot = |a: Vector, b: Vector| wide(a.x, b.x) + wide(a.y, b.y) + wide(a.z, b.z);
    let (start, end) = (dot(one, change), dot(other, change));
    if start >= 0 {
        return square_root(one.square());
    }
    if end <= 0 {
        return square_root(other.square());
    }
    // The nearest point lies at the share start / (start - end) of the line.
    let (back, whole) = (start.unsigned_abs(), change.square());
    let drop = 34_u32.saturating_sub(whole.leading_zeros());
    let share = ratio(
        narrowed_unsigned(back >> drop),
        narrowed_unsigned(whole >> drop).max(1),
    );
    let along = wide_unsigned(narrowed_unsigned(back >> 28), share.unsigned_abs()) >> 2;
    square_root(one.square().saturating_sub(along))
}

#[cfg(test)]
mod tests;
