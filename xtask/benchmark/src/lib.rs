//! Scenes of any number of spheres that are alike but for the number, so that what they cost tells
//! what a shape costs.
//!
//! Beads hang over a mirroring floor along a spiral that faces the camera, before one light. The
//! turns of the spiral are as far apart as the beads along it. The more beads, the smaller they
//! are, so that they fill the same share of the picture; camera, floor and light stay as they are.
//! Every other bead, the first one among them, is a mirror.
//!
//! A scene is handed out as the text of a scene file, which the library and its reference read
//! alike.

use std::f64::consts::PI;

use serde_json::{Value, json};

/// In which order a scene lists its spheres; the picture is the same.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// As they follow each other along the spiral: neighbours in the list are neighbours in space,
    /// as in a scene that somebody writes down thing by thing.
    Spiral,
    /// At random: the place in the list says nothing about the place in space.
    Shuffled,
}

/// The radius of a single bead: n of them with a radius of this over √n fill the same area.
const RADIUS: f64 = 6.0;

/// The middle of the spiral, over the middle of the floor.
const MIDDLE: [f64; 3] = [0.0, 0.0, 8.0];

/// The spiral's second direction, the first being the x axis.
const UP: [f64; 3] = [0.0, 0.6, 0.8];

/// Before the middle of the spiral, at a right angle to it.
const CAMERA: [f64; 3] = [0.0, -24.0, 26.0];

/// So narrow, in degrees, that the spiral fills the picture, and wide enough for all of it.
const FOV: f64 = 35.0;

/// Beads are this many radii apart, along the spiral and from turn to turn.
const APART: f64 = 2.25;

/// By how many beads the turns begin later than a spiral that starts in the middle: there the turns
/// are too narrow for beads, so only the first of them lies in the middle.
const SKIPPED: f64 = 1.75;

/// Name, colour, highlight and mirror of the beads' materials, in turns, and of the floor's.
const MATERIALS: [(&str, [f64; 3], f64, f64); 5] = [
    ("silver", [0.8, 0.8, 0.8], 0.6, 0.7),
    ("ruby", [0.8, 0.2, 0.2], 0.3, 0.0),
    ("gold", [0.8, 0.6, 0.2], 0.6, 0.5),
    ("jade", [0.2, 0.6, 0.3], 0.3, 0.0),
    ("floor", [0.5, 0.5, 0.6], 0.0, 0.3),
];

/// The text of the scene file with this many spheres.
///
/// ```
/// use reflet::host::file::SceneFile;
/// use benchmark::{Order, scene};
///
/// let file = SceneFile::parse(&scene(100, Order::Spiral), None).unwrap();
/// assert_eq!(file.name(), Some("spiral_100"));
/// let (scene, _camera) = file.reference();
/// assert_eq!((scene.spheres.len(), scene.planes.len(), scene.lights.len()), (100, 1, 1));
/// assert!(file.build().is_ok());
/// ```
pub fn scene(count: usize, order: Order) -> String {
    let mut spheres = beads(count);
    let name = match order {
        Order::Spiral => format!("spiral_{count}"),
        Order::Shuffled => {
            shuffle(&mut spheres);
            format!("shuffled_{count}")
        }
    };
    let materials = MATERIALS.map(|(name, color, specular, mirror)| {
        json!({
            "name": name, "color": color, "ambient": 0.2, "diffuse": 0.6,
            "specular": specular, "shininess": 16.0, "mirror": mirror,
        })
    });
    let scene = json!({
        "name": name,
        "camera": {
            "position": CAMERA, "target": MIDDLE, "up": [0.0, 0.0, 1.0], "fov": FOV,
        },
        "materials": materials,
        "lights": [{ "position": [-18.0, -16.0, 30.0], "color": [1.0, 1.0, 1.0] }],
        "spheres": spheres,
        "planes": [{
            "center": [0.0, 0.0, 0.0], "normal": [0.0, 0.0, 1.0], "material": "floor",
        }],
        "background": [0.4, 0.5, 0.7],
    });
    scene.to_string()
}

/// The beads, from the middle on.
fn beads(count: usize) -> Vec<Value> {
    let radius = RADIUS / (count as f64).sqrt();
    let places: Vec<_> = (0..count)
        .map(|index| place(index, APART * radius))
        .collect();
    let [x, y] = [0, 1].map(|axis| middle(places.iter().map(|place| place[axis])));
    let bead = |(index, place): (usize, &[f64; 2])| {
        let (aside, above) = (place[0] - x, place[1] - y);
        let [_, back, up] = [0, 1, 2].map(|axis| MIDDLE[axis] + UP[axis] * above);
        json!({
            "center": [short(aside), short(back), short(up)],
            "radius": short(radius),
            "material": MATERIALS[index % 4].0,
        })
    };
    places.iter().enumerate().map(bead).collect()
}

/// Where a bead lies if beads are a `step` apart.
///
/// A spiral of which n steps lie within √(n / π) steps from its middle, at an angle of √(4 π n),
/// has turns that are a step apart.
fn place(index: usize, step: f64) -> [f64; 2] {
    let steps = match index {
        0 => 0.0,
        _ => index as f64 + SKIPPED,
    };
    let (away, angle) = (step * (steps / PI).sqrt(), (4.0 * PI * steps).sqrt());
    [away * angle.cos(), away * angle.sin()]
}

/// Half-way between the least and the largest.
fn middle(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let largest = values.fold(f64::NEG_INFINITY, f64::max);
    (least + largest) / 2.0
}

/// To three decimals, so that the scene does not depend on the last digit of a machine's cosine.
fn short(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// Fisher and Yates's shuffle, with numbers that are the same each time (Marsaglia, "Xorshift
/// RNGs", 2003).
fn shuffle<T>(items: &mut [T]) {
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for last in (1..items.len()).rev() {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        items.swap(last, (state % (last as u64 + 1)) as usize);
    }
}

#[cfg(test)]
mod tests {
    use reflet::host::file::SceneFile;
    use reflet::host::reference::{Camera, Scene, Sphere, Vector};

    use super::*;

    const COUNTS: [usize; 9] = [1, 2, 4, 8, 16, 32, 64, 128, 256];

    fn read(count: usize, order: Order) -> (Scene, Camera) {
        let file = SceneFile::parse(&scene(count, order), None).unwrap();
        file.reference()
    }

    fn distance(one: &Sphere, other: &Sphere) -> f64 {
        (Vector(one.center) - Vector(other.center)).length()
    }

    #[test]
    fn beads_touch_neither_the_floor_nor_each_other() {
        for count in COUNTS {
            let (scene, _) = read(count, Order::Spiral);
            for (index, bead) in scene.spheres.iter().enumerate() {
                assert!(bead.center[2] > bead.radius, "{count}: {bead:?}");
                for other in &scene.spheres[..index] {
                    assert!(
                        distance(bead, other) > 2.0 * bead.radius,
                        "{count}: {bead:?}"
                    );
                }
            }
        }
    }

    #[test]
    fn beads_fill_the_same_area_whatever_their_number() {
        for count in COUNTS {
            let (scene, _) = read(count, Order::Spiral);
            let area: f64 = scene.spheres.iter().map(|bead| bead.radius.powi(2)).sum();
            assert!(
                (area / RADIUS.powi(2) - 1.0).abs() < 2e-3,
                "{count}: {area}"
            );
        }
    }

    #[test]
    fn every_bead_is_in_the_picture() {
        for count in COUNTS {
            let (scene, camera) = read(count, Order::Spiral);
            let ahead = (Vector(camera.target) - Vector(camera.position)).unit();
            let right = ahead.cross(Vector(camera.up)).unit();
            let up = right.cross(ahead);
            let (sine, cosine) = (camera.fov.to_radians() / 2.0).sin_cos();
            for bead in &scene.spheres {
                let way = Vector(bead.center) - Vector(camera.position);
                for side in [way.dot(right), way.dot(up)] {
                    // How far the middle is from the edge of what is seen.
                    let inside = way.dot(ahead) * sine - side.abs() * cosine;
                    assert!(inside > bead.radius, "{count}: {bead:?}");
                }
            }
        }
    }

    #[test]
    fn neighbours_on_the_spiral_are_neighbours_in_space() {
        let (scene, _) = read(256, Order::Spiral);
        for pair in scene.spheres.windows(2) {
            // The places are rounded to a thousandth.
            assert!(distance(&pair[0], &pair[1]) < APART * pair[0].radius + 2e-3);
        }
    }

    #[test]
    fn shuffled_beads_are_the_same_beads_in_another_order() {
        let [one, other] = [Order::Spiral, Order::Shuffled].map(|order| read(256, order).0);
        assert!(one.spheres.iter().all(|bead| other.spheres.contains(bead)));
        assert_eq!(one.spheres.len(), other.spheres.len());
        let stay = one.spheres.iter().zip(&other.spheres);
        assert!(stay.filter(|(one, other)| one == other).count() < 8);
    }

    #[test]
    fn every_other_bead_is_a_mirror() {
        for count in COUNTS {
            let (scene, _) = read(count, Order::Spiral);
            let is_mirror = |bead: &&Sphere| scene.materials[bead.material].mirror > 0.0;
            let mirrors = scene.spheres.iter().filter(is_mirror).count();
            assert_eq!(mirrors, count.div_ceil(2));
        }
    }
}
