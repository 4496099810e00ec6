//! Whether all paths between two traced ones surely meet the same shapes, lit by the same lights.
//!
//! It is known for the first hit, and for the second if a plane mirrored the path: these rays start at one
//! eye and lie in one plane. docs/edges.md has the proof.

use super::{PathQuality, STOPS, Stop, Stops, Tracer};
use crate::accel::light_occluders::LightOccluders;
use crate::accel::stretch::{Body, Stretch};
use crate::accel::{LitStretch, Window, World, is_clear_way, lights_all};
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, ratio, square_root, unit_product, unsigned, unsigned_wide, wide};
use crate::scene::access::ShapeId;
use crate::shade::Glance;
use crate::shade::highlight::sealed::Shading;
use crate::shape::bordered::Ball;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point, Vector};

/// Pixels between two traced ones: the window of the row, and the columns of the two.
pub(crate) type Between<'a> = (&'a Window, [u32; 2]);

/// What is known of all paths between two traced ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Steadiness {
    /// Nothing.
    None,
    /// The camera's rays, and their first reflection in a plane, meet the same shapes, lit by the same
    /// lights.
    First,
    /// All rays meet the same shapes, lit by the same lights.
    All,
}

/// Where the rays of a stretch come from.
#[derive(Clone, Copy)]
struct Origin<'a> {
    /// The camera, or its image in one plane after another.
    eye: Point,
    /// Normal of the plane in which the rays lie.
    row: Direction,
    /// Number of reflections.
    level: usize,
    /// The plane that mirrored the rays last.
    mirror: Option<(ShapeId, &'a PreparedPlane)>,
}

/// The surface that a stretch shows.
struct Shown<'a> {
    material: &'a PreparedMaterial,
    lit: LitStretch,
    /// Change of the normal from one end to the other.
    turn: Vector,
    /// Direction and distance from the eye to the middle.
    view: (Direction, i32),
    eye: Point,
}

impl<'a, W: World, K: Shading, Q: PathQuality> Tracer<'a, W, K, Q> {
    /// Returns what is known of all paths between two traced ones that have equal signatures.
    #[inline(never)]
    pub(crate) fn steadiness(&mut self, between: Between<'_>, ends: [&Stops; 2]) -> Steadiness {
        let parts = self.world.parts();
        let mut known = Steadiness::None;
        let Some((eye, row)) = self.culling.eye() else {
            return known;
        };
        let mut origin = Origin {
            eye,
            row,
            level: 0,
            mirror: None,
        };
        let [start, end] = ends.map(Stops::all);
        for (first, last) in start.iter().zip(end) {
            let is_one = first.shape == last.shape && first.is_inside == last.is_inside;
            let is_near = first.is_near && last.is_near;
            if !is_one || !self.keeps_shape(between, &origin, [first, last], is_near) {
                return known;
            }
            let Some(plane) = parts.plane(first.shape) else {
                return Steadiness::All;
            };
            // Rays that a far point mirrors have no known bounds.
            let mirrors = K::REFLECTS && parts.material(plane.material).mirrors();
            if !mirrors || !parts.has_bounded() {
                return Steadiness::All;
            }
            if origin.level > 0 {
                known = Steadiness::First;
            }
            let Some(eye) = plane
                .mirrored(origin.eye, parts.epsilon)
                .filter(|_| is_near)
            else {
                return known;
            };
            origin = Origin {
                eye,
                row: origin
                    .row
                    .reflected(plane.normal, origin.row.dot(plane.normal)),
                level: origin.level + 1,
                mirror: Some((first.shape, plane)),
            };
        }
        match start.len() == end.len() && start.len() < STOPS {
            true => Steadiness::All,
            false => Steadiness::First,
        }
    }

    /// Tests whether all rays between two hit the same shape, lit by the same lights.
    fn keeps_shape(
        &mut self,
        between: Between<'_>,
        origin: &Origin<'_>,
        stops: [&Stop; 2],
        is_near: bool,
    ) -> bool {
        let [first, _] = stops;
        let stretch = Stretch {
            columns: between.1,
            shape: first.shape,
            body: Body::None,
            ball: None,
            reach: None,
            mirror: origin.mirror.map(|(_, plane)| plane),
        };
        if first.shape == ShapeId::NONE || !is_near {
            return origin.level < 2
                && self
                    .culling
                    .keeps(self.world, origin.mirror, between.0, &stretch)
                && (first.shape == ShapeId::NONE || self.keeps_far_light(first.shape));
        }
        let Some(shown) = self.shown(origin.eye, stops) else {
            return false;
        };
        let parts = self.world.parts();
        let is_curved = !parts.is_flat(first.shape);
        let [(_, one), (_, other)] = shown.lit.ends;
        // The line from end to end turns by less than a right angle.
        if is_curved && one.dot(other) < unit_product(one.dot(origin.row), other.dot(origin.row)) {
            return false;
        }
        let (_, radius) = shown.lit.ball;
        if origin.level > 1 {
            return is_clear_way(self.world, origin.eye, &shown.lit) && self.keeps_lights(&shown);
        }
        let stretch = Stretch {
            body: match parts.plane(first.shape) {
                Some(plane) => Body::Plane(plane),
                None => parts
                    .ball(first.shape.index())
                    .map_or(Body::None, |(ball, _)| Body::Ball(ball)),
            },
            ball: Some(shown.lit.ball),
            reach: (!is_curved || !first.is_inside).then_some(shown.view.1 + radius),
            ..stretch
        };
        self.culling
            .keeps(self.world, origin.mirror, between.0, &stretch)
            && self.keeps_lights(&shown)
    }

    /// Returns the surface that a stretch shows.
    fn shown(&self, eye: Point, stops: [&Stop; 2]) -> Option<Shown<'a>> {
        let parts = self.world.parts();
        let [first, last] = stops.map(|stop| {
            let point = stop.point;
            let (outward, material) = parts.outside(stop.shape, point)?;
            Some(((point, outward.reversed_if(stop.is_inside)), material))
        });
        let ((first, material), (last, _)) = (first?, last?);
        let [stop, _] = stops;
        let epsilon = parts.epsilon.to_bits().max(parts.inner_epsilon.to_bits());
        let lit = LitStretch {
            shape: stop.shape,
            is_inside: stop.is_inside,
            is_flat: parts.is_flat(stop.shape),
            ball: ball_over(first.0, last.0, 2 * epsilon),
            ends: [first, last],
        };
        let (direction, distance) = eye.to(lit.ball.0).direction_and_length();
        Some(Shown {
            material: parts.material(material),
            lit,
            turn: last.1.raw().minus(first.1.raw()),
            view: (direction, distance.to_bits()),
            eye,
        })
    }

    /// Tests whether each light shines on a whole stretch or on nothing of it, with a highlight that can be
    /// interpolated.
    fn keeps_lights(&self, shown: &Shown<'_>) -> bool {
        let world = self.world;
        let has_shadows = K::SHADOWS && W::NEEDS.shadows && world.parts().has_bounded();
        let has_highlight = W::NEEDS.highlights && shown.material.specular > Brightness::ZERO;
        let lights = world.tables().light_occluders.iter().enumerate();
        lights.into_iter().all(|(index, light)| {
            if self.visibility.is_hidden(index) {
                return true;
            }
            let is_lit = match has_shadows {
                false => Some(true),
                true if !self.visibility.is_clear(index) => None,
                true => lights_all::<W, Q>(world, (light, index), &shown.lit),
            };
            match is_lit {
                None => false,
                Some(false) => true,
                Some(true) => !has_highlight || keeps_highlight::<K>(shown, light.light()),
            }
        })
    }

    /// Tests whether each light shines on a whole far stretch of a plane or on nothing of it. That is only
    /// known if nothing can throw a shadow there.
    fn keeps_far_light(&self, shape: ShapeId) -> bool {
        let parts = self.world.parts();
        let Some(plane) = parts.plane(shape) else {
            return false;
        };
        let has_shadows = K::SHADOWS && W::NEEDS.shadows && parts.has_bounded();
        let has_highlight =
            W::NEEDS.highlights && parts.material(plane.material).specular > Brightness::ZERO;
        let lights = world_lights(self.world);
        !(has_shadows || has_highlight)
            || (0..lights.len()).all(|index| self.visibility.is_hidden(index))
    }
}

/// Returns the lights of a scene.
fn world_lights<W: World>(world: &W) -> &[LightOccluders<W::Room>] {
    world.tables().light_occluders
}

/// Tests whether the highlight of a light can be interpolated.
fn keeps_highlight<K: Shading>(shown: &Shown<'_>, light: &PreparedLight) -> bool {
    if is_surely_smooth(shown, light) {
        return true;
    }
    let glances = shown.lit.ends.map(|(point, normal)| Glance {
        normal,
        view: shown.eye.to(point).direction_and_length().0,
        along: light
            .place
            .to(crate::ray::ScaledPoint::new(point, 0))
            .0
            .direction_and_length()
            .0,
    });
    K::is_smooth(&glances, shown.material.shininess)
}

/// Tests whether the highlight of a near light surely changes little, from bounds of the changes of the
/// normal and of the directions to the light and to the eye.
///
/// Each of these directions changes by at most the diameter of the ball over the distance. The half-way
/// vector is their sum over its length, which is at least the sum of the cosines to the normal.
fn is_surely_smooth(shown: &Shown<'_>, light: &PreparedLight) -> bool {
    let (middle, radius) = shown.lit.ball;
    let (view, distance) = shown.view;
    let [(_, normal), _] = shown.lit.ends;
    if !light.place.is_near() {
        return false;
    }
    let (along, length) = light.place.point.to(middle).direction_and_length();
    let nearest = distance.min(length.to_bits());
    // Bounds in Q2.30, of which 2⁻⁴ is the largest that counts.
    let turn = shown.turn.square();
    let cosines = -(normal.dot(view).to_bits() >> 1) - (normal.dot(along).to_bits() >> 1);
    if nearest >> 3 <= radius || turn > 1 << 52 || cosines < 1 << 26 {
        return false;
    }
    let change = ratio(unsigned(4 * radius), unsigned(nearest));
    let change = match change < cosines {
        true => ratio(unsigned(change), unsigned(cosines)) >> 1,
        false => return false,
    };
    let turn = square_root(turn);
    // Twice as much for Phong's mirrored light.
    let both = 2 * (turn >> 2) + 2 * (change >> 2);
    let square = unsigned_wide(wide(both, both)) >> 26;
    square * u64::from(shown.material.shininess.next_integer()) <= 1 << 29
}

/// Returns the ball over the distance between two points, enlarged by `more`.
fn ball_over(one: Point, other: Point, more: i32) -> Ball {
    let way = one.to(other);
    let middle = Point::new(
        one.x + (way.x >> 1),
        one.y + (way.y >> 1),
        one.z + (way.z >> 1),
    );
    (middle, (square_root(way.square()) >> 1) + more + 8)
}
