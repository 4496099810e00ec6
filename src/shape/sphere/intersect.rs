//! Where a ray meets a sphere, and whether it does.

use super::PreparedSphere;
use crate::number::{Length, signed_wide, square_root, unsigned_wide, wide};
use crate::ray::Ray;
use crate::vector::{Direction, Vector};

/// Up to how deep inside, in steps, a ray starts on the surface, but for rounding: it is lifted by two
/// steps at least, and each coordinate of a hit is rounded by up to two.
const ON_SURFACE: i64 = 4;

impl PreparedSphere {
    /// The distance at which a ray meets the sphere, above `start` and below `reach`; from inside
    /// where it enters before `start`.
    #[inline(always)]
    pub(crate) fn met(
        &self,
        way: Vector,
        direction: Direction,
        start: Length,
        reach: Length,
    ) -> Option<Length> {
        let distance = way.dot(direction);
        if distance - self.radius >= reach.to_bits() {
            return None;
        }
        let nearest = way.without(direction, distance);
        let half_chord_square = self.square - signed_wide(nearest.square());
        if half_chord_square < 0 {
            return None;
        }
        // Of nothing it may be one.
        let half_chord = square_root(unsigned_wide(half_chord_square) | 1);
        let entry = distance - half_chord;
        let met = if entry > start.to_bits() {
            entry
        } else {
            distance + half_chord
        };
        (start.to_bits() < met && met < reach.to_bits()).then_some(Length::from_bits(met))
    }

    /// The distance at which the ray meets the sphere from outside, or else from inside, above 0
    /// and below `reach`.
    #[cfg(test)]
    pub(crate) fn intersect_alone(&self, ray: &Ray, reach: Length) -> Option<Length> {
        let way = ray.origin.to(self.center);
        if way.dot(ray.direction) < -self.radius {
            return None;
        }
        self.met(way, ray.direction, Length::from_bits(0), reach)
    }

    /// Whether the ray meets the sphere above 0 and below `reach`; no root is taken. A ray that starts on the surface, but for rounding, and goes out is not blocked.
    pub(super) fn is_on(&self, ray: &Ray, reach: Length) -> bool {
        let way = ray.origin.to(self.center);
        let distance = way.dot(ray.direction);
        if distance < -self.radius || distance - self.radius > reach.to_bits() {
            return false;
        }
        let nearest = way.without(ray.direction, distance);
        let half_chord_square = self.square - signed_wide(nearest.square());
        if half_chord_square < 0 {
            return false;
        }
        let past = distance - reach.to_bits();
        let entry_is_ahead = distance > 0 && wide(distance, distance) > half_chord_square;
        if entry_is_ahead {
            past < 0 || wide(past, past) < half_chord_square
        } else {
            // r² less the square of the way to the centre; r² - (r - depth)² is 2 r depth or less.
            let inside = half_chord_square - wide(distance, distance);
            let exit_is_ahead = distance > 0 || inside > ON_SURFACE * 2 * self.radius as i64;
            exit_is_ahead && past < 0 && wide(past, past) > half_chord_square
        }
    }
}
