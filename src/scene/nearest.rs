//! What a near ray meets first of the spheres and cylinders, wherever it comes from.

use super::World;
use super::ahead::MirrorSet;
use super::query::{Hit, ShapeId};
use crate::number::Length;
use crate::ray::{PathSignature, REACH, Ray};
use crate::shape::cylinder::{CylinderFromPoint, PreparedCylinder};
use crate::shape::sphere::{PreparedSphere, SphereFromPoint};
use crate::vector::{Direction, Vector};

/// No distance at all.
pub(crate) const NOWHERE: Length = Length::from_bits(0);

/// What lies ahead of a ray that a shape has mirrored, as far as that is known.
#[inline(always)]
pub(crate) fn ahead<W: World>(world: &W, mirror: ShapeId, direction: Direction) -> MirrorSet {
    if !W::AHEAD {
        return MirrorSet::ALL;
    }
    world.round_mirrors().ahead(mirror.index(), direction)
}

/// The nearest sphere or cylinder of all but the one whose outside the ray has `left`, further than
/// `start` along the ray; the distance is from there. Notes on which side of cylinders it passes, but
/// where code is to be `SMALL`.
pub(crate) fn nearest_bounded<W: World, const SMALL: bool>(
    world: &W,
    ray: &Ray,
    start: Length,
    left: ShapeId,
    signature: &mut PathSignature,
) -> Hit {
    nearest_ahead::<W, SMALL>(world, (ray, MirrorSet::ALL), start, left, signature)
}

/// The same of those that lie ahead.
#[inline(never)]
pub(crate) fn nearest_ahead<W: World, const SMALL: bool>(
    world: &W,
    (ray, ahead): (&Ray, MirrorSet),
    start: Length,
    left: ShapeId,
    signature: &mut PathSignature,
) -> Hit {
    let mut nearest = Nearest::beyond(start);
    let parts = world.parts();
    let mut ask_sphere = |index, sphere: &PreparedSphere| {
        let number = ShapeId::of_sphere(index);
        if number == left {
            return;
        }
        let (center, radius) = sphere.ball();
        let way = ray.origin.to(center);
        if !way.passes_by(way.dot(ray.direction), radius) {
            nearest.meet_sphere(sphere, way, ray.direction, number);
        }
    };
    let cylinders_ahead = match W::AHEAD && !SMALL {
        true => ahead.for_each(parts.spheres, &mut ask_sphere),
        false => {
            let spheres = parts.spheres.iter().enumerate();
            spheres.for_each(|(index, sphere)| ask_sphere(index, sphere));
            MirrorSet::ALL
        }
    };
    let mut ask_cylinder = |index, cylinder: &PreparedCylinder| {
        let number = parts.cylinder_number(index);
        if number != left && !cylinder.is_passed_by(ray) {
            let seen = cylinder.seen_from(ray.origin);
            nearest.meet_cylinder::<SMALL>(cylinder, (&seen, true), &ray.direction, number);
        }
    };
    if W::AHEAD && !SMALL {
        cylinders_ahead.for_each(parts.cylinders, ask_cylinder);
    } else {
        let cylinders = parts.cylinders.iter().enumerate();
        cylinders.for_each(|(index, cylinder)| ask_cylinder(index, cylinder));
    }
    if SMALL {
        return nearest.behind_start();
    }
    nearest.hit(signature)
}

/// The nearest of the shapes that a ray has been held against.
pub(super) struct Nearest {
    start: Length,
    hit: Hit,
    /// On which sides of shapes the ray passes.
    passed: u32,
}

impl Nearest {
    /// Nothing yet, and nothing that is met before `start`.
    #[inline(always)]
    pub(super) fn beyond(start: Length) -> Self {
        Self {
            start,
            hit: Hit::NONE,
            passed: 0,
        }
    }

    /// Says whether the sphere is the nearest up to now.
    #[inline(always)]
    pub(super) fn meet_sphere(
        &mut self,
        sphere: &PreparedSphere,
        way: Vector,
        along: Direction,
        shape: ShapeId,
    ) -> bool {
        let distance = sphere.met(way, along, self.start, self.hit.distance);
        if let Some(distance) = distance {
            self.hit = Hit { distance, shape };
        }
        distance.is_some()
    }

    /// Whether a sphere is in front of what has been met.
    #[inline(always)]
    pub(super) fn may_see(&self, sphere: &SphereFromPoint) -> bool {
        sphere.is_nearer_than(self.hit.distance)
    }

    /// Notes that the ray passes by something.
    #[inline(always)]
    pub(super) fn pass(&mut self, passed: u32) {
        self.passed ^= passed;
    }

    #[inline(always)]
    pub(super) fn meet_cylinder<const SMALL: bool>(
        &mut self,
        cylinder: &PreparedCylinder,
        (seen, is_thin): (&CylinderFromPoint, bool),
        along: &Direction,
        shape: ShapeId,
    ) {
        let sideways = seen.sideways(*along);
        if cylinder.is_beside(sideways) {
            if is_thin && sideways < 0 {
                self.pass(shape.passed());
            }
            return;
        }
        let (start, reach) = (self.start, self.hit.distance);
        let distance = match SMALL {
            true => cylinder.met_steeply(seen, along, start, reach),
            false => cylinder.met_beside(seen, along, sideways, start, reach),
        };
        if let Some(distance) = distance {
            self.hit = Hit { distance, shape };
        }
    }

    /// The nearest, and how far behind `start` it is met.
    #[inline(always)]
    pub(super) fn hit(self, signature: &mut PathSignature) -> Hit {
        signature.note(self.passed);
        self.behind_start()
    }

    /// The same without a note.
    #[inline(always)]
    fn behind_start(self) -> Hit {
        let distance = self.hit.distance.to_bits() - self.start.to_bits();
        Hit {
            distance: if self.hit.shape == ShapeId::NONE {
                REACH
            } else {
                Length::from_bits(distance)
            },
            shape: self.hit.shape,
        }
    }
}
