//! A family of all that a scene may have, at any scale and place. It is made to be compared with double precision.

use command_line::Shading;
use reflet::host::reference::{Checker, Light, Material, Sky, Vector};

use super::draft::Draft;
use super::random::Random;

/// Number of materials.
const MATERIALS: usize = 4;

/// Where a scene in a cube of ±1 is moved, and by what it is scaled after that.
struct Place {
    offset: Vector,
    scale: f64,
}

impl Place {
    fn of(random: &mut Random) -> Self {
        Self {
            offset: random.cube() * random.pick(&[0.0, 0.0, 100.0]),
            scale: if random.chance(0.25) { 1.0 } else { random.log_between(1e-3, 1e5) },
        }
    }

    fn at(&self, point: Vector) -> Vector {
        (point + self.offset) * self.scale
    }
}

/// Makes shapes, lights, a sky and a camera of any kind. The lights fall off if they `fade`.
pub fn any(draft: &mut Draft, fade: bool) {
    let place = Place::of(&mut draft.random);
    draft.scene.background = draft.random.channels();
    draft.scene.epsilon = 1e-4 * place.scale;
    let materials = (0..MATERIALS).map(|_| material(&mut draft.random, place.scale));
    draft.scene.materials = materials.collect();
    shapes(draft, &place);
    let lights = (0..draft.random.count(1, 3)).map(|_| light(&mut draft.random, &place, fade));
    draft.scene.lights = lights.collect();
    if draft.random.chance(0.3) {
        draft.scene.sky = Some(Sky {
            up: draft.random.cube().0,
            below: draft.random.channels(),
            horizon: draft.scene.background,
            above: draft.random.channels(),
        });
    }
    draft.reflections = draft.random.count(0, 8) as u8;
    let shadings = [Shading::BlinnPhong, Shading::Phong, Shading::Normals];
    draft.shading = draft.random.pick(&shadings);
    camera(draft, &place);
}

fn material(random: &mut Random, scale: f64) -> Material {
    let shininess = [
        random.count(0, 16) as f64,
        random.pick(&[32.0, 50.0, 128.0]),
        random.between(0.0, 200.0),
    ];
    let part = random.between(0.0, 1.0);
    let [x, y, z] = [0; 3].map(|_| scale * random.between(0.1, 1.0));
    let size = random.pick(&[[x, y, z], [x, x, 0.0]]);
    let checker = Checker {
        color: random.channels(),
        size,
    };
    Material {
        color: random.channels(),
        ambient: random.between(0.0, 0.3),
        diffuse: random.between(0.0, 1.0),
        specular: random.between(0.0, 1.0),
        shininess: random.pick(&shininess),
        mirror: random.pick(&[0.0, 0.0, 0.0, part, part, part, 1.0]),
        checker: random.chance(0.3).then_some(checker),
    }
}

fn shapes(draft: &mut Draft, place: &Place) {
    let scale = place.scale;
    for _ in 0..draft.random.count(1, 15) {
        let (center, radius) = (draft.random.cube(), draft.random.between(0.02, 0.4));
        let material = draft.random.count(0, MATERIALS - 1);
        draft.sphere(place.at(center), radius * scale, material);
    }
    for _ in 0..draft.random.count(0, 3) {
        let (point, normal) = (draft.random.cube() * 2.0, draft.random.cube());
        let material = draft.random.count(0, MATERIALS - 1);
        draft.plane(place.at(point), normal, material);
    }
    for _ in 0..draft.random.count(0, 5) {
        let (center, axis) = (draft.random.cube(), draft.random.cube());
        let radius = scale * draft.random.between(0.02, 0.3);
        let size = (radius, scale * draft.random.between(0.05, 2.0));
        let material = draft.random.count(0, MATERIALS - 1);
        draft.cylinder(place.at(center), axis, size, material);
    }
    for _ in 0..draft.random.count(0, 3) {
        let (center, normal) = (draft.random.cube(), draft.random.cube());
        let radius = scale * draft.random.between(0.05, 0.6);
        let material = draft.random.count(0, MATERIALS - 1);
        draft.disc(place.at(center), normal, radius, material);
    }
}

/// Makes a light that is near or far.
fn light(random: &mut Random, place: &Place, fades: bool) -> Light {
    let away = match random.count(0, 5) {
        0 => random.between(10.0, 1000.0),
        1 => 5e3,
        _ => random.between(0.5, 3.0),
    };
    let color = random.channels();
    let range = away * place.scale * (0.02 + 3.0 * color[0] * color[0]);
    Light {
        position: place.at(random.cube() * away).0,
        color,
        sun: None,
        range: fades.then_some(range.clamp(1e-9, 1e9)), // above 0, at most 2^30
    }
}

/// Puts the camera among the shapes, into a sphere, or outside.
fn camera(draft: &mut Draft, place: &Place) {
    let target = place.at(draft.random.cube() * 0.3);
    let random = &mut draft.random;
    let (position, fov) = match random.count(0, 8) {
        0..3 => (place.at(random.cube()), random.between(30.0, 120.0)),
        3 => {
            let sphere = random.pick(&draft.scene.spheres);
            let center = Vector(sphere.center) + Vector([0.3 * sphere.radius; 3]);
            (center, random.between(30.0, 120.0))
        }
        4..8 => {
            let away = random.direction() * random.between(2.0, 5.0);
            (place.at(away), random.between(30.0, 70.0))
        }
        _ => {
            let away = random.direction() * random.between(15.0, 100.0);
            (place.at(away), random.between(1.0, 8.0))
        }
    };
    let up = random.cube();
    draft.look(position, target, up, fov);
}
