//! Tests that the cost of a frame grows far slower than the number of its shapes. Instructions are
//! counted, not timed, so the same code always gives the same figures.
//!
//! Beads hang over a mirroring floor along a spiral that faces the camera, with one light. The more
//! beads there are, the smaller they are, so that they always fill the same share of the picture. A net of
//! triangles hangs there, too, with the same outline for any number of them.

use std::f64::consts::PI;

use serde_json::{Value, json};
use xtask::measure::{Core, Figures, Quality, Scene, Size, Task, count};

const FEW: usize = 16;
const MANY: usize = 256;

/// Radius of a single bead. n beads with this radius divided by √n fill the same area.
const RADIUS: f64 = 6.0;

/// Distance between the centres of beads, in radii, along the spiral and from turn to turn.
const APART: f64 = 2.25;

/// Name, colour, specular coefficient and mirror share: four materials of the beads, in turns, and
/// that of the floor.
const MATERIALS: [(&str, [f64; 3], f64, f64); 5] = [
    ("silver", [0.8, 0.8, 0.8], 0.6, 0.7),
    ("ruby", [0.8, 0.2, 0.2], 0.3, 0.0),
    ("gold", [0.8, 0.6, 0.2], 0.6, 0.5),
    ("jade", [0.2, 0.6, 0.3], 0.3, 0.0),
    ("floor", [0.5, 0.5, 0.6], 0.0, 0.3),
];

#[derive(Clone, Copy)]
enum Mirrors {
    EveryOther,
    All,
}

/// Order in which a scene lists its beads: neighbours after each other, or at random.
#[derive(Clone, Copy)]
enum Order {
    Spiral,
    Shuffled,
}

/// Returns the beads from the centre outwards. If all are mirrors, silver and gold take turns.
///
/// A spiral has turns one step apart if n steps along it end √(n / π) steps from its centre, at an
/// angle of √(4 π n).
fn beads(count: usize, mirrors: Mirrors) -> Vec<Value> {
    let step = match mirrors {
        Mirrors::EveryOther => 1,
        Mirrors::All => 2,
    };
    let radius = RADIUS / (count as f64).sqrt();
    let place = |index: usize| {
        // The first turns are too narrow for more than one bead.
        let steps = if index == 0 { 0.0 } else { index as f64 + 1.75 };
        let away = APART * radius * (steps / PI).sqrt();
        let angle = (4.0 * PI * steps).sqrt();
        [away * angle.cos(), away * angle.sin()]
    };
    let places: Vec<_> = (0..count).map(place).collect();
    let middle = [0, 1].map(|axis| {
        let all = places.iter().map(|place| place[axis]);
        (all.clone().fold(f64::INFINITY, f64::min) + all.fold(f64::NEG_INFINITY, f64::max)) / 2.0
    });
    // Rounded, so that the scene does not depend on the last digit of a machine's cosine.
    let short = |value: f64| (value * 1000.0).round() / 1000.0;
    let bead = |(index, place): (usize, &[f64; 2])| {
        let [aside, above] = [0, 1].map(|axis| place[axis] - middle[axis]);
        json!({
            "center": [short(aside), short(0.6 * above), short(8.0 + 0.8 * above)],
            "radius": short(radius),
            "material": MATERIALS[index * step % 4].0,
        })
    };
    places.iter().enumerate().map(bead).collect()
}

/// Returns the text of the scene file with this many beads.
fn scene(count: usize, mirrors: Mirrors, order: Order) -> String {
    let mut spheres = beads(count, mirrors);
    if let Order::Shuffled = order {
        // Fisher and Yates, with pseudo-random numbers by Marsaglia ("Xorshift RNGs", 2003).
        let mut state = 0x9e37_79b9_7f4a_7c15_u64;
        for last in (1..spheres.len()).rev() {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            spheres.swap(last, (state % (last as u64 + 1)) as usize);
        }
    }
    scene_of("spheres", &spheres)
}

/// Returns the text of a scene file: a net of `columns` by `rows` cells, each of two triangles, over the floor. The net
/// bulges towards the camera, except at its border.
fn net([columns, rows]: [u32; 2]) -> String {
    let at = |column: u32, row: u32| {
        let [x, z] = [(column, columns), (row, rows)].map(|(at, of)| f64::from(at) / f64::from(of));
        let bulge = 2.0 * (PI * x).sin() * (PI * z).sin();
        [16.0 * x - 8.0, -bulge, 2.0 + 12.0 * z]
    };
    let cells = (0..columns).flat_map(|x| (0..rows).map(move |z| (x, z)));
    let triangles = cells.flat_map(|(x, z)| {
        let [a, b, c, d] = [(0, 0), (1, 0), (1, 1), (0, 1)].map(|(by, up)| at(x + by, z + up));
        let material = MATERIALS[(x + z) as usize % 4].0;
        [[a, b, c], [a, c, d]].map(|corners| json!({"corners": corners, "material": material}))
    });
    scene_of("triangles", &triangles.collect::<Vec<_>>())
}

/// Returns the text of a scene file: these shapes over the floor.
fn scene_of(list: &str, shapes: &[Value]) -> String {
    let materials = MATERIALS.map(|(name, color, specular, mirror)| {
        json!({
            "name": name, "color": color, "ambient": 0.2, "diffuse": 0.6,
            "specular": specular, "shininess": 16.0, "mirror": mirror,
        })
    });
    let scene = json!({
        "name": list,
        "camera": {"position": [0, -24, 26], "target": [0, 0, 8], "up": [0, 0, 1], "fov": 35},
        "materials": materials,
        "lights": [{"position": [-18, -16, 30], "color": [1, 1, 1]}],
        list: shapes,
        "planes": [{"center": [0, 0, 0], "normal": [0, 0, 1], "material": "floor"}],
        "background": [0.4, 0.5, 0.7],
    });
    scene.to_string()
}

fn measured(spheres: usize, mirrors: Mirrors, order: Order) -> Figures {
    measured_text(&scene(spheres, mirrors, order))
}

fn measured_text(text: &str) -> Figures {
    let scene = Scene::parse(text).expect("the scene is well formed");
    let task = Task::new(Core::M3, scene, Size::new(64, 64), Quality::FAST);
    count(&task).unwrap_or_else(|error| panic!("{error:#}"))
}

/// Checks that [`MANY`] beads cost less than `bar` times what [`FEW`] cost. A kernel that tests every
/// sphere costs [`MANY`] / [`FEW`] times as much.
fn assert_grows_less(bar: f64, mirrors: Mirrors, order: Order) {
    let figures = [FEW, MANY].map(|spheres| measured(spheres, mirrors, order));
    assert_cost_less(bar, figures);
}

fn assert_cost_less(bar: f64, [few, many]: [Figures; 2]) {
    let times = many.instructions_per_pixel / few.instructions_per_pixel;
    println!("{times:.2} times");
    assert!(times < bar, "{times:.2} times\n{few:?}\n{many:?}");
}

#[test]
#[ignore = "long: two more firmware of many beads"]
fn sixteen_times_the_spheres_cost_less_than_six_times_as_much() {
    assert_grows_less(6.0, Mirrors::EveryOther, Order::Spiral);
}

#[test]
fn sixteen_times_the_mirrors_cost_at_most_three_and_a_half_times_as_much() {
    assert_grows_less(3.5, Mirrors::All, Order::Spiral);
}

fn assert_order_does_not_change_the_picture(mirrors: Mirrors) {
    let hash = |order| measured(MANY, mirrors, order).hash;
    assert_eq!(hash(Order::Spiral), hash(Order::Shuffled));
}

#[test]
#[ignore = "long: four more firmware of many beads"]
fn order_of_the_beads_does_not_change_the_picture() {
    assert_order_does_not_change_the_picture(Mirrors::All);
    assert_order_does_not_change_the_picture(Mirrors::EveryOther);
    assert_grows_less(3.5, Mirrors::All, Order::Shuffled);
}

#[test]
#[ignore = "long: two more firmware of many triangles"]
fn ten_times_the_triangles_cost_less_than_four_times_as_much() {
    let figures = [[5, 2], [10, 10]].map(|cells| measured_text(&net(cells)));
    assert_cost_less(4.0, figures);
}
