//! Helpers for the tests of all shapes: rays, and vectors in double precision.

pub(super) mod fans;
pub(super) mod rows;

pub(super) use std::vec::Vec;

use crate::number::Length;
use crate::number::sweep::Sweep;
use crate::ray::{NEAR, REACH, Ray};
use crate::vector::{Direction, Point, Vector};

/// Largest error of a hit along its ray, in steps, for shapes within 2²⁹·⁵ steps of the ray's origin.
/// The direction's length is within 2⁻²⁷ of one.
pub(super) const SLACK: f64 = 8.0;

/// Creates a point from raw steps.
pub(super) fn point([x, y, z]: [i32; 3]) -> Point {
    Point::new(x, y, z)
}

/// Returns the direction of a vector that is not zero, exact to the last places.
pub(super) fn direction([x, y, z]: [i32; 3]) -> Direction {
    assert_ne!([x, y, z], [0; 3]);
    Vector::new(x, y, z).precise_direction()
}

/// Creates a ray from `origin`, in raw steps, in the direction of the vector `towards`.
pub(super) fn ray(origin: [i32; 3], towards: [i32; 3]) -> Ray {
    Ray {
        origin: point(origin),
        direction: direction(towards),
    }
}

/// Returns a random ray from a near point to a point within `aim` steps of `target` in each coordinate.
///
/// The direction is rounded as for a ray from a camera or a light, not corrected to the last bit.
pub(super) fn ray_towards(sweep: &mut Sweep, target: [i32; 3], aim: i32) -> Ray {
    let origin = point(sweep.triple(NEAR));
    let [x, y, z] = sweep.triple(aim);
    let [tx, ty, tz] = target;
    let aimed_at = Point::new(tx + x, ty + y, tz + z);
    Ray {
        origin,
        direction: origin.to(aimed_at).direction_and_length().0,
    }
}

/// Returns a random direction.
pub(super) fn any_direction(sweep: &mut Sweep) -> Direction {
    let [x, y, z] = sweep.triple(1 << 28);
    Vector::new(x, y, z | 1).direction_and_length().0
}

/// Converts the distance of a hit to raw steps.
pub(super) fn steps(distance: Option<Length>) -> Option<i32> {
    distance.map(Length::to_bits)
}

/// Largest distance of a hit: the full length of a near ray.
pub(super) const EVERYWHERE: Length = REACH;

/// Vector in double precision.
pub(super) type Triple = [f64; 3];

/// Converts a vector to double precision.
pub(super) fn in_doubles(vector: Vector) -> Triple {
    [vector.x, vector.y, vector.z].map(f64::from)
}

pub(super) fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(super) fn length(a: Triple) -> f64 {
    dot(a, a).sqrt()
}

/// Returns `a` + `factor` · `b`.
pub(super) fn plus(a: Triple, factor: f64, b: Triple) -> Triple {
    [0, 1, 2].map(|axis| a[axis] + factor * b[axis])
}

pub(super) fn unit(a: Triple) -> Triple {
    a.map(|coordinate| coordinate / length(a))
}

/// Returns the distances at which a line crosses a surface, in order: `middle` minus and plus half a
/// chord. Empty if the square of half the chord is negative, because the line misses.
pub(super) fn roots(middle: f64, half_chord_square: f64) -> Vec<f64> {
    if half_chord_square < 0.0 {
        return Vec::new();
    }
    let half_chord = half_chord_square.sqrt();
    [middle - half_chord, middle + half_chord].into()
}
