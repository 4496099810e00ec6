//! Chaotic geometry: errors that grow with every bounce.

use reflet::host::file::SceneFile;
use reflet::host::path::follow;
use reflet::host::reference::Vector;
use twofloat::TwoFloat;

use super::draft::Draft;
use super::exact::{Ball, Bounce, apart, bounces, growth};
use super::{Case, Measured, Picture, Trial, measured, reflected};

const EPSILON: f64 = 1e-3;
const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// Three spheres of radius 1 that touch each other, around the origin.
fn three() -> Vec<Ball> {
    let far = 2.0 / 3f64.sqrt();
    let around = |turn: f64| {
        let angle = turn * std::f64::consts::TAU / 3.0;
        ([far * angle.cos(), 0.0, far * angle.sin()], 1.0)
    };
    [0.0, 1.0, 2.0].map(around).to_vec()
}

/// Four that touch each other.
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

/// The same in a mirrored hall, from which no ray escapes, with lamps of eight colours in its corners:
/// what a pixel shows is the lamp that its path ends at.
fn hall(draft: Draft, set: &[Ball]) -> Draft {
    let draft = balls(draft, set).sphere([0.0; 3], 4.2, "mirror");
    (0..8).fold(draft, |draft, bits| {
        let (of, name) = (|bit| f64::from(bits >> bit & 1), bits.to_string());
        let color = [0, 1, 2].map(|bit| 0.1 + 0.8 * of(bit));
        // Four of these corners are behind the spheres of a tetrahedron, and four are before its gaps.
        let at = [0, 1, 2].map(|bit| 2.15 * (2.0 * of(bit) - 1.0));
        draft
            .material(&name, color, [1.0, 0.0, 0.0, 1.0, 0.0])
            .sphere(at, 0.35, &name)
    })
}

fn chaotic(name: &str, draft: Draft) -> Case {
    let why = "every bounce off a sphere multiplies an error, so that single pixels are nobody's; what \
               must agree is the picture as a whole";
    let picture = Picture {
        draft,
        reflections: 60,
        bar: 0.0,
        is_chaotic: true,
    };
    Case::new(name, why, Trial::Picture(picture))
}

/// Errors after each bounce of rays that are caught between spheres, and what theory says of them.
struct Growth {
    /// log(error / first error) over log(growth by theory), all bounces of all rays together.
    fixed: f64,
    single: f64,
    double: f64,
    /// Of the growth by theory a bounce, the geometric mean.
    a_bounce: f64,
    rays: usize,
    /// Rays whose paths are known, and yet end before or after the true one, by precision.
    lost: [usize; 3],
}

const SIDE: u32 = 24;
const MOST: usize = 9;

/// Up to this error a ray is still known.
const KNOWN: f64 = 1e-2;

/// Follows the rays of a small picture in four precisions: fixed, single, double and quadruple.
fn grown(set: &[Ball], eye: [f64; 3], target: [f64; 3]) -> Growth {
    let draft = balls(Draft::through(eye, target, UP, 60.0), set).epsilon(EPSILON);
    let file = SceneFile::parse(&draft.text(), None).expect("the scene is well formed");
    let built = file.build().expect("the scene is accepted");
    let (_, camera) = file.runtime().expect("the camera is accepted");
    let mut sums = [[0.0_f64; 2]; 3];
    let (mut theory, mut steps, mut rays, mut lost) = (0.0, 0, 0, [0; 3]);
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        let core = follow(&*built, &camera, (SIDE, SIDE), (x, y), MOST as u32);
        // All start with the direction that fixed point has, so that only bounces differ.
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
                // Past this an error is as large as the spheres, and grows no more.
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

/// How far the exponent of growth may be off: new rounding errors join those that have grown, and
/// theory follows the plane of incidence alone, where errors grow most.
const BAR: f64 = 0.2;

/// Where the gaps between the spheres are seen from.
const EYE_OF_THREE: [f64; 3] = [0.03, -1.3, 0.02];
const EYE_OF_FOUR: [f64; 3] = [0.03, 0.05, 0.02];
const AIM_OF_FOUR: [f64; 3] = [1.0, 0.7, -1.0];

/// Three directions at right angles, none of them along an axis.
const TURNED: [[f64; 3]; 3] = [
    [2.0 / 3.0, -1.0 / 3.0, 2.0 / 3.0],
    [2.0 / 3.0, 2.0 / 3.0, -1.0 / 3.0],
    [-1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0],
];

/// A place by its coordinates along [`TURNED`].
fn turned(at: [f64; 3]) -> [f64; 3] {
    let [x, y, z] = TURNED.map(Vector);
    (x * at[0] + y * at[1] + z * at[2]).0
}

/// Three mirrors at right angles.
fn corner(alpha: f64) -> Draft {
    let (eye, up) = (turned([1.0, 1.2, 0.9]), turned(UP));
    let draft = Draft::through(eye, [0.0; 3], up, 60.0)
        .material("wall", [0.9, 0.6, 0.5], [0.2, 0.6, 0.3, 10.0, alpha])
        .light(turned([2.0, 2.0, 2.0]));
    TURNED
        .into_iter()
        .fold(draft, |draft, axis| draft.plane([0.0; 3], axis, "wall"))
}

/// Three bounces send a ray back the way it came: the largest angle by which it is not.
fn returned() -> Measured {
    let file = SceneFile::parse(&corner(1.0).text(), None).expect("the scene is well formed");
    let built = file.build().expect("the scene is accepted");
    let (_, camera) = file.runtime().expect("the camera is accepted");
    let (mut fixed, mut single, mut rays) = (0.0_f64, 0.0_f64, 0);
    for (x, y) in (0..64).flat_map(|y| (0..64).map(move |x| (x, y))) {
        let path = follow(&*built, &camera, (64, 64), (x, y), 3);
        let [first, _, _, last] = &path[..] else {
            continue;
        };
        rays += 1;
        fixed = fixed.max(apart(first.direction.map(|it| -it), last.direction));
        // Mirrored three times by d - 2 (d · n) n in single precision.
        let start = first.direction.map(|it| it as f32);
        let end = TURNED.into_iter().fold(start, |way, normal| {
            let normal = normal.map(|it| it as f32);
            let cosine = way[0] * normal[0] + way[1] * normal[1] + way[2] * normal[2];
            [0, 1, 2].map(|axis| way[axis] - 2.0 * cosine * normal[axis])
        });
        single = single.max(apart(start.map(|it| -f64::from(it)), end.map(f64::from)));
    }
    // Those beside an edge, whose start epsilon lifts over the next mirror, do not meet all three.
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

/// The cases of the chapter.
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
