//! The shapes of a scene as a light sees them, and the shadow test from the light.
//!
//! Bound: used for lights that are near, outside of all spheres, and see so much of each sphere that the
//! length of its tangents tells what it hides ([`PreparedLight::is_plain`]). A sphere's shadow then needs
//! no root. It differs from the plain test where rounding decides, by a few steps of the grid: the ray
//! runs from the light to the surface and not back.

use super::light_table::light_set;
use super::{CullingQuality, World};
use crate::light::PreparedLight;
use crate::number::Length;
use crate::ray::ScaledPoint;
use crate::scene::access::ShapeId;
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Capacity, Parts, Room, Surface};
use crate::shape::bounded::{Bounded, LightRay, Own};
use crate::vector::Direction;

macro_rules! light_occluders {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// A light and the shapes of a scene as it sees them.
        #[derive(Clone, Copy, Debug)]
        pub struct LightOccluders<R: Capacity> {
            light: PreparedLight,
            $($list: R::$lists<<crate::shape::$prepared as Bounded>::FromLight>,)*
        }

        impl<$($header)*> LightOccluders<Room<$($arguments)*>> {
            /// Fills the room of a light that a scene's type allows but the scene does not use.
            pub(super) const NONE: Self = Self {
                light: PreparedLight::NONE,
                $($list: [crate::shape::$prepared::NOT_SEEN; $room],)*
            };

            /// Of a light and the shapes of a scene.
            pub(super) const fn new(mut light: PreparedLight, parts: &Parts<'_>) -> Self {
                let mut occluders = Self::NONE;
                let ScaledPoint { point, scale } = light.place;
                light.is_plain = scale == 0;
                if light.is_plain {
                    $(
                        let mut index = 0;
                        while index < parts.$list.len() && index < $room {
                            let from = parts.$list[index].seen_from_light(point);
                            light.is_plain &= parts.$list[index].is_told(&from);
                            occluders.$list[index] = from;
                            index += 1;
                        }
                    )*
                }
                occluders.light = light;
                occluders
            }
        }

        impl<R: Capacity> LightOccluders<R> {
            $(
                #[doc = concat!("Prepares the view of a ", stringify!($kind), " that has changed.")]
                pub(super) fn $kind(&mut self, index: usize, parts: &Parts<'_>) {
                    let view = self.$list.as_mut().get_mut(index);
                    if let Some((view, shape)) = view.zip(parts.$list.get(index)) {
                        *view = shape.seen_from_light(self.light.place.point);
                    }
                }
            )*

            /// Decides again whether all views tell what the shapes hide.
            pub(super) fn settle(&mut self, parts: &Parts<'_>) {
                self.light.is_plain = self.light.place.scale == 0
                    $(&& self.$list.as_ref().iter().zip(parts.$list).all(|(view, shape)| shape.is_told(view)))*;
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

        /// Whether a shape of a set occludes the end of a light's ray on a surface.
        #[inline(always)]
        fn any_occludes<W: World, const PRECISE: bool>(
            world: &W,
            set: &ShapeSet,
            surface: &Surface<'_>,
            light: &LightOccluders<W::Room>,
            ray: &LightRay,
        ) -> bool {
            let parts = world.parts();
            let lengths = parts.lengths();
            let own = |index: usize| match surface.shape == ShapeId::at(index) {
                false => Own::No,
                true if surface.is_inside => Own::Inside,
                true => Own::Outside,
            };
            let (kind, first) = (0, 0);
            $(
                let from = light.$list.as_ref();
                if set.any(W::NEEDS.sets, (kind, lengths), parts.$list, |index, shape| {
                    let from = from.get(index);
                    from.is_some_and(|from| shape.occludes::<PRECISE>(from, ray, own(first + index)))
                }) {
                    return true;
                }
                let (kind, first) = (kind + 1, first + lengths[kind]);
            )*
            let _ = (kind, first);
            false
        }
    };
}
kinds!(light_occluders);

impl<R: Capacity> LightOccluders<R> {
    /// The light itself.
    #[inline(always)]
    pub(crate) const fn light(&self) -> &PreparedLight {
        &self.light
    }
}

/// Whether a shape hides a near surface from a light that no plane hides, and that has a number.
/// `direction` and `distance` lead from the light to the surface.
///
/// Where `PRECISE`, a point that epsilon lifts into a sphere is in its shadow. A shape does not occlude
/// a point on its own surface: hits are known to a few steps, so the ray ends that much earlier.
#[inline(always)]
pub(crate) fn occluded<W: World, Q: CullingQuality, const PRECISE: bool>(
    world: &W,
    surface: &Surface<'_>,
    (light, index): (&LightOccluders<W::Room>, usize),
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
    let set = light_set::<W, Q>(world, index, direction);
    any_occludes::<W, PRECISE>(world, set, surface, light, &ray)
}

#[cfg(test)]
mod tests;
