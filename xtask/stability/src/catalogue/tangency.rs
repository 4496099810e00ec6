//! Cases of tangency and grazing: the last bit decides what a ray hits.

use super::draft::{Draft, EYE, LAMP, TARGET, UP, lit_by, still_life, usual};
use super::judge::Pictures;
use super::{Case, LAST_BIT, Trial, picture};

const TILTED: [f64; 3] = [0.1, 0.2, 1.0];

fn ahead() -> Draft {
    Draft::seen_from([0.0, -5.0, 0.0], [0.0; 3]).light(LAMP)
}

fn above() -> Draft {
    Draft::seen_from([0.0, -5.0, 1.0], [0.0; 3]).light(LAMP)
}

fn pipe(eye: [f64; 3], target: [f64; 3]) -> Draft {
    Draft::seen_from(eye, target)
        .light(LAMP)
        .sphere([0.0, 3.0, 0.0], 0.5, "chalk")
        .cylinder([0.0; 3], [0.0, 1.0, 0.0], (0.5, 2.0), "gold")
}

/// Returns a scene with two mirror discs that are seen edge-on but for a slope: one level with the
/// eye, one beside the view, between spheres.
fn edge_on(slope: f64) -> Draft {
    ahead()
        .sphere([0.0, 0.5, 0.6], 0.5, "gold")
        .sphere([0.3, 0.0, -0.7], 0.5, "chalk")
        .disc([0.0; 3], [0.0, slope, 1.0], 1.2, "mirror")
        .disc([-1.0, 0.0, 0.0], [5.0, -1.0 + slope, 0.0], 0.8, "mirror")
}

/// Returns triangles that are seen edge-on but for a slope: a mirror level with the eye, and one upright.
fn triangles_edge_on(slope: f64) -> Draft {
    ahead()
        .sphere([0.0, 0.5, 0.6], 0.5, "gold")
        .sphere([0.3, 0.0, -0.7], 0.5, "chalk")
        .triangle(
            [
                [-1.2, -0.8, 0.8 * slope],
                [1.2, -0.8, 0.8 * slope],
                [0.0, 1.2, -1.2 * slope],
            ],
            "mirror",
        )
        .triangle(
            [
                [-1.2, -1.0, -0.6],
                [-1.2, -1.0, 0.9],
                [-1.5 + slope, 1.5, 0.2],
            ],
            "red",
        )
}

/// Returns needles of 1 to 10^4: upright, leaning and along the view.
fn needles() -> Draft {
    ahead()
        .sphere([0.3, 0.6, -0.4], 0.5, "gold")
        .triangle(
            [[-0.8, 0.0, -1.5], [-0.8, 0.0, 1.5], [-0.7997, 0.0, 1.5]],
            "chalk",
        )
        .triangle(
            [[-0.5, 0.0, -1.0], [1.0, 0.0, 1.2], [1.0002, 0.0, 1.1998]],
            "red",
        )
        .triangle(
            [[0.9, -2.0, -0.5], [0.5, 4.0, -0.6], [0.5, 4.0, -0.5994]],
            "white",
        )
}

/// Returns a cylinder that is closed by discs at both ends, over a floor.
fn closed() -> Draft {
    Draft::seen_from([1.0, -5.0, 2.5], [0.0, 0.0, 0.5])
        .light(LAMP)
        .cylinder([0.0, 0.0, 0.75], UP, (0.8, 1.5), "red")
        .disc([0.0, 0.0, 1.5], UP, 0.8, "water")
        .disc([0.0; 3], UP, 0.8, "gold")
        .plane([0.0, 0.0, -0.5], UP, "chalk")
}

fn rays() -> Vec<Case> {
    let horizon =
        "rows of pixels beside the horizon meet the floor at any distance, up to for ever";
    let rim = "a rim's rays touch: the root of what is left of two equal squares";
    let edge = "the rate at which a ray nears the disc is a difference of two numbers beside one";
    let side = "which side of an edge a ray passes is a difference of two products, and its approach another";
    let thin =
        "two sides are almost one line, and their cross product a difference of equal products";
    let axis = "the square of the sine to the axis is a difference of two numbers beside one";
    let high = still_life([0.0, -4.0, 1.0], [0.0, 0.0, 1.0], 50.0);
    let low = still_life([0.0, -4.0, 1e-4], [0.0, 0.0, 1e-4], 50.0);
    let silhouette = still_life([-1.0, -5.0, 0.6], [-0.4, 0.0, 0.6], 1.0);
    let rims = Draft::through([1.0, -5.0, 0.0], [1.0, 0.0, 0.0], UP, 2.0)
        .light(LAMP)
        .sphere([0.0; 3], 1.0, "gold")
        .sphere([0.0, 0.1, 0.0], 1.0, "water");
    let along = pipe([0.0, -4.0, 0.0], [0.0; 3]);
    let parallel = pipe([0.2, -4.0, 0.1], [0.2, 0.0, 0.1]);
    let wall = pipe([0.5, -4.0, 0.0], [0.5, 0.0, 0.0]);
    vec![
        picture("horizon, an eye's height", horizon, high),
        picture("horizon, 10^-4 above the floor", horizon, low),
        picture("silhouette under a lens of 1°", rim, silhouette),
        picture("two rims in one line", rim, rims),
        picture(
            "eye in a plane",
            "a ray from a plane is not stopped by it, and a ray in it never meets it",
            still_life([0.0, -4.0, 0.0], TARGET, 50.0),
        ),
        picture(
            "eye and view in a plane",
            "the same, with a row of rays that stay in the plane",
            still_life([0.0, -4.0, 0.0], [0.0; 3], 50.0),
        ),
        picture(
            "eye where two planes meet",
            "the same for two planes at once",
            Draft::seen_from([0.0; 3], [1.0, 1.0, 0.5])
                .light([1.0, 1.0, 3.0])
                .plane([0.0; 3], UP, "water")
                .plane([0.0; 3], [0.0, 1.0, 0.0], "gold")
                .plane([0.0, 5.0, 0.0], [0.0, 1.0, 0.3], "chalk"),
        ),
        picture("mirror disc seen edge-on", edge, edge_on(0.0)),
        picture("mirror disc 0.1° from edge-on", edge, edge_on(1.0 / 573.0)),
        picture("mirror triangle seen edge-on", side, triangles_edge_on(0.0)),
        picture(
            "mirror triangle 0.1° from edge-on",
            side,
            triangles_edge_on(1.0 / 573.0),
        ),
        picture("triangles of 1 to 10^4", thin, needles()),
        picture("along a cylinder's axis", axis, along),
        picture("parallel to a cylinder's axis", axis, parallel),
        picture("along a cylinder's wall", axis, wall),
        picture(
            "view almost along up",
            "right is the cross product of two directions 10^-4 apart",
            still_life([0.0, -1e-4, 8.0], [0.0; 3], 50.0),
        ),
    ]
}

fn touching() -> Vec<Case> {
    let touch = "where shapes touch, a ray that leaves one stands on the other";
    let twice = "of two equal distances the first shape must win, everywhere";
    let spheres = ahead()
        .sphere([0.0; 3], 1.0, "chalk")
        .sphere([0.0; 3], 1.0, "black");
    let cylinders = above()
        .cylinder([0.0; 3], [0.2, 0.0, 1.0], (1.0, 2.0), "chalk")
        .cylinder([0.0; 3], [0.2, 0.0, 1.0], (1.0, 2.0), "gold");
    let planes = above()
        .sphere([0.0, 0.0, 0.5], 0.5, "gold")
        .plane([0.0; 3], UP, "chalk")
        .plane([5.0, 3.0, 0.0], [0.0, 0.0, -2.0], "black");
    let slopes = Draft::seen_from([0.0, -5.0, 2.0], [0.0; 3])
        .light(LAMP)
        .sphere([0.0, 0.0, 0.5], 0.5, "gold")
        .plane([0.0; 3], TILTED, "water")
        .plane([0.0; 3], TILTED, "black");
    let touching =
        ahead()
            .sphere([-1.0, 0.0, 0.0], 1.0, "gold")
            .sphere([1.0, 0.0, 0.0], 1.0, "water");
    let on_a_floor = above()
        .sphere([-1.0, 0.0, 1.0], 1.0, "gold")
        .sphere([1.0, 0.0, 0.5], 0.5, "water")
        .plane([0.0; 3], UP, "water");
    let nested = ahead()
        .sphere([0.0; 3], 1.0, "gold")
        .sphere([0.0, -0.5, 0.0], 0.5, "water")
        .sphere([0.0, 0.4, 0.0], 0.6, "chalk");
    vec![
        picture("touching spheres", touch, touching),
        picture("spheres on a floor", touch, on_a_floor),
        picture("nested spheres that touch", touch, nested),
        picture("cylinder closed by glossy discs", touch, closed()),
        picture(
            "disc that touches a sphere",
            touch,
            above()
                .sphere([0.0, 0.0, 0.5], 0.5, "gold")
                .disc([0.0; 3], UP, 1.5, "water"),
        ),
        picture(
            "nested spheres, from inside",
            "every ray starts inside of one shape and outside of the others",
            Draft::seen_from([0.0, -0.9, 0.0], [0.0; 3])
                .light([0.0, -0.8, 0.3])
                .sphere([0.0; 3], 1.0, "gold")
                .sphere([0.0; 3], 0.5, "water")
                .sphere([0.0; 3], 0.25, "chalk"),
        ),
        picture("one sphere twice", twice, spheres),
        picture("one cylinder twice", twice, cylinders),
        picture("one plane twice", twice, planes),
        picture("one tilted plane twice", twice, slopes).unlike_single_precision(LAST_BIT),
        picture(
            "planes 10^-4 apart in angle",
            "which is in front changes at a line that a last bit would move by a length",
            above()
                .sphere([0.0, 0.0, 0.5], 0.5, "gold")
                .plane([0.0; 3], UP, "chalk")
                .plane([0.0; 3], [1e-4, 0.0, 1.0], "black"),
        ),
    ]
}

/// Returns pairs of scenes: one with one shape, the other also with a second shape in the same
/// place, behind it in the list. Each pair has a name.
fn twins() -> [(&'static str, Draft, Draft); 5] {
    let ball = ahead().sphere([0.0; 3], 1.0, "chalk");
    let tube = |draft: Draft, name| draft.cylinder([0.0; 3], [0.2, 0.0, 1.0], (1.0, 2.0), name);
    let floor = above().sphere([0.0, 0.0, 0.5], 0.5, "gold");
    let flat = floor.clone().plane([0.0; 3], UP, "chalk");
    let slope = floor.plane([0.0; 3], TILTED, "water");
    let one = tube(above(), "chalk");
    let flats = flat.clone().plane([0.0; 3], [0.0, 0.0, -2.0], "black");
    let slopes = slope.clone().plane([0.0; 3], TILTED, "black");
    let plate = |draft: Draft, name| draft.disc([0.0; 3], TILTED, 1.0, name);
    let lid = plate(above(), "gold");
    [
        ("sphere", ball.clone(), ball.sphere([0.0; 3], 1.0, "black")),
        ("cylinder", one.clone(), tube(one, "gold")),
        ("disc", lid.clone(), plate(lid, "black")),
        ("plane", flat, flats),
        ("tilted plane", slope, slopes),
    ]
}

fn stable_winners() -> Result<String, String> {
    let pictures = twins().map(|(name, one, two)| {
        let pictures = |draft: Draft| Pictures::of(&draft, false);
        match pictures(one)?.differing(&pictures(two)?) {
            0 => Ok(name),
            differ => Err(format!("{name}: {differ} pixels show the second")),
        }
    });
    let names: Vec<_> = pictures.into_iter().collect::<Result<_, String>>()?;
    Ok(format!(
        "not a pixel of `Exact` differs from the picture with the first alone, and none of \
         `Fast` by more than one level: {}",
        names.join(", ")
    ))
}

fn lights() -> Vec<Case> {
    let on = "whether a light on a surface lights it is decided by epsilon alone";
    let within = "the way to the light begins or ends at a wall";
    let close = lit_by([1.0, -3.0, 1.0 / 1024.0]);
    vec![
        picture("light in a plane", on, lit_by([1.0, -3.0, 0.0])),
        picture("light 10^-4 above a plane", on, lit_by([1.0, -3.0, 1e-4])),
        picture("light epsilon above a plane", on, lit_by([1.0, -3.0, 1e-3]))
            .unlike_single_precision(LAST_BIT),
        picture("light 1/1024 above a plane", on, close),
        picture(
            "light 1/1024 above a lonely plane",
            "nothing but the light and the plane tells how large the scene is",
            usual()
                .light([0.0, 0.0, 1.0 / 1024.0])
                .plane([0.0; 3], UP, "chalk"),
        ),
        picture("light on a sphere", on, lit_by([-1.0, 0.0, 1.2])),
        picture("light on a cylinder", on, lit_by([0.6, 1.2, 0.7])),
        picture(
            "light at the camera",
            "no shadow is seen, and every facing cosine is the viewer's",
            lit_by(EYE),
        ),
        picture("light in a sphere", within, lit_by([-1.0, 0.0, 0.6])),
        picture("light in a cylinder", within, lit_by([0.2, 1.2, 0.7])),
    ]
}

fn eyes() -> Vec<Case> {
    let within = "every ray begins inside of a wall that may be met once only";
    let seen = |eye, target| still_life(eye, target, 90.0);
    let column = |draft: Draft| draft.cylinder([-1.6, -1.0, 0.6], UP, (0.5, 1.2), "red");
    // The eye is 10^-6 outside of the sphere, too little to be seen. On the sphere itself, the reference is not defined.
    let aside = 0.6 + 1e-6;
    let in_a_sphere = still_life([-1.0, 0.0, 0.6], TARGET, 50.0);
    let by_a_light = still_life([-1.2, 0.0, 0.6], TARGET, 100.0).light([-1.0, 0.1, 0.6]);
    let in_a_cylinder = still_life([0.2, 1.2, 0.7], TARGET, 100.0);
    vec![
        picture("eye in a sphere", within, in_a_sphere),
        picture("eye and light in a sphere", within, by_a_light),
        picture("eye in a cylinder", within, in_a_cylinder),
        picture(
            "eye on a sphere, outwards",
            "the sphere begins at the eye, and must not be seen from inside by rounding",
            seen([-1.0, -aside, 0.6], [0.5, -2.0, 0.5]),
        )
        .unlike_single_precision(LAST_BIT),
        picture(
            "eye on a sphere, inwards",
            "the same from inside: all that is seen is the other side",
            seen([-1.0, 1e-6 - 0.6, 0.6], [-1.0, 1.0, 0.5]),
        ),
        picture(
            "eye on a cylinder, outwards",
            "the cylinder begins at the eye, and must not be seen from inside by rounding",
            column(seen([-1.1 + 1e-6, -1.0, 0.6], [0.5, 0.0, 0.5])),
        ),
        picture(
            "eye on a cylinder, inwards",
            "the same from inside: all that is seen is the other side, and what its ends leave open",
            column(seen([-1.1 - 1e-6, -1.0, 0.6], [-3.0, -1.0, 0.5])),
        ),
    ]
}

pub fn cases() -> Vec<Case> {
    let mut cases = rays();
    cases.extend(touching());
    cases.push(Case::new(
        "the second in the same place",
        "of two equal distances the first shape must win, in every pixel",
        Trial::Claim(stable_winners),
    ));
    cases.extend(lights());
    cases.extend(eyes());
    cases
}
