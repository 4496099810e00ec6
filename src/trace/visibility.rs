//! The two implementations of [`Visibility`]: whether a light is visible, without and with culling.

use core::marker::PhantomData;

use crate::accel::light_occluders::{self, LightOccluders};
use crate::accel::light_table::light_set;
use crate::accel::light_visibility::LightVisibility;
use crate::accel::{World, hierarchy};
use crate::light::PreparedLight;
use crate::number::Length;
use crate::qualities::Quality;
use crate::ray::{REACH, Ray, ScaledPoint, ScaledRay};
use crate::scene::Surface;
use crate::scene::nearest::any_ahead;
use crate::scene::query::{occluded, occluded_by};
use crate::scene::shape_set::ShapeSet;
use crate::shade::Visibility;
use crate::vector::Direction;

/// Visibility without culling: each light gets a shadow ray at each hit. It tests every shape, or those
/// that the light's lists name.
pub(super) struct Plain<'a, W, Q> {
    world: &'a W,
    quality: PhantomData<Q>,
}

impl<'a, W: World, Q: Quality> Plain<'a, W, Q> {
    /// Returns the visibility of the lights of a scene.
    #[inline(always)]
    pub(super) const fn new(world: &'a W) -> Self {
        Self {
            world,
            quality: PhantomData,
        }
    }

    /// Returns the bounded shapes that a shadow ray in this direction can hit. `index` is the light's index.
    #[inline(always)]
    fn candidates(&self, index: usize, direction: Direction) -> ShapeSet {
        let lists = if W::NEEDS.sets && Q::CULLING.lists {
            self.world.tables().light_lists.get(index)
        } else {
            None
        };
        lists.map_or(*ShapeSet::ALL, |lists| lists.at(direction.reversed()))
    }
}

impl<W: World, Q: Quality> Visibility for Plain<'_, W, Q> {
    type Light = PreparedLight;
    const IS_KNOWN: bool = false;

    #[inline(always)]
    fn lights(&self) -> &[PreparedLight] {
        self.world.parts().lights
    }

    #[inline(always)]
    fn light(light: &PreparedLight) -> &PreparedLight {
        light
    }

    #[inline(always)]
    fn is_occluded(
        &self,
        surface: &Surface<'_>,
        ray: &ScaledRay,
        index: usize,
        light: (ScaledPoint, Length, u32),
    ) -> bool {
        let candidates = self.candidates(index, ray.direction());
        occluded(
            self.world,
            &candidates,
            ray,
            surface.skip(self.world),
            light,
        )
    }
}

/// Visibility with culling: lights that planes hide are known for the whole frame, and each light has
/// tables of the shapes around it.
pub(super) struct Culled<'a, W, Q> {
    world: &'a W,
    visibility: &'a LightVisibility,
    quality: PhantomData<Q>,
}

impl<'a, W, Q> Culled<'a, W, Q> {
    /// Returns the visibility of the lights of a scene, with what is known for the frame.
    #[inline(always)]
    pub(super) const fn new(world: &'a W, visibility: &'a LightVisibility) -> Self {
        Self {
            world,
            visibility,
            quality: PhantomData,
        }
    }
}

impl<W: World, Q: Quality> Visibility for Culled<'_, W, Q> {
    type Light = LightOccluders<W::Room>;
    const IS_KNOWN: bool = true;

    #[inline(always)]
    fn lights(&self) -> &[LightOccluders<W::Room>] {
        self.world.tables().light_occluders
    }

    #[inline(always)]
    fn light(light: &LightOccluders<W::Room>) -> &PreparedLight {
        light.light()
    }

    #[inline(always)]
    fn is_hidden(&self, index: usize) -> bool {
        self.visibility.is_hidden(index)
    }

    #[inline(always)]
    fn is_clear(&self, index: usize) -> bool {
        self.visibility.is_clear(index)
    }

    #[inline(always)]
    fn is_occluded_from<const PRECISE: bool>(
        &self,
        surface: &Surface<'_>,
        (light, index): (&LightOccluders<W::Room>, usize),
        (direction, distance): (Direction, Length),
    ) -> bool {
        // The tangents do not tell what a small sphere hides, so the plain path tests. In a constant scene the compiler
        // knows whether any light has such a sphere, and leaves this out if none has.
        let mut lights = self.lights().iter();
        if light.light().has_small && lights.any(|it| it.light().has_small) {
            let ray = ScaledRay::new(surface.place, direction.reversed());
            let way = (light.light().place, distance, 0);
            return self.is_occluded(surface, &ray, index, way);
        }
        let (light, ray) = ((light, index), (direction, distance));
        light_occluders::occluded::<W, Q, PRECISE>(self.world, surface, light, ray)
    }

    #[inline(always)]
    fn is_open(&self, index: usize) -> bool {
        self.visibility.is_open(index)
    }

    #[inline(always)]
    fn is_occluded_ahead(&self, surface: &Surface<'_>, direction: Direction) -> bool {
        let (world, skip) = (self.world, surface.skip(self.world));
        let ray = Ray {
            origin: surface.place.point,
            direction,
        };
        if hierarchy::is_used::<W, Q>(world) {
            hierarchy::is_blocked(world, &ray, skip, REACH)
        } else {
            any_ahead(world, &ray, skip)
        }
    }

    #[inline(always)]
    fn is_occluded(
        &self,
        surface: &Surface<'_>,
        ray: &ScaledRay,
        index: usize,
        light: (ScaledPoint, Length, u32),
    ) -> bool {
        let (world, skip) = (self.world, surface.skip(self.world));
        if hierarchy::is_used::<W, Q>(world) {
            return occluded_by(world, ray, skip, light, |ray, reach| {
                hierarchy::is_blocked(world, ray, skip, reach)
            });
        }
        let set = light_set::<W, Q>(world, index, ray.direction().reversed());
        occluded(world, set, ray, skip, light)
    }
}
