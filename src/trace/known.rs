//! The ball that all of the camera's rays between two traced ones surely hit first. Where it mirrors them, each path is
//! traced, but not searched for the ball.

use super::origin::Origin;
use super::stretch::Between;
use super::{Progress, Stops, Tracer};
use crate::accel::World;
use crate::accel::stretch::{Body, Chord, Stretch};
use crate::qualities::Quality;
use crate::ray::{REACH, Ray};
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE};
use crate::shade::highlight::sealed::Shading;
use crate::shape::bounded::Range;

/// No sphere has this index.
pub(super) const UNKNOWN: usize = usize::MAX;

impl<W: World, K: Shading, Q: Quality> Tracer<'_, W, K, Q> {
    /// Whether a known ball pays. Where nothing round mirrors, most pixels are interpolated.
    const KNOWS: bool = Self::IS_INTERPOLATED && W::NEEDS.spheres && W::NEEDS.mirrored;

    /// Finds out which ball all rays between two traced ones surely hit first. Rays are not searched for it until
    /// [`Tracer::forget`] is called.
    #[inline(always)]
    pub(crate) fn know(&mut self, between: Between<'_>, ends: [&Stops; 2]) {
        if Self::KNOWS {
            self.known = self.ball_between(between, ends).unwrap_or(UNKNOWN);
        }
    }

    /// Searches what rays hit again.
    #[inline(always)]
    pub(crate) fn forget(&mut self) {
        self.known = UNKNOWN;
    }

    /// Returns the index of the sphere that all rays between two traced ones surely hit first, from outside.
    ///
    /// The two rays hit it, and it is convex, so all between do. Its points between lie in the triangle of the eye and
    /// both hits, and so on the viewer's side of each plane. Other shapes are told as in an interpolated stretch.
    #[inline(never)]
    fn ball_between(&mut self, between: Between<'_>, ends: [&Stops; 2]) -> Option<usize> {
        let parts = self.world.parts();
        let (eye, row) = self.culling.eye()?;
        let [Some(first), Some(last)] = ends.map(|it| it.all().first()) else {
            return None;
        };
        let is_outside = [first, last]
            .iter()
            .all(|it| !it.is_inside && it.place.is_near());
        let sphere = first.shape.index();
        let ball = parts.spheres.get(sphere)?.ball();
        if first.shape != last.shape || !is_outside {
            return None;
        }
        let slack = 2 * parts.epsilon.to_bits() + 8;
        let stretch = Stretch {
            columns: between.1,
            shape: first.shape,
            body: Body::Ball(ball),
            chord: Some(Chord {
                ball,
                ends: [first, last].map(|it| it.place.point),
                bulge: ball.1 + slack,
                slack,
            }),
            eye: Some(eye),
            mirror: None,
        };
        let origin = Origin {
            eye,
            row,
            level: 0,
            mirror: None,
        };
        let mut proved = Progress::NONE;
        self.keeps(between, &origin, &stretch, &mut proved)
            .then_some(sphere)
    }

    /// Returns where a ray of the camera hits the known ball. `None` if no ball is known, or if rounding lets the ray pass by.
    #[inline(always)]
    pub(super) fn known_hit(&self, ray: &Ray) -> Option<Hit> {
        if !Self::KNOWS {
            return None;
        }
        let sphere = self.world.parts().spheres.get(self.known)?;
        let (center, _) = sphere.ball();
        let range = Range {
            start: NOWHERE,
            reach: REACH,
        };
        let distance = sphere.met(ray.origin.to(center), ray.direction, range)?;
        Some(Hit {
            distance,
            shape: ShapeId::at(self.known),
        })
    }
}
