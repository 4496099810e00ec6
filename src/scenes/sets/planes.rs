//! Tests that the lights that a view knows to be open or hidden agree with a test of every plane.

use super::*;
use crate::scene::Room;
use crate::scene::access::SceneAccess;
use crate::scene::shape_set::ShapeSet;

/// A scene of planes with its view, to compare the view's answers with a test of every plane.
struct Held<'a> {
    scene: &'a Scene<Room<0, 4, 0, 4, 1>>,
    view: LightVisibility,
    /// Number of tests in which a light was open, hidden and neither.
    standings: [u32; 3],
}

impl Held<'_> {
    /// Checks the view's answers for all lights at a point on a path: above the plane `left`, with the
    /// normal there, or between two hits. Returns false without a check if the point is so close to
    /// another plane that rounding decides on which side it is.
    fn at(&mut self, place: ScaledPoint, left: ShapeId, normal: Option<Direction>) -> bool {
        let parts = self.scene.parts();
        // Near an edge a point epsilon above one plane may be behind another, and a hit is exact to
        // 2^-26.
        let margin = Length::from_bits(4 * parts.epsilon.to_bits() + (64 << place.scale));
        let own = parts.plane(left).map(core::ptr::from_ref);
        let is_close = |plane: &PreparedPlane| {
            Some(core::ptr::from_ref(plane)) != own
                && matches!(plane.side(place, margin), Side::Close | Side::In)
        };
        if parts.planes.iter().any(is_close) {
            return false;
        }
        for light in 0..parts.lights.len() {
            self.under(light, place, left, normal);
        }
        true
    }

    /// Checks the view's answer for one light at a point: open must mean that no plane blocks the
    /// light, hidden that one does or that the light is behind the surface.
    fn under(
        &mut self,
        light: usize,
        place: ScaledPoint,
        left: ShapeId,
        normal: Option<Direction>,
    ) {
        let (scene, parts) = (self.scene, self.scene.parts());
        let from = parts.lights[light].place;
        let (way, scale) = place.to(from);
        let (direction, distance) = way.direction_and_length();
        // A light in a plane may be up to 4 steps behind it. Then a ray at a flat angle crosses the
        // plane more than epsilon before the light.
        let is_flat = |plane: &PreparedPlane| {
            let sine = plane.normal.dot(direction).to_num::<f64>().abs();
            plane.side(from, parts.epsilon) == Side::In
                && sine * f64::from(parts.epsilon.to_bits() >> scale.min(31)) < 8.0
        };
        if parts.planes.iter().any(is_flat) {
            return;
        }
        let path = ScaledRay::new(place, direction);
        let is_behind = normal.is_some_and(|normal| normal.dot(direction) <= Unit::ZERO);
        let is_blocked = occluded(scene, ShapeSet::ALL, &path, left, (from, distance, scale));
        let (is_open, is_hidden) = (self.view.is_open(light), self.view.is_hidden(light));
        let (standing, is_true) = match (is_open, is_hidden) {
            (true, false) => (0, !is_blocked),
            (false, true) => (1, is_behind || is_blocked),
            (false, false) => (2, true),
            (true, true) => (0, false),
        };
        self.standings[standing] += 1;
        assert!(
            is_true && (is_open || !self.view.is_clear(light)),
            "open {is_open}, hidden {is_hidden}: {path:?} of {:?} to {:?} among {:?}",
            self.view,
            from,
            parts.planes
        );
    }

    /// Follows a path from the camera over up to four mirrors, and checks the view's answers along it.
    fn along(&mut self, random: &mut Sweep, direction: Direction) {
        let (mut path, mut left) = (ScaledRay::new(self.view.from, direction), ShapeId::NONE);
        for _ in 0..4 {
            let Some((at, shape)) = first(self.scene, &path, left) else {
                return;
            };
            // Points with a larger scale are too coarse to compare.
            if at.scale > 16 {
                return;
            }
            if path.from().is_near() && at.is_near() {
                let (_, length) = path.from().point.to(at.point).direction_and_length();
                let part = f64::from(length.to_bits()) * random.share().abs();
                let part = Length::from_bits(part as i32);
                let on_the_way = ScaledPoint::new(path.ray.origin.along(path.direction(), part), 0);
                self.at(on_the_way, ShapeId::NONE, None);
            }
            let surface = Surface::new(self.scene, at, shape, path.direction()).unwrap();
            if !self.at(surface.place, shape, Some(surface.normal)) {
                return;
            }
            surface.reflect(self.scene, &mut path);
            left = shape;
        }
    }
}

#[test]
fn view_knows_from_which_lights_planes_hide_what_it_shows() {
    let mut random = Sweep::new(0x3c6e_f372_fe94_f82b);
    let mut standings = [0; 3];
    for round in 0..3000 {
        let mut scene = RuntimeScene::<Room<0, 4, 0, 4, 1>>::new();
        let glass = Material::new([1.0; 3]).mirror(0.5);
        let glass = scene.add_material(glass).unwrap();
        let points = [0; 4].map(|_| random.place());
        for point in &points[..1 + round % 4] {
            scene.add_plane(*point, random.place(), glass).unwrap();
        }
        // The four lights: among the planes, beside them, in one of them, and far away.
        let [near, beside, far] = [1.0, 8.0, 1e6].map(|size| random.place().map(|x| size * x));
        for light in [near, beside, points[0], far] {
            scene.add_light(light, [1, 1, 1]).unwrap();
        }
        // The camera sets the middle of a scene of planes.
        scene.set_camera(camera(&mut random, [0.1, 0.2, 0.3]));
        let scene = scene.build().unwrap();
        let size = [1.0, 3.0, 3.0, 1e6][round / 4 % 4];
        let position = random.place().map(|x| size * x);
        let from = scene.parts().grid.place(Position::new(position));
        let mut held = Held {
            scene: &scene,
            view: LightVisibility::new(&scene, from),
            standings,
        };
        for _ in 0..10 {
            let target = random.place();
            let towards = [0, 1, 2].map(|it| 2.0 * target[it] - position[it]);
            let direction = Position::new(towards).direction().unwrap();
            held.along(&mut random, direction);
        }
        standings = held.standings;
    }
    let [open, hidden, neither] = standings;
    assert!(
        open > 10_000 && hidden > 10_000 && neither > 100,
        "{standings:?}"
    );
}
