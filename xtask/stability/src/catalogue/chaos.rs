//! Cases of chaotic geometry: errors grow with every bounce.

use reflet::host::path::follow;
use reflet::host::reference::Vector;
use twofloat::TwoFloat;

use super::draft::Draft;
use super::exact::{Ball, Bounce, apart, bounces, growth};
use super::scene::Scene;
use super::{Bar, Case, Measured, drawn, measured, reflected};

const EPSILON: f64 = 1e-3;
const UP: [f64; 3] = [0.0, 0.0, 1.0];

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
        // Four of these corners are behind the spheres of a tetrahedron, the other four in front of
        // its gaps.
        let at = [0, 1, 2].map(|bit| 2.15 * (2.0 * of(bit) - 1.0));
        draft
            .material(&name, color, [1.0, 0.0, 0.0, 1.0, 0.0])
            .sphere(at, 0.35, &name)
    })
}

fn chaotic(name: &str, draft: Draft) -> Case {
    let why = "every bounce off a sphere multiplies an error, so that single pixels are nobody's; what \
               must agree is the picture as a whole";
    drawn(name, why, draft, (60, Bar::Statistics))
}

/// Growth of errors along rays that bounce between spheres, measured and in theory.
struct Growth {
    /// Quotient log(error / first error) / log(growth by theory), over all bounces of all rays.
    /// `single` and `double` are the same quotient in these precisions.
    fixed: f64,
    single: f64,
    double: f64,
    /// Geometric mean of the theory's growth for one bounce.
    a_bounce: f64,
    rays: usize,
    /// Number of rays that end before or after the true one although their error is small: in fixed
    /// point, single and double precision.
    lost: [usize; 3],
}

const SIDE: u32 = 24;
const MOST: usize = 9;

/// Largest error, in scene units, at which a ray still counts as known.
const KNOWN: f64 = 1e-2;

/// Follows the rays of a small picture in four precisions: fixed point, single, double and
/// quadruple.
fn grown(set: &[Ball], eye: [f64; 3], target: [f64; 3]) -> Growth {
    let draft = balls(Draft::through(eye, target, UP, 60.0), set).epsilon(EPSILON);
    let scene = Scene::read(&draft.text()).expect("the scene is accepted");
    let mut sums = [[0.0_f64; 2]; 3];
    let (mut theory, mut steps, mut rays, mut lost) = (0.0, 0, 0, [0; 3]);
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let core = follow(
            &*scene.built,
            &scene.camera,
            (SIDE, SIDE),
            (x, y),
            MOST as u32,
        );
        // All precisions start with the direction of fixed point, so that only the bounces differ.
        let way = core[0].direction;
        let truth = bounces::<TwoFloat>(set, core[0].origin, way, EPSILON, MOST);
        if truth.len() < 4 {
            continue;
        }
        let origins: Vec<_> = core[1..].iter().map(|ray| ray.origin).collect();
        let plain = |found: Vec<Bounce>| found.iter().map(|it| it.origin).collect::<Vec<_>>();
        let others = [
            origins,
            plain(bounces::<f32>(set, core[0].origin, way, EPSILON, MOST)),
            plain(bounces::<f64>(set, core[0].origin, way, EPSILON, MOST)),
        ];
        let factors = growth(&truth);
        rays += 1;
        for (precision, found) in others.iter().enumerate() {
            let sum = &mut sums[precision];
            let pairs = found.iter().zip(&truth);
            let errors = Vec::from_iter(pairs.map(|(a, b)| apart(*a, b.origin)));
            let is_known = errors.iter().all(|error| *error <= KNOWN);
            lost[precision] += usize::from(is_known && found.len() != truth.len());
            for (bounce, error) in errors.iter().enumerate().skip(1) {
                // A larger error is as large as the spheres, and grows no more.
                if *error > KNOWN || errors[bounce - 1] == 0.0 || *error == 0.0 {
                    break;
                }
                let flight = (factors[bounce] / factors[bounce - 1]).ln();
                sum[0] += (error / errors[bounce - 1]).ln();
                sum[1] += flight;
            }
        }
        theory += factors.last().expect("bounces").ln();
        steps += truth.len() - 1;
    }
    let [fixed, single, double] = sums.map(|[found, expected]| found / expected);
    Growth {
        fixed,
        single,
        double,
        a_bounce: (theory / steps as f64).exp(),
        rays,
        lost,
    }
}

fn judged(growth: &Growth) -> Measured {
    assert!(growth.rays >= 10, "{} rays are too few", growth.rays);
    let [fixed, single, double] = growth.lost;
    Measured {
        reference: "quadruple, theory",
        unit: "exponent off by",
        fixed: (growth.fixed - 1.0).abs(),
        single: (growth.single - 1.0).abs(),
        bar: BAR,
        uncertain: (growth.double - 1.0).abs(),
        note: format!(
            "Over {} rays theory says that a bounce makes an error {:.1} times as large. Found are \
             that to the power of {:.3} in fixed point, {:.3} in single and {:.3} in double precision; \
             how far that of double precision is off is no precision's fault, and counts as equal. \
             Paths that end elsewhere, although they are known: {fixed}, {single} and {double}",
            growth.rays, growth.a_bounce, growth.fixed, growth.single, growth.double
        ),
    }
}

/// Largest error of the exponent of growth. It is not 0, because new rounding errors join those that
/// have grown, and because the theory follows the plane of incidence only, where errors grow most.
const BAR: f64 = 0.2;

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

/// Measures the largest angle by which a ray is not parallel to itself after three bounces in a
/// corner cube.
fn returned() -> Measured {
    let scene = Scene::read(&corner(1.0).text()).expect("the scene is accepted");
    let (mut fixed, mut single, mut rays) = (0.0_f64, 0.0_f64, 0);
    for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
        let path = follow(&*scene.built, &scene.camera, (64, 64), (x, y), 3);
        let [first, _, _, last] = &path[..] else {
            continue;
        };
        rays += 1;
        fixed = fixed.max(apart(first.direction.map(|it| -it), last.direction));
        // Three reflections by d - 2 (d · n) n in single precision.
        let start = first.direction.map(|it| it as f32);
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
        uncertain: 0.0,
        note: format!("Over {rays} of {} rays", 64 * 64),
    }
}

fn inside(draft: Draft) -> Draft {
    draft
        .material("wall", [0.9, 0.6, 0.5], [0.2, 0.6, 0.3, 10.0, 0.9])
        .light([0.0, 0.0, 0.5])
        .sphere([0.3, 0.6, -0.3], 0.2, "chalk")
}

/// Returns the cases of the chapter "Chaotic geometry".
pub fn cases() -> Vec<Case> {
    let three_seen = hall(Draft::through(EYE_OF_THREE, [0.0; 3], UP, 60.0), &three());
    let four_seen = hall(Draft::through(EYE_OF_FOUR, AIM_OF_FOUR, UP, 60.0), &four());
    let sphere = inside(Draft::through([0.2, -0.5, 0.1], [0.0, 1.0, 0.2], UP, 80.0));
    let tube = inside(Draft::through([0.1, -1.5, 0.1], [0.0, 2.0, 0.0], UP, 80.0));
    let growing = "the growth a bounce is what makes pixels chaotic: it must be the theory's, so that \
                   an error starts as a last bit and nothing but geometry makes it large";
    let round = "between round walls an error grows with the number of bounces, not exponentially, so \
                 that every pixel counts";
    let cube = "three mirrors at right angles send every ray back parallel";
    let sphere = sphere.sphere([0.0; 3], 1.0, "wall");
    let tube = tube.cylinder([0.0; 3], [0.0, 1.0, 0.0], (1.0, 6.0), "wall");
    vec![
        measured("growth between three touching spheres", growing, || {
            judged(&grown(&three(), EYE_OF_THREE, [0.0; 3]))
        })
        .unlike_single_precision(
            "Exponents are compared with a theory that follows the plane of incidence alone, and from \
             errors of a last bit: what they differ by is theory's and the rays' choice, not growth.",
        ),
        measured("growth between four touching spheres", growing, || {
            judged(&grown(&four(), EYE_OF_FOUR, AIM_OF_FOUR))
        }),
        chaotic("between three touching spheres, N = 60", three_seen).unlike_single_precision(
            "Which lamp a chaotic path ends at is a draw, and so is the mean colour of all of them: that of \
             single precision happens to be nearer to the reference's, whose own is about as far away \
             with its eye moved.",
        ),
        chaotic("between four touching spheres, N = 60", four_seen),
        reflected("inside of a mirrored sphere", round, sphere, 8),
        reflected("inside of a mirror cylinder", round, tube, 8),
        measured("corner cube returns rays", cube, returned),
        reflected(
            "corner cube",
            "what is seen in a corner cube is the eye, and edges where three mirrors meet",
            corner(0.8).sphere(turned([0.4, 0.5, 0.3]), 0.2, "chalk"),
            6,
        ),
    ]
}
