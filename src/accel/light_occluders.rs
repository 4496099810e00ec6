//! The bounded shapes of a scene, prepared for rays from one light, and the shadow test from the light.
//!
//! Bound: used for a light that is near, outside of all spheres ([`PreparedLight::is_plain`]), and not too far from any
//! sphere for its size: the length of the tangents must tell what the sphere hides ([`PreparedLight::has_small`]). The
//! shadow test of a sphere then needs no root. The result differs from the plain test only where rounding decides, by a
//! few steps of the grid: the ray runs from the light to the surface, not from the surface to the light.

use super::light_table::light_set;
use super::{World, hierarchy};
use crate::light::PreparedLight;
use crate::number::Length;
use crate::qualities::Quality;
use crate::ray::{Ray, ScaledPoint};
use crate::scene::access::ShapeId;
use crate::scene::shape_set::{SETS, ShapeSet};
use crate::scene::{Capacity, Parts, Room, Surface};
use crate::shape::bounded::{Bounded, LightRay, Own};
use crate::vector::Direction;

macro_rules! light_occluders {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// A light, and all bounded shapes of a scene prepared for rays that start at the light.
        #[derive(Clone, Copy, Debug)]
        pub struct LightOccluders<R: Capacity> {
            light: PreparedLight,
            $($list: R::$lists<<crate::shape::$prepared as Bounded>::FromLight>,)*
        }

        impl<$($header)*> LightOccluders<Room<$($arguments)*>> {
            /// Placeholder for a light that a scene's type has room for but the scene does not use.
            pub(super) const NONE: Self = Self {
                light: PreparedLight::NONE,
                $($list: [crate::shape::$prepared::NOT_SEEN; $room],)*
            };

            /// Prepares a light and the shapes of a scene for shadow tests from the light.
            ///
            /// Sets [`PreparedLight::is_plain`]: the light is near and outside of all spheres.
            pub(super) const fn new(mut light: PreparedLight, parts: &Parts<'_>) -> Self {
                let mut occluders = Self::NONE;
                let ScaledPoint { point, scale } = light.place;
                light.is_plain = scale == 0;
                if light.is_plain {
                    $(
                        let mut index = 0;
                        while index < parts.$list.len() && index < $room {
                            occluders.$list[index] = parts.$list[index].seen_from_light(point);
                            index += 1;
                        }
                    )*
                    let mut index = 0;
                    while index < parts.spheres.len() && index < occluders.spheres.len() {
                        light.is_plain &= !occluders.spheres[index].is_around();
                        light.has_small |= !parts.spheres[index].is_told(&occluders.spheres[index]);
                        index += 1;
                    }
                }
                occluders.light = light;
                occluders
            }
        }

        impl<R: Capacity> LightOccluders<R> {
            $(
                #[doc = concat!("Returns the ", stringify!($list), " as the light sees them.")]
                #[inline(always)]
                pub(super) fn $list(&self) -> &[<crate::shape::$prepared as Bounded>::FromLight] {
                    self.$list.as_ref()
                }
            )*

            $(
                #[doc = concat!("Prepares the view of a ", stringify!($kind), " that has changed.")]
                pub(super) fn $kind(&mut self, index: usize, parts: &Parts<'_>) {
                    let view = self.$list.as_mut().get_mut(index);
                    if let Some((view, shape)) = view.zip(parts.$list.get(index)) {
                        *view = shape.seen_from_light(self.light.place.point);
                    }
                }
            )*

            /// Decides again whether the light is outside of all spheres, and whether one is small for its distance from it.
            pub(super) fn settle(&mut self, parts: &Parts<'_>) {
                let spheres = || self.spheres.as_ref().iter().zip(parts.spheres);
                self.light.is_plain =
                    self.light.place.scale == 0 && !spheres().any(|(view, _)| view.is_around());
                self.light.has_small = !spheres().all(|(view, sphere)| sphere.is_told(view));
            }

            /// Prepares the views from a light that has changed.
            pub(super) fn put(&mut self, light: &PreparedLight, parts: &Parts<'_>) {
                self.light.place = light.place;
                if light.place.scale == 0 {
                    $(
                        for (view, shape) in self.$list.as_mut().iter_mut().zip(parts.$list) {
                            *view = shape.seen_from_light(light.place.point);
                        }
                    )*
                }
                self.settle(parts);
            }
        }

        /// Tests whether a bounded shape lies between a light and the point on `surface` where `ray` ends.
        /// Asks the scene's hierarchy.
        #[inline(always)]
        fn is_occluded_in_crowd<W: World, const PRECISE: bool>(
            world: &W,
            surface: &Surface<'_>,
            light: &LightOccluders<W::Room>,
            ray: &LightRay,
        ) -> bool {
            let parts = world.parts();
            let line = Ray {
                origin: light.light.place.point,
                direction: ray.direction,
            };
            world.tables().hierarchy.any(&line, surface.shape, |index| {
                let own = own(surface, ShapeId::at(index));
                $(
                    if let Some((shape, from)) = parts.$list.get(index).zip(light.$list.as_ref().get(index)) {
                        return shape.occludes::<PRECISE>(from, ray, own);
                    }
                    let index = index - parts.$list.len();
                )*
                let _ = index;
                false
            })
        }

        /// Tests whether a shape of `set` lies between a light and the point on `surface` where `ray`
        /// ends.
        #[inline(always)]
        fn any_occludes<W: World, const PRECISE: bool>(
            world: &W,
            set: &ShapeSet,
            surface: &Surface<'_>,
            light: &LightOccluders<W::Room>,
            ray: &LightRay,
        ) -> bool {
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                let from = light.$list.as_ref();
                if set.any(W::NEEDS.sets, $list, parts.$list, |index, shape| {
                    let from = from.get(index);
                    from.is_some_and(|from| shape.occludes::<PRECISE>(from, ray, own(surface, $list.id(index))))
                }) {
                    return true;
                }
            )*
            false
        }
    };
}
kinds!(light_occluders);

/// Returns whether the surface is that of the bounded shape `shape`.
#[inline(always)]
fn own(surface: &Surface<'_>, shape: ShapeId) -> Own {
    if surface.shape != shape {
        Own::No
    } else if surface.is_inside {
        Own::Inside
    } else {
        Own::Outside
    }
}

impl<R: Capacity> LightOccluders<R> {
    /// Returns the light without the shapes around it.
    #[inline(always)]
    pub(crate) const fn light(&self) -> &PreparedLight {
        &self.light
    }
}

/// Tests whether a bounded shape hides a near surface from a light. Uses the tangents from the light.
///
/// The light must be plain and have no small sphere, and no plane may hide it. `index` is its place in the list of lights.
/// `direction` and `distance` lead from the light to the surface.
///
/// If `PRECISE`, a point that epsilon lifts into a sphere is in the sphere's shadow. The ray then ends
/// a few steps before the surface, because hits are known only to a few steps. So a shape does not
/// occlude a point on its own surface.
#[inline(always)]
pub(crate) fn occluded<W: World, Q: Quality, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    (light, index): (&LightOccluders<W::Room>, usize),
    (direction, distance): (Direction, Length),
) -> bool {
    let ray = LightRay {
        direction,
        reach: if PRECISE { distance.surely_less() } else { distance },
        epsilon: world.parts().epsilon,
        end: surface.place.point,
    };
    // In a larger scene a table cannot tell a shape from those that follow it in the list. Up to about two
    // shapes a bit, the table still takes less time, but not among the triangles of a mesh.
    let parts = world.parts();
    let is_large = parts.bounded() > 2 * SETS || W::NEEDS.triangles && hierarchy::has_mesh(&parts);
    if hierarchy::is_used::<W, Q>(world) && is_large {
        return is_occluded_in_crowd::<W, PRECISE>(world, surface, light, &ray);
    }
    let set = light_set::<W, Q>(world, index, direction);
    any_occludes::<W, PRECISE>(world, set, surface, light, &ray)
}

#[cfg(test)]
mod tests;
