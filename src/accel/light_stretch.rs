//! Whether a light shines on all points of a stretch, or on none.
//!
//! The points lie almost on a straight line. So the light's rays to them form a fan. Bound: docs/internals/edges.md
//! proves the rules by which a shape surely hides all points of the fan, or none.

use super::light_occluders::LightOccluders;
use super::light_table::rays_set;
use super::stretch::is_apart;
use super::{CullingQuality, World};
use crate::number::Length;
use crate::ray::ScaledPoint;
use crate::scene::access::ShapeId;
use crate::scene::shape_set::ShapeSet;
use crate::shape::bordered::{Ball, Bordered, Fan};
use crate::shape::bounded::{Bounded, LightRay, Own};
use crate::shape::rays::{Beam, Rays, SLACK};
use crate::vector::{Direction, Point};

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
pub(crate) fn lights_all<W: World, Q: CullingQuality>(
    world: &W,
    (light, index): (&LightOccluders<W::Room>, usize),
    stretch: &LitStretch,
    rays: &Rays,
) -> Option<bool> {
    let set = rays_set::<W, Q>(world, index, rays, stretch.bulge);
    let mut found = Found {
        stretch,
        sight: Sight::new(rays, stretch.bulge),
        epsilon: world.parts().epsilon,
        is_unsure: false,
    };
    match any_hides(world, &set, light, &mut found) {
        true => Some(false),
        false => (!found.is_unsure).then_some(true),
    }
}

/// The rays from an eye or a light to the points of a stretch, and the bodies that hold them all.
struct Sight<'a> {
    rays: &'a Rays,
    /// Upper bound of the distance of a point from the straight line between the ends, in steps.
    bulge: i32,
    /// The beam that holds the rays, `None` if there is none.
    beam: Option<Beam>,
    /// The fan that holds the rays more closely, made when it is asked for.
    fan: Option<Fan>,
}

impl<'a> Sight<'a> {
    fn new(rays: &'a Rays, bulge: i32) -> Self {
        Self {
            rays,
            bulge,
            beam: rays.beam(bulge),
            fan: None,
        }
    }

    /// Tests whether a ball surely lies outside of the beam.
    #[inline(always)]
    fn misses(&self, (center, radius): Ball) -> bool {
        let way = self.rays.apex.point.to(center);
        self.beam.is_some_and(|beam| beam.avoids_ball(way, radius))
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
        !self.sight.misses(shape.bounding_ball()) && self.hides(shape, from, is_own)
    }

    /// Tests whether a shape that the beam meets hides all points of the stretch. Notes if it may hide some of them. Compiled
    /// once for each kind, not for each scene.
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

/// One thick ray that holds all rays from the points of a near stretch to a far light. A sun's rays are parallel, and those
/// to a lamp come together.
struct FarLight {
    /// The middle of the stretch, where the thick ray begins.
    middle: Point,
    /// Direction of the thick ray: that from the first end of the stretch to the light.
    towards: Direction,
    /// The thick ray's radius in steps.
    width: i32,
}

impl FarLight {
    /// Returns the thick ray from a stretch. `towards` is the direction from its first end to the light.
    fn new(stretch: &LitStretch, towards: Direction) -> Self {
        let [first, last] = stretch.ends.map(|end| end.point);
        let half = first.to(last).coarser(1);
        Self {
            middle: Point::at(first.to_vector().plus(half)),
            towards,
            width: half.normalised().1.to_bits() + stretch.bulge + stretch.slack + SLACK,
        }
    }

    /// Tests whether the capsule around a shape surely lies behind the start of the thick ray, or beside it.
    fn misses<K: Bordered>(&self, shape: &K) -> bool {
        let (center, half_axis, radius) = shape.outline();
        let (way, reach) = (self.middle.to(center), radius + self.width);
        let ends = [way.plus(half_axis), way.minus(half_axis)];
        let heights = ends.map(|end| end.dot(self.towards));
        // The ends of the capsule's axis, projected along the thick ray. It projects to the origin.
        let aside = [0, 1].map(|it| Point::at(ends[it].without(self.towards, heights[it])));
        heights.iter().all(|height| *height < -reach) || is_apart(aside, Point::ORIGIN, reach)
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
            let rays = Rays::new(ScaledPoint::at(eye), stretch.ends);
            let mut sight = Sight::new(&rays, stretch.bulge + stretch.slack);
            let parts = world.parts();
            let first = 0;
            $(
                let is_clear = parts.$list.iter().enumerate().all(|(index, shape)| {
                    let (center, radius) = shape.bounding_ball();
                    stretch.shape == ShapeId::at(first + index)
                        || sight.misses((center, radius))
                        || sight.fan().is_some_and(|fan| {
                            fan.avoids_ball(eye.to(center), radius)
                                || shape.spares(&shape.seen_from_light(eye), fan)
                        })
                });
                if !is_clear {
                    return false;
                }
                let first = first + parts.$list.len();
            )*
            let _ = first;
            !stretch.is_hollow
        }

        /// Tests whether a far light that no plane hides surely shines on all points of a near stretch. The stretch faces
        /// it. `towards` is the direction from the first end to the light.
        #[inline(never)]
        pub(crate) fn far_lights_all<W: World>(
            world: &W,
            stretch: &LitStretch,
            towards: Direction,
        ) -> bool {
            let light = FarLight::new(stretch, towards);
            let (parts, first) = (world.parts(), 0);
            $(
                let is_clear = parts.$list.iter().enumerate().all(|(index, shape)| {
                    // A convex surface hides no part of itself that faces the light.
                    let is_own = stretch.shape == ShapeId::at(first + index);
                    is_own && !stretch.is_hollow || light.misses(shape)
                });
                if !is_clear {
                    return false;
                }
                let first = first + parts.$list.len();
            )*
            let _ = first;
            true
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
            let lengths = parts.lengths();
            let (kind, first) = (0, 0);
            $(
                let from = light.$list();
                if set.any(W::NEEDS.sets, (kind, lengths), parts.$list, |index, shape| {
                    let is_own = found.stretch.shape == ShapeId::at(first + index);
                    from.get(index).is_some_and(|from| found.ask(shape, from, is_own))
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

#[cfg(test)]
mod tests;
