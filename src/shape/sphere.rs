//! Spheres.
//!
//! The nearest approach of the ray's line to the centre is worked out as a vector, and the
//! discriminant is r² minus its square (Haines, Günther, Akenine-Möller, "Precision Improvements
//! for Ray/Sphere Intersection", Ray Tracing Gems, chapter 7): an error along the ray does not
//! count, so a small sphere far away keeps a clean edge.

use super::{MaterialId, Normaliser};
use crate::number::{Length, Number, square_root};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Position, Vector};

/// A sphere as it is described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sphere {
    /// Its middle.
    pub center: Position,
    /// Its radius, greater than 0.
    pub radius: Number,
    /// What it is made of.
    pub material: MaterialId,
}

impl Sphere {
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        radius: Number::ZERO,
        material: MaterialId(0),
    };
}

/// A sphere as the kernels read it: inside the ball.
#[derive(Clone, Copy, Debug)]
pub struct PreparedSphere {
    center: Point,
    radius: i32,
    /// radius²
    square: i64,
    normaliser: Normaliser,
    pub(crate) material: MaterialId,
}

/// Where a ray's line comes nearest to a sphere's centre, for a line that meets the sphere.
struct Approach {
    /// Distance along the ray, in steps.
    distance: i32,
    /// The square of half the chord, in steps.
    half_chord_square: i64,
}

impl PreparedSphere {
    /// Fills the room of a sphere that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self::new(Point::ORIGIN, Length::from_bits(4), MaterialId(0));

    /// A sphere inside the ball with a radius of at least 4 steps.
    pub(crate) const fn new(center: Point, radius: Length, material: MaterialId) -> Self {
        let raw = radius.to_bits();
        let normaliser = Normaliser::new(radius);
        Self {
            center,
            radius: raw,
            square: raw as i64 * raw as i64,
            normaliser,
            material,
        }
    }

    /// Its middle and radius.
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.radius)
    }

    /// `None` where the line misses, or the sphere lies behind or beyond `reach` as a whole.
    fn approach(&self, ray: &Ray, reach: Length) -> Option<Approach> {
        let center = ray.origin.to(self.center);
        let distance = center.dot(ray.direction);
        if distance < -self.radius || distance - self.radius > reach.to_bits() {
            return None;
        }
        let nearest = center.without(ray.direction, distance);
        let half_chord_square = self.square - nearest.square() as i64;
        (half_chord_square >= 0).then_some(Approach {
            distance,
            half_chord_square,
        })
    }

    /// The distance at which the ray meets the sphere from outside, or else from inside, above 0
    /// and below `reach`.
    pub(crate) fn intersect(&self, ray: &Ray, reach: Length) -> Option<Length> {
        let Approach {
            distance,
            half_chord_square,
        } = self.approach(ray, reach)?;
        let half_chord = square_root(half_chord_square as u64);
        let entry = distance - half_chord;
        let met = if entry > 0 {
            entry
        } else {
            distance + half_chord
        };
        (0 < met && met < reach.to_bits()).then_some(Length::from_bits(met))
    }

    /// Whether the ray meets the sphere above 0 and below `reach`; no root is taken.
    pub(crate) fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        let Some(Approach {
            distance,
            half_chord_square,
        }) = self.approach(ray, reach)
        else {
            return false;
        };
        let distance = i64::from(distance);
        let past = distance - i64::from(reach.to_bits());
        let entry_is_ahead = distance > 0 && distance * distance > half_chord_square;
        if entry_is_ahead {
            past < 0 || past * past < half_chord_square
        } else {
            let exit_is_ahead = distance > 0 || distance * distance < half_chord_square;
            exit_is_ahead && past < 0 && past * past > half_chord_square
        }
    }

    /// The outward normal at a point of the sphere.
    pub(crate) const fn normal(&self, at: Point) -> Direction {
        self.normaliser.direction(self.outward(at))
    }

    const fn outward(&self, at: Point) -> Vector {
        self.center.to(at)
    }
}

#[cfg(test)]
mod tests;
