//! The ball that all of the camera's rays between two traced ones surely hit first. Mostly it is a mirror, behind which
//! each path is traced. Where such a ray hits it is computed from the ball alone.

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
pub(super) const NO_BALL: usize = usize::MAX;

impl<W: World, K: Shading, Q: Quality> Tracer<'_, W, K, Q> {
    /// Whether balls are looked for. Where nothing is mirrored, most pixels are interpolated.
    const FINDS_BALLS: bool = Self::IS_INTERPOLATED && W::NEEDS.spheres && W::NEEDS.mirrored;

    /// Finds the ball that all rays between two traced ones surely hit first, and returns whether there is one. Until
    /// [`Tracer::forget_ball`] is called, only rays through the centres of pixels between the two may be traced.
    #[inline(always)]
    pub(crate) fn find_ball(&mut self, between: Between<'_>, ends: [&Stops; 2]) -> bool {
        if Self::FINDS_BALLS {
            self.known_ball = self.ball_between(between, ends).unwrap_or(NO_BALL);
        }
        self.known_ball != NO_BALL
    }

    /// Searches all shapes again for what a ray hits first.
    #[inline(always)]
    pub(crate) fn forget_ball(&mut self) {
        self.known_ball = NO_BALL;
    }

    /// Returns the index of the sphere that all rays between two traced ones surely hit first, from outside.
    ///
    /// The two rays hit it, and it is convex, so all between do. Its points between lie in the triangle of the eye and
    /// both hits. No plane crosses a ray before its hit, so none crosses the triangle. Other shapes are tested as in an
    /// interpolated stretch.
    #[inline(never)]
    fn ball_between(&mut self, between: Between<'_>, ends: [&Stops; 2]) -> Option<usize> {
        let (parts, eye) = (self.world.parts(), self.culling.eye()?);
        let [Some(first), Some(last)] = ends.map(|it| it.all().first()) else {
            return None;
        };
        // Spheres are the first kind, so the index of one is that of its id.
        let index = first.shape.index();
        let (center, radius) = parts.spheres.get(index)?.ball();
        let is_outside = |end: &Stop| !end.is_inside && end.place.is_near();
        if first.shape != last.shape || !is_outside(first) || !is_outside(last) {
            return None;
        }
        let slack = 2 * parts.epsilon.to_bits() + 8;
        let chord = Chord {
            ball: (center, radius + slack),
            ends: [first, last].map(|end| end.place.point),
            bulge: radius + slack,
            slack,
            is_hollow: false,
        };
        let (front, mut proved) = ((first.shape, Some(chord)), Progress::NONE);
        let is_first = self.keeps_front(between, &Origin::camera(eye), front, &mut proved);
        is_first.then_some(index)
    }

    /// Returns where a ray of the camera hits the known ball. `None` if none is known, or if rounding lets the ray pass by.
    #[inline(always)]
    pub(super) fn known_hit(&self, ray: &Ray) -> Option<Hit> {
        if !Self::FINDS_BALLS {
            return None;
        }
        let sphere = self.world.parts().spheres.get(self.known_ball)?;
        let range = Range {
            start: NOWHERE,
            reach: REACH,
        };
        let distance = sphere.met(ray.origin.to(sphere.ball().0), ray.direction, range)?;
        Some(Hit {
            distance,
            shape: ShapeId::at(self.known_ball),
        })
    }
}
