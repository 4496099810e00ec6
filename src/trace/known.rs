//! The ball that all of the camera's rays between two traced ones surely hit first. Where it mirrors them, each path is
//! traced, but not searched for the ball.

use super::origin::Origin;
use super::stops::Stop;
use super::stretch::Between;
use super::{Progress, Stops, Tracer};
use crate::accel::World;
use crate::accel::stretch::Chord;
use crate::qualities::Quality;
use crate::ray::{REACH, Ray};
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE};
use crate::shade::highlight::sealed::Shading;
use crate::shape::bounded::Range;

/// No sphere has this index.
pub(crate) const UNKNOWN: usize = usize::MAX;

impl<W: World, K: Shading, Q: Quality> Tracer<'_, W, K, Q> {
    /// Whether a known ball pays. Where nothing round mirrors, most pixels are interpolated.
    const KNOWS: bool = Self::IS_INTERPOLATED && W::NEEDS.spheres && W::NEEDS.mirrored;

    /// Finds out which ball all rays between two traced ones surely hit first. Rays are not searched for it until
    /// [`Tracer::known`] is [`UNKNOWN`] again.
    #[inline(always)]
    pub(crate) fn know(&mut self, between: Between<'_>, ends: [&Stops; 2]) {
        if Self::KNOWS {
            self.known = self.ball_between(between, ends).unwrap_or(UNKNOWN);
        }
    }

    /// Returns the index of the sphere that all rays between two traced ones surely hit first, from outside.
    ///
    /// The two rays hit it, and it is convex, so all between do. Its points between lie in the triangle of the eye and
    /// both hits, and so on the viewer's side of each plane. Other shapes are told as in an interpolated stretch.
    #[inline(never)]
    fn ball_between(&mut self, between: Between<'_>, ends: [&Stops; 2]) -> Option<usize> {
        let (parts, eye) = (self.world.parts(), self.culling.eye()?);
        let [Some(first), Some(last)] = ends.map(|it| it.all().first()) else {
            return None;
        };
        let ball = parts.spheres.get(first.shape.index())?.ball();
        let is_outside = |end: &Stop| !end.is_inside && end.place.is_near();
        if first.shape != last.shape || !is_outside(first) || !is_outside(last) {
            return None;
        }
        let slack = 2 * parts.epsilon.to_bits() + 8;
        let chord = Chord {
            ball,
            ends: [first, last].map(|end| end.place.point),
            bulge: ball.1 + slack,
            slack,
            is_hollow: false,
        };
        let (front, mut proved) = ((first.shape, Some(chord)), Progress::NONE);
        let is_kept = self.keeps_front(between, &Origin::camera(eye), front, &mut proved);
        is_kept.then_some(first.shape.index())
    }

    /// Returns where a ray of the camera hits the known ball. `None` if no ball is known, or if rounding lets the ray pass by.
    #[inline(always)]
    pub(super) fn known_hit(&self, ray: &Ray) -> Option<Hit> {
        if !Self::KNOWS {
            return None;
        }
        let sphere = self.world.parts().spheres.get(self.known)?;
        let range = Range {
            start: NOWHERE,
            reach: REACH,
        };
        let distance = sphere.met(ray.origin.to(sphere.ball().0), ray.direction, range)?;
        Some(Hit {
            distance,
            shape: ShapeId::at(self.known),
        })
    }
}
