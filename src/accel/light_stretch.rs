//! Whether a light shines on all points of a stretch, or on none.
//!
//! The points lie in a ball. So the light's rays to them form a beam. Bound: docs/edges.md proves the rules
//! by which a shape surely hides all points of the beam, or none.

use super::light_occluders::LightOccluders;
use super::light_table::beam_set;
use super::{CullingQuality, World};
use crate::number::Length;
use crate::ray::REACH;
use crate::scene::access::ShapeId;
use crate::scene::shape_set::ShapeSet;
use crate::shape::bordered::{Ball, Beam, Bordered};
use crate::shape::bounded::{Bounded, LightRay, Own};
use crate::vector::{Direction, Point};

/// The points of a surface that a stretch shows.
pub(crate) struct LitStretch {
    /// The surface's shape.
    pub(crate) shape: ShapeId,
    /// Whether the surface is hit from inside.
    pub(crate) is_inside: bool,
    /// Whether all points lie on the straight line between the two ends.
    pub(crate) is_flat: bool,
    /// Ball around all points.
    pub(crate) ball: Ball,
    /// Points at the two ends, and the normals there.
    pub(crate) ends: [(Point, Direction); 2],
}

/// Returns whether a clear light shines on all points of a stretch, or on none; `None` if that is not sure.
///
/// `light` is the light and its index.
pub(crate) fn lights_all<W: World, Q: CullingQuality>(
    world: &W,
    (light, index): (&LightOccluders<W::Room>, usize),
    stretch: &LitStretch,
) -> Option<bool> {
    let place = light.light().place.point;
    let faces = |(point, normal): (Point, Direction)| point.to(place).dot(normal) > 0;
    match stretch.ends.map(faces) {
        [false, false] => return Some(false),
        [true, true] => {}
        _ => return None,
    }
    let beam = Beam::new(place, stretch.ball)?;
    let set = beam_set::<W, Q>(world, index, &beam);
    let mut found = Found {
        stretch,
        light: place,
        epsilon: world.parts().epsilon,
        rays: None,
        is_unsure: false,
    };
    match any_hides(world, &set, light, &beam, &mut found) {
        true => Some(false),
        false => (!found.is_unsure).then_some(true),
    }
}

/// What is known of the shapes between a light and a stretch.
struct Found<'a> {
    stretch: &'a LitStretch,
    light: Point,
    epsilon: Length,
    /// The light's rays to the two ends.
    rays: Option<[LightRay; 2]>,
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
        beam: &Beam,
        is_own: bool,
    ) -> bool {
        // A convex surface hides no part of itself that faces the light.
        let is_closed = K::IS_BALL || K::IS_FLAT || !self.stretch.is_inside;
        if is_own && is_closed || shape.spares(from, beam) {
            return false;
        }
        let (light, epsilon) = (self.light, self.epsilon);
        let rays = self.rays.get_or_insert_with(|| {
            self.stretch.ends.map(|(end, _)| {
                let (direction, reach) = light.to(end).direction_and_length();
                LightRay {
                    direction,
                    reach: if reach < REACH { reach } else { REACH },
                    epsilon,
                    end,
                }
            })
        });
        let own = match is_own {
            true => Own::Inside,
            false => Own::No,
        };
        let hides = rays
            .iter()
            .all(|ray| shape.occludes::<false>(from, ray, own))
            && shape.hides(from, beam, rays, self.stretch.is_flat);
        self.is_unsure |= !hides;
        hides
    }
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
            let Some(beam) = Beam::new(eye, stretch.ball) else {
                return false;
            };
            let parts = world.parts();
            let first = 0;
            $(
                let is_clear = parts.$list.iter().enumerate().all(|(index, shape)| {
                    stretch.shape == ShapeId::at(first + index)
                        || beam.passes(eye.to(shape.bounding_ball().0), shape.bounding_ball().1)
                        || shape.spares(&shape.seen_from_light(eye), &beam)
                });
                if !is_clear {
                    return false;
                }
                let first = first + parts.$list.len();
            )*
            let _ = first;
            !stretch.is_inside || stretch.is_flat
        }

        /// Tests whether a shape of `set` surely hides all points of a stretch from a light.
        #[inline(always)]
        fn any_hides<W: World>(
            world: &W,
            set: &ShapeSet,
            light: &LightOccluders<W::Room>,
            beam: &Beam,
            found: &mut Found<'_>,
        ) -> bool {
            let parts = world.parts();
            let lengths = parts.lengths();
            let (kind, first) = (0, 0);
            $(
                let from = light.$list();
                if set.any(W::NEEDS.sets, (kind, lengths), parts.$list, |index, shape| {
                    let is_own = found.stretch.shape == ShapeId::at(first + index);
                    from.get(index).is_some_and(|from| found.ask(shape, from, beam, is_own))
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
kinds!(any_hides);
