//! Whether a far light shines on all points of a stretch, or on none.
//!
//! The light's rays to the points of the stretch form a strip. Bound: docs/internals/edges.md proves the rules by which a
//! shape surely hides all of it, or nothing.

use super::World;
use super::light_stretch::LitStretch;
use super::stretch::is_off;
use crate::number::{Length, Unit};
use crate::ray::{Ray, ScaledPoint, shift_of};
use crate::scene::shape_set::ShapeSet;
use crate::shape::bordered::{Bordered, square};
use crate::shape::rays::SLACK;
use crate::vector::{Direction, Point, Vector};

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
    /// Upper bound of the distance of a ray from that of the first end, in steps: none is further from it than the stretch
    /// is long. `None` if the stretch is far, or longer than [`WIDEST`].
    width: Option<i32>,
}

impl<'a> Strip<'a> {
    /// Returns the rays from a stretch to a far light. `towards` holds the directions from its two ends to the light.
    fn new(stretch: &'a LitStretch, towards: [Direction; 2]) -> Self {
        let [first, last] = stretch.ends;
        let (way, scale) = first.to(last);
        let own = way.normalised();
        let thickness = (stretch.bulge >> shift_of(scale)) + SLACK;
        let width = own.1.to_bits().saturating_add(thickness);
        Self {
            stretch,
            towards,
            way,
            scale,
            own,
            seen: way.without(towards[0], way.dot(towards[0])).normalised(),
            thickness,
            width: (scale == 0 && width < WIDEST).then_some(width),
        }
    }

    /// Tests whether the capsule around a shape surely lies behind the start of the strip, or beside it.
    #[inline(never)]
    fn misses<K: Bordered>(&self, shape: &K) -> bool {
        let (center, radius) = shape.bounding_ball();
        let way = self.stretch.ends[0].point.to(center);
        let ([ahead, _], shift) = (self.towards, shift_of(self.scale));
        let passes = |width| way.passes_by(ahead, radius + width);
        if self.width.is_some_and(passes) {
            return true;
        }
        let (center, half_axis, radius) = shape.outline();
        let reach = (radius >> shift) + self.thickness;
        let ends = [half_axis, Vector::ZERO.minus(half_axis)].map(|half| {
            let end = Point::at(center.to_vector().plus(half));
            let (way, scale) = self.stretch.ends[0].to(ScaledPoint::at(end));
            way.coarser(shift_of(self.scale - scale))
        });
        let heights = ends.map(|end| end.dot(ahead));
        let start = self.way.dot(ahead).min(0);
        // A body behind the start is compared with the stretch itself, others as the light sees both.
        let (own, ends) = if heights.iter().all(|height| *height < start) {
            (self.own, ends)
        } else {
            (
                self.seen,
                [0, 1].map(|it| ends[it].without(ahead, heights[it])),
            )
        };
        if K::IS_BALL || K::IS_FLAT {
            return is_off(own, ends[0], reach);
        }
        let axis = ends[1].minus(ends[0]).normalised();
        let points = [Vector::ZERO, own.0.scaled(own.1.to_bits())];
        are_off(ahead, (Vector::ZERO, own), (ends, reach))
            || are_off(ahead, (ends[0], axis), (points, reach))
    }

    /// Tests whether a shape surely hides all points of a straight stretch. A convex body that blocks two rays to a light
    /// blocks all between.
    fn is_hidden_by<K: Bordered>(&self, shape: &K) -> bool {
        let is_straight = self.scale == 0 && self.stretch.bulge == 0;
        let mut rays = self.stretch.ends.iter().zip(self.towards);
        is_straight
            && (K::IS_BALL || K::IS_FLAT || self.is_oblique(shape))
            && rays.all(|(end, direction)| {
                shape.is_ahead(&Ray {
                    origin: end.point,
                    direction,
                })
            })
    }

    /// Tests whether surely no ray of the light passes through both open ends of a cylinder. The light sees them next to each
    /// other, if half of the axis looks longer to it than the radius.
    ///
    /// Between two directions up to 20 degrees apart, the part of the half axis along a ray is at most 1.016 times as long
    /// as along those two. So the square of its part aside is less by a thirty-second of the whole at most.
    fn is_oblique<K: Bordered>(&self, shape: &K) -> bool {
        let (_, half_axis, radius) = shape.outline();
        let [one, other] = self.towards;
        let least = square(radius + SLACK) + (half_axis.square() >> 5);
        one.dot(other) > ALIKE
            && self.towards.iter().all(|ahead| {
                let aside = half_axis.without(*ahead, half_axis.dot(*ahead));
                aside.square() > least
            })
    }
}

/// Largest width of a strip, in steps: with the radius of a shape, its square fits 62 bits.
const WIDEST: i32 = 1 << 28;

/// The cosine of 20 degrees.
const ALIKE: Unit = Unit::from_bits(1_009_000_000);

/// Tests whether two points surely lie further than `reach` from a segment, as a light sees all of them: on one side of it,
/// or beyond one of its ends. `ahead` leads to the light; the segment is given by its start, its direction and its length.
#[inline(never)]
fn are_off(
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

macro_rules! far_lights {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        /// Returns whether a far light that no plane hides shines on all points of a stretch, or on none; `None` if that
        /// is not sure. The stretch faces it. `towards` are the directions from its ends to the light.
        ///
        /// `suspects` holds all shapes that may hide a point of the stretch from the light. If the answer is not sure,
        /// those are removed of which it was proved that they hide none.
        #[inline(never)]
        pub(crate) fn far_lights_all<W: World>(
            world: &W,
            stretch: &LitStretch,
            towards: [Direction; 2],
            suspects: &mut ShapeSet,
        ) -> Option<bool> {
            let strip = Strip::new(stretch, towards);
            let (parts, mut unsure) = (world.parts(), ShapeSet::NONE);
            let [$($list),*] = parts.kinds();
            $(
                let is_hidden = suspects.any(true, $list, parts.$list, |index, shape| {
                    // A convex surface hides no part of itself that faces the light.
                    let is_own = stretch.shape == $list.id(index);
                    if is_own && !stretch.is_hollow || strip.misses(shape) {
                        return false;
                    }
                    unsure = unsure.with($list.set_of(index));
                    !is_own && strip.is_hidden_by(shape)
                });
                if is_hidden {
                    return Some(false);
                }
            )*
            *suspects = unsure;
            (unsure == ShapeSet::NONE).then_some(true)
        }
    };
}
kinds!(far_lights);

#[cfg(test)]
mod tests;
