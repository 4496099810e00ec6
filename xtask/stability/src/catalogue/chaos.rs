//! Cases of chaotic geometry: errors grow with every bounce.

use embedded_graphics::geometry::Size;
use reflet::host::path::paths_of_row;
use reflet::host::reference::Vector;
use reflet::quality::Exact;

use super::draft::{Draft, UP};
use super::scene::Scene;
use super::{Bar, Case, Measured, Trial, picture};

/// A sphere: its centre and its radius.
type Ball = ([f64; 3], f64);

/// Returns three spheres of radius 1 around the origin that touch each other.
fn three() -> Vec<Ball> {
    let far = 2.0 / 3f64.sqrt();
    let around = |turn: f64| {
        let angle = turn * std::f64::consts::TAU / 3.0;
        ([far * angle.cos(), 0.0, far * angle.sin()], 1.0)
    };
    [0.0, 1.0, 2.0].map(around).to_vec()
}

/// Returns four spheres of radius √2 around the origin that touch each other.
fn four() -> Vec<Ball> {
    let corners = [
        [1.0, 1.0, 1.0],
        [1.0, -1.0, -1.0],
        [-1.0, 1.0, -1.0],
        [-1.0, -1.0, 1.0],
    ];
    corners.map(|corner| (corner, 2f64.sqrt())).to_vec()
}

fn balls(draft: Draft, balls: &[Ball]) -> Draft {
    balls.iter().fold(draft, |draft, &(center, radius)| {
        draft.sphere(center, radius, "mirror")
    })
}

/// Adds the spheres and a mirroring hall around them, which no ray can leave. Lamps of eight colours
/// are in its corners: a pixel shows the lamp that its path ends at.
fn hall(draft: Draft, set: &[Ball]) -> Draft {
    let draft = balls(draft, set).sphere([0.0; 3], 4.2, "mirror");
    (0..8).fold(draft, |draft, bits| {
        let (of, name) = (|bit| f64::from(bits >> bit & 1), bits.to_string());
        let color = [0, 1, 2].map(|bit| 0.1 + 0.8 * of(bit));
        // Four of these corners are behind the spheres of a tetrahedron, the other four in front of its gaps.
        let at = [0, 1, 2].map(|bit| 2.15 * (2.0 * of(bit) - 1.0));
        draft
            .material(&name, color, [1.0, 0.0, 0.0, 1.0, 0.0])
            .sphere(at, 0.35, &name)
    })
}

fn chaotic(name: &str, draft: Draft) -> Case {
    let why = "every bounce off a sphere multiplies an error, so that single pixels are nobody's; what \
               must agree is the picture as a whole";
    let trial = Trial::Picture(draft.reflections(60), Bar::Statistics);
    Case::new(name, why, trial)
}

/// Camera position in front of the gap between three spheres. `EYE_OF_FOUR` and `AIM_OF_FOUR` are
/// the position and target between four.
const EYE_OF_THREE: [f64; 3] = [0.03, -1.3, 0.02];
const EYE_OF_FOUR: [f64; 3] = [0.03, 0.05, 0.02];
const AIM_OF_FOUR: [f64; 3] = [1.0, 0.7, -1.0];

/// Three directions at right angles to each other, none along an axis.
const TURNED: [[f64; 3]; 3] = [
    [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0],
    [2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0],
    [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0],
];

/// Returns the point with these coordinates along [`TURNED`].
fn turned(at: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = TURNED.map(Vector);
    (x * at[0] + y * at[1] + z * at[2]).0
}

/// Returns a scene of three mirrors at right angles: a corner cube.
fn corner(alpha: f64) -> Draft {
    let (eye, up) = (turned([1.0, 1.2, 0.9]), turned(UP));
    let draft = Draft::through(eye, [0.0; 3], up, 60.0)
        .material("wall", [0.9, 0.6, 0.5], [0.2, 0.6, 0.3, 10.0, alpha])
        .light(turned([2.0, 2.0, 2.0]));
    TURNED
        .into_iter()
        .fold(draft, |draft, axis| draft.plane([0.0; 3], axis, "wall"))
}

/// Returns the distance between two points.
fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    (Vector(a) - Vector(b)).length()
}

/// Measures the largest angle by which a ray is not parallel to itself after three bounces in a corner cube.
fn returned() -> Measured {
    let scene = Scene::read(&corner(1.0)).expect("the scene is accepted");
    let (built, camera) = (scene.source.scene(), scene.source.camera());
    let frame = built.frame(&camera).quality::<Exact>().reflections(3);
    let frame = frame.prepare(Size::new(64, 64));
    let rows = frame.on(built).expect("the scene of the frame");
    let (mut fixed, mut single, mut rays) = (0.0_f64, 0.0_f64, 0);
    for path in (0..64).flat_map(|y| paths_of_row(&rows, y)) {
        let [first, _, _, last] = path.rays[..] else {
            continue;
        };
        rays += 1;
        fixed = fixed.max(apart(first.map(|it| -it), last));
        // Three reflections by d - 2 (d · n) n in single precision.
        let start = first.map(|it| it as f32);
        let end = TURNED.into_iter().fold(start, |way, normal| {
            let normal = normal.map(|it| it as f32);
            let cosine = way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2];
            [0, 1, 2].map(|axis| way[axis] - 2.0 * cosine * normal[axis])
        });
        single = single.max(apart(start.map(|it| -f64::from(it)), end.map(f64::from)));
    }
    // Rays close to an edge miss a mirror: epsilon lifts their start over it.
    assert!(rays > 64 * 64 * 9 / 10, "{rays} rays met three mirrors");
    Measured {
        reference: "closed form",
        unit: "radians",
        fixed,
        single,
        bar: 2f64.powi(-24),
        note: format!("Over {rays} of {} rays", 64 * 64),
    }
}

fn inside(draft: Draft) -> Draft {
    draft
        .material("wall", [0.9, 0.6, 0.5], [0.2, 0.6, 0.3, 10.0, 0.9])
        .light([0.0, 0.0, 0.5])
        .sphere([0.3, 0.6, -0.3], 0.2, "chalk")
        .reflections(8)
}

pub fn cases() -> Vec<Case> {
    let three_seen = hall(Draft::through(EYE_OF_THREE, [0.0; 3], UP, 60.0), &three());
    let four_seen = hall(Draft::through(EYE_OF_FOUR, AIM_OF_FOUR, UP, 60.0), &four());
    let sphere = inside(Draft::through([0.2, -0.5, 0.1], [0.0, 1.0, 0.2], UP, 80.0));
    let tube = inside(Draft::through([0.1, -1.5, 0.1], [0.0, 2.0, 0.0], UP, 80.0));
    let round = "between round walls an error grows with the number of bounces, not exponentially, so \
                 that every pixel counts";
    let cube = "three mirrors at right angles send every ray back parallel";
    let sphere = sphere.sphere([0.0; 3], 1.0, "wall");
    let tube = tube.cylinder([0.0; 3], [0.0, 1.0, 0.0], (1.0, 6.0), "wall");
    vec![
        chaotic("between three touching spheres, N = 60", three_seen).unlike_single_precision(
            "Which lamp a chaotic path ends at is a draw, and so is the mean colour of all of them: that of \
             single precision happens to be nearer to the reference's, whose own is about as far away \
             with its eye moved.",
        ),
        chaotic("between four touching spheres, N = 60", four_seen),
        picture("inside of a mirrored sphere", round, sphere),
        picture("inside of a mirror cylinder", round, tube),
        Case::new("corner cube returns rays", cube, Trial::Measured(returned)),
        picture(
            "corner cube",
            "what is seen in a corner cube is the eye, and edges where three mirrors meet",
            corner(0.8)
                .sphere(turned([0.4, 0.5, 0.3]), 0.2, "chalk")
                .reflections(6),
        ),
    ]
}
