//! Whether all paths between two traced ones surely meet the same shapes, lit by the same lights.
//!
//! It is known for the first hit, and for the second if a plane mirrored the path: these rays start at one
//! eye and lie in one plane. docs/edges.md has the proof.

use super::{PathQuality, Stop, Traced, Tracer};
use crate::accel::light_occluders::LightOccluders;
use crate::accel::stretch::{Body, Stretch};
use crate::accel::{LitStretch, Window, World, lights_all};
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, square_root, unit_product};
use crate::scene::access::ShapeId;
use crate::shade::Glance;
use crate::shade::highlight::sealed::Shading;
use crate::shape::bordered::Ball;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point};

/// Pixels between two traced ones: the window of the row, and the columns of the two.
pub(crate) type Between<'a> = (&'a Window, [u32; 2]);

/// The plane that mirrored a stretch, if one did.
type Mirror<'a> = Option<(ShapeId, &'a PreparedPlane)>;

/// The surface that a stretch shows.
struct Shown<'a> {
    material: &'a PreparedMaterial,
    lit: LitStretch,
    /// The point from which the rays come: the camera or its image.
    eye: Point,
}

impl<'a, W: World, K: Shading, Q: PathQuality> Tracer<'a, W, K, Q> {
    /// Tests whether all paths between two traced ones surely meet the same shapes, lit by the same lights,
    /// as far as the paths have known bounds. The two have equal signatures.
    #[inline(never)]
    pub(crate) fn is_steady(&mut self, between: Between<'_>, ends: [&Traced; 2]) -> bool {
        let parts = self.world.parts();
        let mut mirror = None;
        for level in 0..2 {
            let [first, last] = ends.map(|end| &end.stops[level]);
            if first.shape == ShapeId::BEYOND {
                return true;
            }
            let is_one = first.shape == last.shape && first.is_inside == last.is_inside;
            let is_near = first.place.is_near() && last.place.is_near();
            if !is_one || !self.keeps_shape(between, mirror, [first, last], is_near) {
                return false;
            }
            let Some(plane) = parts.plane(first.shape) else {
                return true;
            };
            // Rays that a far point mirrors have no known bounds.
            if !is_near && K::REFLECTS && parts.material(plane.material).mirrors() {
                return !parts.has_bounded();
            }
            mirror = Some((first.shape, plane));
        }
        true
    }

    /// Tests whether all rays between two hit the same shape, lit by the same lights.
    fn keeps_shape(
        &mut self,
        between: Between<'_>,
        mirror: Mirror<'_>,
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
            mirror: mirror.map(|(_, plane)| plane),
        };
        if first.shape == ShapeId::NONE || !is_near {
            return self.culling.keeps(self.world, mirror, between.0, &stretch)
                && (first.shape == ShapeId::NONE || self.keeps_far_light(first.shape));
        }
        let Some((shown, row)) = self.shown(mirror, stops) else {
            return false;
        };
        let parts = self.world.parts();
        let is_curved = !parts.is_flat(first.shape);
        let [(_, one), (_, other)] = shown.lit.ends;
        // The line from end to end turns by less than a right angle.
        if is_curved && one.dot(other) < unit_product(one.dot(row), other.dot(row)) {
            return false;
        }
        let (middle, radius) = shown.lit.ball;
        let (_, distance) = shown.eye.to(middle).direction_and_length();
        let stretch = Stretch {
            body: match parts.plane(first.shape) {
                Some(plane) => Body::Plane(plane),
                None => parts
                    .ball(first.shape.index())
                    .map_or(Body::None, |(ball, _)| Body::Ball(ball)),
            },
            ball: Some(shown.lit.ball),
            reach: (!is_curved || !first.is_inside).then_some(distance.to_bits() + radius),
            ..stretch
        };
        self.culling.keeps(self.world, mirror, between.0, &stretch) && self.keeps_lights(&shown)
    }

    /// Returns the surface that a stretch shows, and the normal of the row's plane.
    fn shown(&self, mirror: Mirror<'_>, stops: [&Stop; 2]) -> Option<(Shown<'a>, Direction)> {
        let parts = self.world.parts();
        let (eye, row) = self.culling.eye(self.world, mirror)?;
        let [first, last] = stops.map(|stop| {
            let point = stop.place.point;
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
        let material = parts.material(material);
        Some((Shown { material, lit, eye }, row))
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
