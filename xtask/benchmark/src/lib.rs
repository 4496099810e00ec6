//! Scenes that differ only in the number and size of their spheres, so that their costs show what a
//! shape costs.
//!
//! Beads hang over a mirroring floor along a spiral that faces the camera, with one light. The turns
//! of the spiral are as far apart as the beads along it. The more beads there are, the smaller they
//! are, so that they always fill the same share of the picture. Camera, floor and light never
//! change. Every other bead is a mirror, beginning with the first, or all of them are.
//!
//! Each scene is the text of a scene file, which the library and its reference both read.

use std::f64::consts::PI;

use serde_json::{Value, json};

/// Order in which a scene lists its spheres. The picture does not depend on it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// In their order along the spiral. Neighbours in the list are neighbours in space, as in a
    /// scene that a person writes.
    Spiral,
    /// In random order: the position in the list says nothing about the position in space.
    Shuffled,
}

/// Which of the beads are mirrors.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mirrors {
    /// Every other bead, beginning with the first.
    EveryOther,
    /// All beads.
    All,
}

/// Radius of a single bead. n beads with this radius divided by √n fill the same area.
const RADIUS: f64 = 6.0;

/// Centre of the spiral, above the middle of the floor.
const MIDDLE: [f64; 3] = [0.0, 0.0, 8.0];

/// Second direction of the spiral's plane. The first is the x axis.
const UP: [f64; 3] = [0.0, 0.6, 0.8];

/// Position of the camera: in front of the spiral's centre, at right angles to its plane.
const CAMERA: [f64; 3] = [0.0, -24.0, 26.0];

/// Field of view in degrees: the spiral just fits into the picture.
const FOV: f64 = 35.0;

/// Distance between the centres of beads, in radii, along the spiral and from turn to turn.
const APART: f64 = 2.25;

/// Number of beads that the spiral leaves free at its start. The turns there are too narrow for
/// beads, so only the first bead is at the centre.
const SKIPPED: f64 = 1.75;

/// Name, colour, specular coefficient and mirror share: four materials of the beads, in turns, and
/// that of the floor.
const MATERIALS: [(&str, [f64; 3], f64, f64); 5] = [
    ("silver", [0.8, 0.8, 0.8], 0.6, 0.7),
    ("ruby", [0.8, 0.2, 0.2], 0.3, 0.0),
    ("gold", [0.8, 0.6, 0.2], 0.6, 0.5),
    ("jade", [0.2, 0.6, 0.3], 0.3, 0.0),
    ("floor", [0.5, 0.5, 0.6], 0.0, 0.3),
];

/// Returns the text of the scene file with this many spheres.
///
/// ```
/// use reflet::host::file::SceneFile;
/// use benchmark::{Mirrors, Order, scene};
///
/// let text = scene(100, Mirrors::EveryOther, Order::Spiral);
/// let file = SceneFile::parse(&text, None).unwrap();
/// assert_eq!(file.name(), Some("spiral_100"));
/// let (scene, _camera) = file.reference();
/// assert_eq!((scene.spheres.len(), scene.planes.len(), scene.lights.len()), (100, 1, 1));
/// assert!(file.build().is_ok());
/// ```
pub fn scene(count: usize, mirrors: Mirrors, order: Order) -> String {
    let mut spheres = beads(count, mirrors);
    let order = match order {
        Order::Spiral => "spiral",
        Order::Shuffled => {
            shuffle(&mut spheres);
            "shuffled"
        }
    };
    let name = match mirrors {
        Mirrors::EveryOther => format!("{order}_{count}"),
        Mirrors::All => format!("{order}_mirrors_{count}"),
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

/// Returns the beads as JSON, from the centre outwards. If all are mirrors, silver and gold take turns.
fn beads(count: usize, mirrors: Mirrors) -> Vec<Value> {
    let step = match mirrors {
        Mirrors::EveryOther => 1,
        Mirrors::All => 2,
    };
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
            "material": MATERIALS[index * step % 4].0,
        })
    };
    places.iter().enumerate().map(bead).collect()
}

/// Returns the position of a bead in the spiral's plane, if beads are a `step` apart.
///
/// A spiral has turns one step apart if n steps along it end √(n / π) steps from its centre, at an
/// angle of √(4 π n).
fn place(index: usize, step: f64) -> [f64; 2] {
    let steps = match index {
        0 => 0.0,
        _ => index as f64 + SKIPPED,
    };
    let (away, angle) = (step * (steps / PI).sqrt(), (4.0 * PI * steps).sqrt());
    [away * angle.cos(), away * angle.sin()]
}

/// Returns the middle between the smallest and the largest value.
fn middle(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let largest = values.fold(f64::NEG_INFINITY, f64::max);
    (least + largest) / 2.0
}

/// Rounds to three decimals, so that the scene does not depend on the last digit of a machine's
/// cosine.
fn short(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

/// Shuffles by Fisher and Yates, with the same pseudo-random numbers each time (Marsaglia, "Xorshift
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
        let text = scene(count, Mirrors::EveryOther, order);
        let file = SceneFile::parse(&text, None).unwrap();
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
                    // Distance of the bead's centre from the edge of the view.
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
            // Coordinates are rounded to a thousandth.
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
    fn every_other_bead_is_a_mirror_or_all_are() {
        for count in COUNTS {
            let mirrors = [Mirrors::EveryOther, Mirrors::All].map(|mirrors| {
                let text = scene(count, mirrors, Order::Spiral);
                let (scene, _) = SceneFile::parse(&text, None).unwrap().reference();
                let is_mirror = |bead: &&Sphere| scene.materials[bead.material].mirror > 0.0;
                scene.spheres.iter().filter(is_mirror).count()
            });
            assert_eq!(mirrors, [count.div_ceil(2), count]);
        }
    }
}
