//! Whether a light shines on all points of a stretch, or on none.
//!
//! The points lie almost on a straight line. So the light's rays to them form a fan. Bound: docs/internals/edges.md
//! proves the rules by which a shape surely hides all points of the fan, or none.

use super::World;
use super::light_occluders::LightOccluders;
use super::light_table::rays_set;
use crate::number::Length;
use crate::qualities::Quality;
use crate::ray::ScaledPoint;
use crate::scene::access::ShapeId;
use crate::scene::shape_set::ShapeSet;
use crate::shape::bordered::{Bordered, Fan};
use crate::shape::bounded::{Bounded, LightRay, Own};
use crate::shape::rays::{Rays, Spread};
use crate::vector::Point;

/// The points of a surface that a stretch shows.
pub(crate) struct LitStretch {
    /// The surface's shape.
    pub(crate) shape: ShapeId,
    /// Whether the surface is curved and hit from inside.
    pub(crate) is_hollow: bool,
    /// Upper bound of the distance of a point from the straight line between the ends, in steps.
    pub(crate) bulge: i32,
    /// What rounding and epsilon may add, in steps.
    pub(crate) slack: i32,
    /// Points at the two ends.
    pub(crate) ends: [ScaledPoint; 2],
}

/// Returns whether a clear light shines on all points of a stretch, or on none; `None` if that is not sure.
/// The stretch faces the light.
///
/// `light` is the light and its index, `rays` its rays to the ends of the stretch.
pub(crate) fn lights_all<W: World, Q: Quality>(
    world: &W,
    (light, index): (&LightOccluders<W::Room>, usize),
    stretch: &LitStretch,
    rays: &Rays,
) -> Option<bool> {
    let mut found = Found {
        stretch,
        sight: Sight::new(rays, stretch.bulge),
        epsilon: world.parts().epsilon,
        is_unsure: false,
    };
    let set = rays_set::<W, Q>(world, index, &found.sight.spread);
    if any_hides(world, &set, light, &mut found) {
        Some(false)
    } else {
        (!found.is_unsure).then_some(true)
    }
}

/// The rays from an eye or a light to the points of a stretch: those to its two ends, and what bounds them all.
struct Sight<'a> {
    rays: &'a Rays,
    /// Upper bound of the distance of a point from the straight line between the ends, in steps.
    bulge: i32,
    /// Bounds of all rays.
    spread: Spread,
    /// The fan that holds the rays, made when it is asked for.
    fan: Option<Fan>,
}

impl<'a> Sight<'a> {
    fn new(rays: &'a Rays, bulge: i32) -> Self {
        Self {
            rays,
            bulge,
            spread: rays.spread(bulge),
            fan: None,
        }
    }

    /// Returns the fan of the rays.
    #[inline(never)]
    fn fan(&mut self) -> Option<&Fan> {
        if self.fan.is_none() {
            self.fan = Fan::new(self.rays, self.bulge);
        }
        self.fan.as_ref()
    }
}

/// What is known of the shapes between a light and a stretch.
struct Found<'a> {
    stretch: &'a LitStretch,
    sight: Sight<'a>,
    epsilon: Length,
    /// Whether a shape may hide some points and spare others.
    is_unsure: bool,
}

impl Found<'_> {
    /// Tests whether a shape hides all points of the stretch. Notes if it may hide some of them.
    #[inline(always)]
    fn ask<K: Bordered>(
        &mut self,
        shape: &K,
        from: &<K as Bounded>::FromLight,
        is_own: bool,
    ) -> bool {
        // A convex surface hides no part of itself that faces the light.
        let is_closed = K::IS_BALL || K::IS_FLAT || !self.stretch.is_hollow;
        if is_own && is_closed {
            return false;
        }
        match shape.told(from, &self.sight.spread) {
            Some(hides) => hides,
            None => self.hides(shape, from, is_own),
        }
    }

    /// Tests by the fan whether a shape hides all points of the stretch. Notes if it may hide some of them. Compiled once for
    /// each kind, not for each scene.
    #[inline(never)]
    fn hides<K: Bordered>(
        &mut self,
        shape: &K,
        from: &<K as Bounded>::FromLight,
        is_own: bool,
    ) -> bool {
        let (rays, epsilon) = (self.sight.rays, self.epsilon);
        let hides = match self.sight.fan() {
            Some(fan) if shape.spares(from, fan) => return false,
            Some(fan) => {
                !is_own && hides_ends(shape, from, (rays, epsilon)) && shape.hides(from, fan)
            }
            None => false,
        };
        self.is_unsure |= !hides;
        hides
    }
}

/// Tests whether a shape hides both ends of a stretch, to which a light's rays lead.
fn hides_ends<K: Bordered>(
    shape: &K,
    from: &<K as Bounded>::FromLight,
    (rays, epsilon): (&Rays, Length),
) -> bool {
    let mut ends = rays.places.iter().zip(rays.ends).zip(rays.reaches);
    ends.all(|((end, direction), reach)| {
        let ray = LightRay {
            direction,
            reach,
            epsilon,
            end: end.point,
        };
        shape.occludes::<false>(from, &ray, Own::No)
    })
}

macro_rules! any_hides {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        /// Tests whether no shape lies between an eye and the points of a stretch, but the shape that the
        /// stretch shows.
        #[inline(never)]
        pub(crate) fn is_clear_way<W: World>(world: &W, eye: Point, stretch: &LitStretch) -> bool {
            let rays = Rays::new(ScaledPoint::at(eye), stretch.ends);
            let mut sight = Sight::new(&rays, stretch.bulge + stretch.slack);
            // A ray that is shorter than a sphere's tangents may end inside of it, so lengths tell nothing.
            sight.spread.most = i32::MAX;
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                let is_clear = parts.$list.iter().enumerate().all(|(index, shape)| {
                    let (center, radius) = shape.bounding_ball();
                    stretch.shape == $list.id(index)
                        || sight.fan().is_some_and(|fan| fan.avoids_ball(eye.to(center), radius))
                        || {
                            let from = shape.seen_from_light(eye);
                            shape.told(&from, &sight.spread) == Some(false)
                                || sight.fan().is_some_and(|fan| shape.spares(&from, fan))
                        }
                });
                if !is_clear {
                    return false;
                }
            )*
            !stretch.is_hollow
        }

        /// Tests whether a shape of `set` surely hides all points of a stretch from a light.
        #[inline(always)]
        fn any_hides<W: World>(
            world: &W,
            set: &ShapeSet,
            light: &LightOccluders<W::Room>,
            found: &mut Found<'_>,
        ) -> bool {
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                let from = light.$list();
                if set.any(W::NEEDS.sets, $list, parts.$list, |index, shape| {
                    let is_own = found.stretch.shape == $list.id(index);
                    from.get(index).is_some_and(|from| found.ask(shape, from, is_own))
                }) {
                    return true;
                }
            )*
            false
        }
    };
}
kinds!(any_hides);
