//! Hits of a ray on a sphere: the distance to the hit, and whether the sphere blocks a ray.

use super::PreparedSphere;
use crate::number::{Length, root_of_square, signed_wide, unsigned_wide, wide};
use crate::ray::Ray;
use crate::shape::bounded::Range;
use crate::vector::{Direction, Vector};

/// Depth below a sphere's surface, in steps, down to which a ray counts as starting on the surface. A
/// ray starts at least two steps above a surface, and each coordinate of a hit is rounded by up to two
/// steps.
const ON_SURFACE: i64 = 4;

impl PreparedSphere {
    /// Returns the distance of a ray's first hit within `range`. If the ray enters the sphere before the
    /// start of the range, the hit is where it leaves. `way` is the vector from the ray's origin to
    /// the centre.
    #[inline(always)]
    pub(crate) fn met(&self, way: Vector, direction: Direction, range: Range) -> Option<Length> {
        let Range { start, reach } = range;
        let distance = way.dot(direction);
        if distance - self.radius >= reach.to_bits() {
            return None;
        }
        let nearest = way.without(direction, distance);
        let half_chord_square = self.square - signed_wide(nearest.square());
        if half_chord_square < 0 {
            return None;
        }
        // The lowest bit is set, so that the root needs no test for zero. The root of 0 becomes 1 at
        // most.
        let half_chord = root_of_square(unsigned_wide(half_chord_square) | 1);
        let entry = distance - half_chord;
        let met = if entry > start.to_bits() { entry } else { distance + half_chord };
        // Two branches take fewer instructions than one condition.
        if met <= start.to_bits() {
            return None;
        }
        if met >= reach.to_bits() {
            return None;
        }
        Some(Length::from_bits(met))
    }

    /// Tests whether the ray hits the sphere at a distance above 0 and below `reach`. Takes no root. A
    /// ray that starts on the surface, within rounding, and goes outwards does not hit it.
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
            // r² minus the square of the distance to the centre. At a depth below the surface it is
            // r² - (r - depth)², which is 2 r depth or less.
            let inside = half_chord_square - wide(distance, distance);
            let exit_is_ahead = distance > 0 || inside > ON_SURFACE * 2 * self.radius as i64;
            exit_is_ahead && past < 0 && wide(past, past) > half_chord_square
        }
    }
}
