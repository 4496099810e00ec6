//! The ball that all of the camera's rays between two traced ones surely hit first. These rays are tested against no other
//! shape. It saves most where the ball is a mirror, because each pixel that shows one is traced.

use super::origin::Origin;
use super::stops::Stop;
use super::stretch::Between;
use super::{Progress, Stops, Tracer};
use crate::accel::World;
use crate::accel::stretch::Chord;
use crate::number::Length;
use crate::qualities::Quality;
use crate::ray::{REACH, Ray};
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE};
use crate::shade::highlight::sealed::Shading;
use crate::shape::bounded::Range;
use crate::shape::sphere::PreparedSphere;

/// Largest number of bounded shapes among which balls are looked for. Among more, balls are small.
const MOST_SHAPES: usize = 16;

/// No sphere has this index.
pub(super) const NO_BALL: usize = usize::MAX;

impl<W: World, K: Shading, Q: Quality> Tracer<'_, W, K, Q> {
    /// Tests whether balls are looked for: in scenes with mirrors and few shapes. Without mirrors, most pixels are
    /// interpolated. For a constant scene, this is a constant.
    #[inline(always)]
    pub(crate) fn finds_balls(&self) -> bool {
        let is_traced = Self::IS_INTERPOLATED && W::NEEDS.spheres && W::NEEDS.mirrored;
        is_traced && self.world.parts().bounded() <= MOST_SHAPES
    }

    /// Looks for the ball that all of the camera's rays between two traced ones surely hit first. Returns whether there is
    /// one. Until [`Tracer::forget_ball`], only rays through the centres of pixels between the two may be traced.
    #[inline(never)]
    pub(crate) fn find_ball(&mut self, between: Between<'_>, ends: [&Stops; 2]) -> bool {
        self.known_ball = NO_BALL;
        let (parts, eye) = (self.world.parts(), self.culling.eye());
        let chord = chord_in_ball(parts.spheres, parts.epsilon, ends);
        if let (Some(eye), Some((ball, chord))) = (eye, chord) {
            let (front, mut proved) = ((ball, Some(chord)), Progress::NONE);
            if self.keeps_front(between, &Origin::camera(eye), front, &mut proved) {
                self.known_ball = ball.index();
            }
        }
        self.known_ball != NO_BALL
    }

    /// Forgets the ball: all shapes are tested again for what a ray hits first.
    #[inline(always)]
    pub(crate) fn forget_ball(&mut self) {
        self.known_ball = NO_BALL;
    }

    /// Returns the first hit of a camera's ray if it is on a known ball. `None` if no ball is known, or if the ray misses it
    /// because of rounding; then all shapes have to be tested.
    #[inline(always)]
    pub(super) fn known_hit(&self, ray: &Ray) -> Option<Hit> {
        if !self.finds_balls() {
            return None;
        }
        let sphere = self.world.parts().spheres.get(self.known_ball)?;
        // Hides from the compiler that it is the same ray. Else it keeps the direction's signs, and each later product
        // takes three instructions instead of one.
        let ray = core::hint::black_box(ray);
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

/// Returns the sphere that two paths hit first, and the chord between the two hits. `None` if they hit another shape, two
/// shapes, or the inside of one. The chord's bounds are those of the whole sphere, however much it turns between the hits.
///
/// The sphere is convex, so all rays between the two hit it. Its points between lie in the triangle of the eye and both
/// hits. No plane crosses a ray before its hit, so none crosses the triangle. Other shapes are tested as in an
/// interpolated stretch. Compiled once, not for each scene.
#[inline(never)]
fn chord_in_ball(
    spheres: &[PreparedSphere],
    epsilon: Length,
    ends: [&Stops; 2],
) -> Option<(ShapeId, Chord)> {
    let [Some(first), Some(last)] = ends.map(|it| it.all().first()) else {
        return None;
    };
    // Spheres are the first kind, so the index of one is that of its id.
    let (center, radius) = spheres.get(first.shape.index())?.ball();
    let is_outside = |end: &Stop| !end.is_inside && end.place.is_near();
    if first.shape != last.shape || !is_outside(first) || !is_outside(last) {
        return None;
    }
    let slack = 2 * epsilon.to_bits() + 8;
    let chord = Chord {
        ball: (center, radius + slack),
        ends: [first, last].map(|end| end.place.point),
        bulge: radius + slack,
        slack,
        is_hollow: false,
    };
    Some((first.shape, chord))
}
