//! Cases of shading: exponents, grazing light, too much light and no light.

use super::draft::{Draft, Setting, UP, lit_by, usual};
use super::{Case, LAST_BIT, picture};

fn shiny(shininess: f64) -> Draft {
    usual()
        .material("shiny", [0.8, 0.6, 0.4], [0.1, 0.3, 1.0, shininess, 0.1])
        .sphere([0.0, 0.0, 0.6], 0.6, "shiny")
        .sphere([1.0, 0.5, 0.4], 0.4, "shiny")
        .cylinder([-1.2, 0.0, 0.5], UP, (0.3, 1.0), "shiny")
        .plane([0.0; 3], UP, "shiny")
        .light([3.0, -5.0, 4.0])
        .light([0.4, -4.0, 1.4])
}

fn lonely(light: [f64; 3]) -> Draft {
    Draft::seen_from([0.0, -5.0, 0.0], [0.0; 3])
        .light(light)
        .sphere([0.0; 3], 1.0, "chalk")
        .sphere([1.7, -0.6, 0.0], 0.3, "gold")
}

/// Returns a scene with 16 lights. Together they are far brighter than white, and as bright as the
/// material "white" allows.
fn bright() -> Draft {
    let draft = Setting::HERE.furnish(usual());
    let draft = draft.sphere([0.0, -1.5, 0.3], 0.3, "white");
    (0..16).fold(draft, |draft, number| {
        let angle = f64::from(number);
        let (x, y) = (5.0 * angle.cos(), 5.0 * angle.sin() - 4.0);
        let at = [x, y, 3.0 + 2.0 * (2.0 * angle).cos()];
        draft.shining(at, [0.9; 3])
    })
}

pub fn cases() -> Vec<Case> {
    let mut cases: Vec<_> = [0.0, 1.0, 2.5, 128.0, 1000.0, 1e5, f64::from(1 << 20)]
        .into_iter()
        .map(|shininess| {
            picture(
                format!("shininess {shininess}"),
                "a power magnifies the error of its base by the exponent; at 10^5 a highlight is half \
                 a degree wide, and at 0 it is everywhere",
                shiny(shininess),
            )
        })
        .collect();
    let grazing = "n · l is next to nothing, and its sign decides";
    let dark = "the shadow's edge on a round shape is where the surface turns away from the light";
    let sum = "the sum passes white, and must stay there";
    let (far, behind) = (lit_by([100.0, 0.0, 5e-4]), lonely([3.0, 10.0, 1.0]));
    cases.extend([
        picture("grazing light", grazing, lit_by([1000.0, 0.0, 0.5])),
        picture("light in the floor's height, far away", grazing, far),
        picture("sixteen lights on white", sum, bright()).unlike_single_precision(LAST_BIT),
        picture(
            "black and white",
            "black takes everything and white sends on all: nothing may be left over or be missing",
            usual()
                .light([3.0, -5.0, 4.0])
                .sphere([0.0, 0.0, 0.6], 0.6, "black")
                .sphere([1.0, 0.5, 0.4], 0.4, "white")
                .plane([0.0; 3], UP, "white"),
        ),
        picture("shadow terminator", dark, lonely([10.0, 0.0, 0.0])),
        picture("shadow terminator, light behind", dark, behind),
    ]);
    for range in [1e-19, 0.01, 0.5, 8.0, f64::from(1 << 30)] {
        let draft = usual().shining([-2.0, -6.0, 1.5], [0.3, 0.3, 0.4]);
        cases.push(picture(
            format!("light with a range of {range}"),
            "the squares of range and distance are up to 2^128 apart",
            Setting::HERE.furnish(draft).fading([1.2, -1.5, 0.9], range),
        ));
    }
    for epsilon in [1e-9, 1e-6, 1e-2, 0.1] {
        let case = picture(
            format!("epsilon {epsilon}"),
            "too small, and surfaces shade themselves; too large, and what touches comes apart",
            Setting::HERE.still_life().epsilon(epsilon),
        );
        cases.push(if epsilon == 0.1 { case.unlike_single_precision(
                "The red cylinder and the chalk sphere stand closer to each other than this epsilon: \
                 a ray that leaves the cylinder starts within the sphere, which hides the light from it. \
                 Fixed point tells shadows of spheres by the length of their tangents, which is for \
                 what starts outside of them.",
            ) } else { case });
    }
    cases
}
