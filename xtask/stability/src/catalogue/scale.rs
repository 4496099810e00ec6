//! Cases of scale: very large beside very small, very far, very thin, very narrow and very wide.

use command_line::Quality;
use embedded_graphics::geometry::Size;
use lost::case::differing;

use super::draft::{Draft, EYE, LAMP, Setting, TARGET, UP, lit_by, still_life, usual};
use super::judge::SIDE;
use super::scene::Scene;
use super::{Case, LAST_BIT, Measured, Trial, picture};

fn planet_of(material: &str, ratio: f64) -> Draft {
    Draft::seen_from([0.5, -6.0, 2.0], [0.0, 0.0, 0.8])
        .light([3.0, -5.0, 6.0])
        .sphere([0.0, 0.0, -ratio], ratio, material)
        .sphere([0.0, 0.0, 1.0], 1.0, "gold")
        .sphere([1.6, 0.0, 0.5], 0.5, "water")
}

fn whole_planet(ratio: f64) -> Draft {
    let eye = [0.0, -4.0 * ratio, ratio];
    Draft::through(eye, [0.0, 0.0, 1.0], UP, 200.0 / ratio)
        .light([3.0 * ratio, -5.0 * ratio, 6.0 * ratio])
        .sphere([0.0, 0.0, -ratio], ratio, "chalk")
        .sphere([0.0, 0.0, 1.0], 1.0, "gold")
}

/// Counts the pixels of the still life that differ when it is scaled by 2^-20 to 2^20.
fn scaled_by_powers() -> Measured {
    let drawn = |power: i32| {
        let mut setting = Setting::HERE;
        setting.scale = 2f64.powi(power);
        let scene = Scene::read(&setting.still_life()).expect("the scene is accepted");
        let size = Size::new_equal(SIDE);
        [scene.drawn(Quality::Exact, size), scene.single(size)]
    };
    let unscaled = drawn(0);
    let mut most = [0; 2];
    for power in (-20..=20).filter(|power| *power != 0) {
        let scaled = drawn(power);
        most = [0, 1].map(|it| most[it].max(differing(&scaled[it], &unscaled[it], 0)));
    }
    let [fixed, single] = most.map(|count| count as f64);
    Measured {
        reference: "itself, unscaled",
        unit: "pixels that differ",
        fixed,
        single,
        bar: 0.0,
        note: "40 pictures, by 2^-20 to 2^20".to_owned(),
    }
}

fn ratios() -> Vec<Case> {
    let mut cases = Vec::new();
    for power in 1..=6 {
        let ratio = 10f64.powi(power);
        let near = picture(
            format!("planet and pebble, 10^{power}"),
            "the planet's surface must be known to a part of the pebble, its discriminant to twice \
             the digits",
            planet_of("chalk", ratio),
        );
        cases.push(near);
        // A planet further away would need a field of view below 0.001 degrees.
        if power <= 5 {
            let afar = picture(
                format!("planet and pebble from afar, 10^{power}"),
                "a pebble's shadow, by a light so far that its tangents are hardly shorter than the \
                 way",
                whole_planet(ratio),
            );
            cases.push(match power {
                2 => afar.unlike_single_precision(LAST_BIT),
                _ => afar,
            });
        }
    }
    cases
}

fn places() -> Vec<Case> {
    let mut cases = Vec::new();
    for power in [1, 3, 5, 6, 7, 8, 9] {
        let far = 10f64.powi(power);
        let mut setting = Setting::HERE;
        setting.offset = [far, -0.7 * far, 0.3 * far];
        cases.push(picture(
            format!("moved by 10^{power}"),
            "what is left of a coordinate's digits once a large number has been added",
            setting.still_life(),
        ));
        cases.push(picture(
            format!("sun 10^{power} away"),
            "the light's direction is a quotient of large numbers, its shadows are small",
            lit_by([far, -far, far]),
        ));
    }
    for power in [1, 3, 5] {
        let far = 10f64.powi(power);
        let fov = (2.0 * (3.0 / far).atan()).to_degrees();
        cases.push(picture(
            format!("camera 10^{power} away"),
            "pixels lie 3 / distance apart in angle, and the scene in few of the ray's steps",
            still_life([0.3 * far, -far, 0.5 * far], TARGET, fov),
        ));
        let sphere = picture(
            format!("sphere 10^{power} away"),
            "what is far and wide takes bits from what is near",
            Setting::HERE
                .still_life()
                .sphere([0.9 * far, far, 0.2 * far], 0.05 * far, "gold"),
        );
        cases.push(match power {
            1 => sphere,
            _ => sphere.unlike_single_precision(
                "All places of a scene share one step, 2^-28 of its extent, while a float has smaller \
                 ones near zero, where the still life stands: moved by 10^5, it is f32 that is worse.",
            ),
        });
    }
    cases
}

fn thin() -> Vec<Case> {
    let floor = Draft::seen_from([0.0, -3.0, 0.6], [0.0; 3])
        .plane([0.0, 0.0, -0.5], UP, "water")
        .light(LAMP);
    let spread = |number: u32| {
        let angle = 2.4 * f64::from(number);
        let far = (f64::from(number) / 40.0).sqrt();
        let (x, y) = (far * angle.cos(), far * angle.sin());
        [x, y, 0.3 * (1.7 * angle).sin()]
    };
    let dots = (0..40).fold(floor.clone(), |draft, number| {
        draft.sphere(spread(number), 1e-3, "gold")
    });
    let wires = (0..12).fold(floor, |draft, number| {
        let axis = spread(3 * number + 1);
        draft.cylinder(spread(number), axis, (1e-3, 2.0), "gold")
    });
    let crumbs = Draft::seen_from([0.0, -0.01, 0.002], [0.0; 3])
        .light(LAMP)
        .sphere([0.0; 3], 1e-3, "gold")
        .sphere([2e-3, 5e-4, 0.0], 1e-3, "water")
        .sphere([1.0, 3.0, 0.0], 1.0, "chalk")
        .plane([0.0, 0.0, -1e-3], UP, "water")
        .epsilon(1e-6);
    let along = Draft::seen_from([-2500.0, -2.0, 1.5], [0.0; 3])
        .light([-2497.0, -5.0, 4.0])
        .cylinder([0.0; 3], [1.0, 0.01, 0.0], (0.5, 1e4), "gold");
    let through = Draft::seen_from([-2000.0, 0.1, 0.05], [0.0; 3])
        .light([-1997.0, 0.2, 0.1])
        .cylinder([0.0; 3], [1.0, 0.0, 0.0], (0.5, 1e4), "water");
    vec![
        picture(
            "dots of a thousandth",
            "spheres narrower than a pixel lie between those that are traced",
            dots,
        ),
        picture(
            "wires of a thousandth",
            "cylinders a thousandth of the scene wide, at all angles",
            wires,
        ),
        picture(
            "crumbs seen from near",
            "the camera looks at a thousandth of the scene, with an epsilon of a millionth",
            crumbs,
        ),
        picture(
            "cylinder 10^4 times longer than wide, along it",
            "its wall is seen almost along its axis up to where it ends",
            along,
        ),
        picture(
            "cylinder 10^4 times longer than wide, from inside",
            "rays take hundreds of radii from wall to wall",
            through,
        ),
    ]
}

fn views() -> Vec<Case> {
    let mut cases = Vec::new();
    for fov in [0.5, 0.01, 0.001] {
        let far = 3.0 / (fov / 2.0_f64).to_radians().tan();
        cases.push(picture(
            format!("telephoto {fov}°"),
            "neighbouring rays differ in their last bits",
            still_life([0.1 * far, -0.9 * far, 0.3 * far], TARGET, fov),
        ));
    }
    for fov in [150.0, 179.0, 179.999] {
        cases.push(picture(
            format!("wide {fov}°"),
            "the picture's edge is 1 / cos further from the eye than its middle",
            still_life(EYE, TARGET, fov),
        ));
    }
    cases
}

/// Returns a sphere with a light and a camera at distances of about its radius. For the largest
/// sphere, the eye is at the largest coordinate.
fn lonely(radius: f64) -> Draft {
    let at = |at: [f64; 3]| at.map(|it| it * radius);
    Draft::seen_from(at([1.0, -1.0, 0.5]), [0.0; 3])
        .light(at([1.0, -0.5, 1.0]))
        .sphere([0.0; 3], radius, "gold")
        .epsilon(1e-3 * radius)
}

/// Returns a scene with a background and a material of 16, under the brightest light that the
/// material "white" allows.
fn glaring() -> Draft {
    usual()
        .material("dim", [0.1, 0.05, 0.08], [16.0, 0.8, 0.0, 1.0, 0.0])
        .shining([3.0, -5.0, 4.0], [14.0; 3])
        .sphere([0.0, 0.0, 0.6], 0.6, "dim")
        .background([16.0, 0.0, 0.5])
}

pub fn cases() -> Vec<Case> {
    let mut cases = ratios();
    cases.push(picture(
        "planet that mirrors a pebble, 10^6",
        "the same, and what is mirrored starts where the planet's surface is known to be: within a \
         step or two of the pebble's 256",
        planet_of("water", 1e6),
    ));
    cases.push(Case::new(
        "scaled by powers of two",
        "a scene has no size of its own: nothing may be compared with a constant of the format",
        Trial::Measured(scaled_by_powers),
    ));
    let edge = "the last number that is taken must be drawn truly";
    cases.push(picture("radius of 2^30", edge, lonely(2f64.powi(30))));
    cases.push(picture("radius of 2^-29", edge, lonely(2f64.powi(-29))));
    cases.push(picture("light of 14, material of 16", edge, glaring()));
    cases.extend(places());
    cases.extend(thin());
    cases.extend(views());
    cases
}
