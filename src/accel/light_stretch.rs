//! Whether a light shines on all points of a stretch, or on none.
//!
//! The points lie almost on a straight line. So the light's rays to them form a fan. Bound: docs/internals/edges.md
//! proves the rules by which a shape surely hides all points of the fan, or none.

use super::light_occluders::LightOccluders;
use super::light_table::rays_set;
use super::stretch::is_off;
use super::{CullingQuality, World};
use crate::number::Length;
use crate::ray::{Ray, ScaledPoint, shift_of};
use crate::scene::access::ShapeId;
use crate::scene::shape_set::ShapeSet;
use crate::shape::bordered::{Ball, Bordered, Fan, square};
use crate::shape::bounded::{Bounded, LightRay, Own};
use crate::shape::rays::{Beam, Rays, SLACK};
use crate::vector::{Direction, Point, Vector};

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

/// All rays from the points of a stretch to a far light: a strip between those of its two ends, as thick as the stretch
/// bulges. A sun's rays are parallel, and those to a lamp come together.
struct Strip<'a> {
    stretch: &'a LitStretch,
    /// Directions from the two ends to the light.
    towards: [Direction; 2],
    /// The vector from the first end to the last, in steps of 2^`scale`.
    way: Vector,
    scale: u32,
    /// Direction and length of the stretch, and both as the light sees them.
    own: (Direction, Length),
    seen: (Direction, Length),
    /// Upper bound of the distance of a ray from the strip, in steps of 2^`scale`.
    thickness: i32,
}

impl<'a> Strip<'a> {
    /// Returns the strip from a stretch. `towards` are the directions from its ends to the light.
    fn new(stretch: &'a LitStretch, towards: [Direction; 2]) -> Self {
        let [first, last] = stretch.ends;
        let (way, scale) = first.to(last);
        Self {
            stretch,
            towards,
            way,
            scale,
            own: way.normalised(),
            seen: way.without(towards[0], way.dot(towards[0])).normalised(),
            thickness: (stretch.bulge >> shift_of(scale)) + SLACK,
        }
    }

    /// Tests whether the capsule around a shape surely lies behind the start of the strip, or beside it.
    fn misses<K: Bordered>(&self, shape: &K) -> bool {
        let (center, half_axis, radius) = shape.outline();
        let ([ahead, _], shift) = (self.towards, shift_of(self.scale));
        let reach = (radius >> shift) + self.thickness;
        let ends = [half_axis, Vector::ZERO.minus(half_axis)].map(|half| {
            let end = Point::at(center.to_vector().plus(half));
            self.stretch.ends[0].to(ScaledPoint::at(end)).0
        });
        let heights = ends.map(|end| end.dot(ahead));
        let start = self.way.dot(ahead).min(0);
        // A body behind the start is compared with the stretch itself, others as the light sees both.
        let (own, ends) = match heights.iter().all(|height| *height < start) {
            true => (self.own, ends),
            false => (
                self.seen,
                [0, 1].map(|it| ends[it].without(ahead, heights[it])),
            ),
        };
        if K::IS_BALL || K::IS_FLAT {
            return is_off(own, ends[0], reach);
        }
        let axis = ends[1].minus(ends[0]).normalised();
        let points = [Vector::ZERO, own.0.scaled(own.1.to_bits())];
        are_beside(ahead, (Vector::ZERO, own), (ends, reach))
            || are_beside(ahead, (ends[0], axis), (points, reach))
    }

    /// Tests whether a shape surely hides all points of the stretch. A convex body that blocks two rays to a light blocks
    /// all between. A wall that is open at both ends does so if no ray can pass through both.
    fn is_hidden_by<K: Bordered>(&self, shape: &K) -> bool {
        let [ahead, _] = self.towards;
        let (_, half_axis, radius) = shape.outline();
        let aside = half_axis.without(ahead, half_axis.dot(ahead));
        let is_flat = self.scale == 0 && self.stretch.bulge == 0;
        let mut rays = self.stretch.ends.iter().zip(self.towards);
        is_flat
            && (K::IS_BALL || K::IS_FLAT || aside.square() > square(radius + SLACK))
            && rays.all(|(end, direction)| {
                shape.is_ahead(&Ray {
                    origin: end.point,
                    direction,
                })
            })
    }
}

/// Tests whether two points surely lie further than `reach` from a segment, as a light sees all of them: on one side of it,
/// or beyond one of its ends. `ahead` leads to the light; the segment is given by its start, its direction and its length.
#[inline(never)]
fn are_beside(
    ahead: Direction,
    (start, (along, length)): (Vector, (Direction, Length)),
    (points, reach): ([Vector; 2], i32),
) -> bool {
    let passes = |axis: Direction, most: i32| {
        let [one, other] = points.map(|point| point.minus(start).dot(axis));
        one.min(other) > most || one.max(other) < -reach
    };
    passes(ahead.crossed(along), reach) || passes(along, length.to_bits() + reach)
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

        /// Returns whether a far light that no plane hides shines on all points of a stretch, or on none; `None` if that
        /// is not sure. The stretch faces it. `towards` are the directions from its ends to the light.
        #[inline(never)]
        pub(crate) fn far_lights_all<W: World>(
            world: &W,
            stretch: &LitStretch,
            towards: [Direction; 2],
        ) -> Option<bool> {
            let strip = Strip::new(stretch, towards);
            let (parts, first, is_unsure) = (world.parts(), 0, false);
            $(
                let mut is_unsure = is_unsure;
                for (index, shape) in parts.$list.iter().enumerate() {
                    // A convex surface hides no part of itself that faces the light.
                    let is_own = stretch.shape == ShapeId::at(first + index);
                    if !(is_own && !stretch.is_hollow || strip.misses(shape)) {
                        if !is_own && strip.is_hidden_by(shape) {
                            return Some(false);
                        }
                        is_unsure = true;
                    }
                }
                let first = first + parts.$list.len();
            )*
            let _ = first;
            (!is_unsure).then_some(true)
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
