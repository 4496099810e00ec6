//! The shapes of a scene as a light sees them, and the shadow test from the light.
//!
//! Bound: used for lights that are near, outside of all spheres, and see so much of each sphere that the
//! length of its tangents tells what it hides ([`PreparedLight::is_plain`]). A sphere's shadow then needs
//! no root. It differs from the plain test where rounding decides, by a few steps of the grid: the ray
//! runs from the light to the surface and not back.

use super::World;
use crate::light::PreparedLight;
use crate::number::Length;
use crate::ray::ScaledPoint;
use crate::scene::access::ShapeId;
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Parts, Surface};
use crate::shape::bounded::{Bounded, LightRay, Own};
use crate::shape::cylinder::CylinderFromPoint;
use crate::shape::sphere::SphereFromPoint;
use crate::vector::Direction;

/// A light and the shapes of a scene as it sees them.
#[derive(Clone, Copy, Debug)]
pub struct LightOccluders<const S: usize, const C: usize> {
    light: PreparedLight,
    spheres: [SphereFromPoint; S],
    cylinders: [CylinderFromPoint; C],
}

impl<const S: usize, const C: usize> LightOccluders<S, C> {
    /// Fills the room of a light that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self {
        light: PreparedLight::NONE,
        spheres: [SphereFromPoint::NONE; S],
        cylinders: [CylinderFromPoint::NONE; C],
    };

    /// Of a light, which stands somewhere, and the shapes of a scene.
    pub(crate) const fn new(mut light: PreparedLight, parts: &Parts<'_>) -> Self {
        let mut occluders = Self::NONE;
        let ScaledPoint { point, scale } = light.place;
        light.is_plain = scale == 0;
        if light.is_plain {
            let mut index = 0;
            while index < parts.spheres.len() && index < S {
                let sphere = &parts.spheres[index];
                occluders.spheres[index] = sphere.seen_from(point);
                light.is_plain &= sphere.is_told(&occluders.spheres[index]);
                index += 1;
            }
            index = 0;
            while index < parts.cylinders.len() && index < C {
                let cylinder = &parts.cylinders[index];
                occluders.cylinders[index] = cylinder.seen_from(point);
                light.is_plain &= cylinder.is_told(&occluders.cylinders[index]);
                index += 1;
            }
        }
        occluders.light = light;
        occluders
    }

    /// The light, which now says whether it is plain.
    pub(crate) const fn light_itself(&self) -> &PreparedLight {
        &self.light
    }
}

/// [`LightOccluders`], whatever its room.
pub trait Occluders {
    /// The light itself.
    #[allow(private_interfaces)]
    fn light(&self) -> &PreparedLight;

    /// The scene's spheres as the light sees them, and maybe more.
    #[allow(private_interfaces)]
    fn spheres(&self) -> &[SphereFromPoint];

    /// The scene's cylinders as the light sees them, and maybe more.
    #[allow(private_interfaces)]
    fn cylinders(&self) -> &[CylinderFromPoint];
}

#[allow(private_interfaces)]
impl<const S: usize, const C: usize> Occluders for LightOccluders<S, C> {
    #[inline(always)]
    fn light(&self) -> &PreparedLight {
        &self.light
    }

    #[inline(always)]
    fn spheres(&self) -> &[SphereFromPoint] {
        &self.spheres
    }

    #[inline(always)]
    fn cylinders(&self) -> &[CylinderFromPoint] {
        &self.cylinders
    }
}

/// Whether a shape hides a near surface from a light that no plane hides, and that has a number.
/// `direction` and `distance` lead from the light to the surface.
///
/// Where `PRECISE`, a point that epsilon lifts into a sphere is in its shadow. A shape does not occlude
/// a point on its own surface: hits are known to a few steps, so the ray ends that much earlier.
#[inline(always)]
pub(crate) fn occluded<W: World, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    (light, index): (&W::LightOccluders, usize),
    (direction, distance): (Direction, Length),
) -> bool {
    let ray = LightRay {
        direction,
        reach: match PRECISE {
            true => distance.surely_less(),
            false => distance,
        },
        epsilon: world.parts().epsilon,
        end: surface.place.point,
    };
    let table = match W::NEEDS.sets {
        true => world.light_tables().get(index),
        false => None,
    };
    let set = table.map_or(ShapeSet::ALL, |table| table.at(direction));
    let parts = world.parts();
    let lengths = parts.lengths();
    let own = |index: usize| match surface.shape == ShapeId::at(index) {
        false => Own::No,
        true if surface.is_inside => Own::Inside,
        true => Own::Outside,
    };
    let (spheres, cylinders) = (light.spheres(), light.cylinders());
    let is_chosen = W::NEEDS.sets;
    set.any(is_chosen, (0, lengths), parts.spheres, |index, sphere| {
        let from = spheres.get(index);
        from.is_some_and(|from| sphere.occludes::<PRECISE>(from, &ray, own(index)))
    }) || set.any(
        is_chosen,
        (1, lengths),
        parts.cylinders,
        |index, cylinder| {
            let from = cylinders.get(index);
            from.is_some_and(|from| {
                cylinder.occludes::<PRECISE>(from, &ray, own(lengths[0] + index))
            })
        },
    )
}
