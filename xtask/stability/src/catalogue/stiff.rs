//! Cases of stiff accumulation: throughputs that hardly fall or that alternate, and very many terms.

use super::draft::{Draft, Setting, UP, usual};
use super::{Bar, Case, Trial, picture};

const OWN: [f64; 3] = [0.75, 0.5, 0.25];

/// Returns a camera inside a scene of the material "wall", which glows and mirrors by the share α.
/// In a closed room of it, each ray that stops after N reflections shows c (1 - α^(N + 1)).
fn glowing(alpha: f64) -> Draft {
    Draft::through([0.1, -0.3, 0.2], [0.3, 1.0, 0.1], UP, 90.0)
        .material("wall", OWN, [1.0, 0.0, 0.0, 1.0, alpha])
        .background([1.0; 3])
}

/// Adds a box of six walls, with these pairs of materials along the three axes.
fn boxed(draft: Draft, walls: [[&str; 2]; 3]) -> Draft {
    let axes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let pairs = axes.into_iter().zip(walls);
    pairs.fold(draft, |draft, (axis, [near, far])| {
        let draft = draft.plane(axis, axis, near);
        draft.plane(axis.map(|it: f64| -it), axis, far)
    })
}

fn closed(name: String, why: &'static str, draft: Draft, alpha: f64) -> Case {
    let share = 1.0 - alpha.powi(i32::from(draft.reflections) + 1);
    let color = OWN.map(|own| own * share);
    Case::new(name, why, Trial::Picture(draft, Bar::Color(color)))
}

fn parallel(alpha: f64) -> Draft {
    let (eye, target) = ([0.1, -0.3, 0.1], [1.0, 0.0, 0.15]);
    Draft::through(eye, target, UP, 60.0)
        .material("wall", [0.5, 0.7, 0.9], [0.5, 0.3, 0.0, 1.0, alpha])
        .plane([1.0, 0.0, 0.0], [1.0, 0.0, 0.0], "wall")
        .plane([-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], "wall")
        .sphere([0.2, 0.8, 0.0], 0.3, "chalk")
        .light([0.0, 0.5, 2.0])
}

/// Returns a room whose walls are mirror and chalk in turns, so that α is 1 or 0.
fn alternating() -> Draft {
    let (eye, target) = ([0.1, -0.9, 0.1], [0.2, 0.6, 0.05]);
    let (odd, even) = (["mirror", "chalk"], ["chalk", "mirror"]);
    let room = Draft::through(eye, target, UP, 70.0).light([0.0, -0.5, 0.4]);
    boxed(room, [odd, even, odd])
}

/// Returns a scene of 256 hits with 16 lights each: 4096 terms of about a ten-thousandth.
fn many_terms() -> Draft {
    let room = Draft::through([0.1, -0.3, 0.2], [0.3, 1.0, 0.1], UP, 90.0)
        .material("wall", [0.9, 0.7, 0.5], [0.2, 0.2, 0.0, 1.0, 0.9999])
        .sphere([0.0; 3], 1.0, "wall");
    (0..16).fold(room, |draft, number| {
        let angle = f64::from(number);
        let (x, y) = (0.6 * angle.cos(), 0.6 * angle.sin());
        draft.shining([x, y, 0.3 * (0.7 * angle).sin()], [0.9; 3])
    })
}

pub fn cases() -> Vec<Case> {
    let mut cases = Vec::new();
    for alpha in [0.9, 0.99, 0.999, 0.9999, 1.0] {
        for reflections in [4, 255] {
            let sphere = glowing(alpha).sphere([0.0; 3], 1.0, "wall");
            cases.push(closed(
                format!("mirrored sphere, α = {alpha}, N = {reflections}"),
                "up to 256 terms of one size must add up to what the closed form says, and no ray \
                 may leave the sphere",
                sphere.reflections(reflections),
                alpha,
            ));
        }
        cases.push(closed(
            format!("mirrored box, α = {alpha}, N = 255"),
            "the same between planes: a ray that slips through an edge sees the background",
            boxed(glowing(alpha).reflections(255), [["wall"; 2]; 3]),
            alpha,
        ));
        cases.push(picture(
            format!("parallel mirrors, α = {alpha}, N = 255"),
            "a point that is off by ε is off by 255 ε at the end of the tunnel, where a sphere is \
             seen again and again",
            parallel(alpha).reflections(255),
        ));
    }
    cases.push(picture(
        "α alternates between 0 and 1",
        "the weight is all or nothing, and which depends on the wall that is met last",
        alternating().reflections(255),
    ));
    cases.push(picture(
        "4096 terms of a ten-thousandth",
        "each is below an 8-bit step, all of them together are not",
        many_terms().reflections(255),
    ));
    for alpha in [0.003, 0.05] {
        let draft = usual()
            .material("faint", [0.5, 0.7, 0.9], [0.5, 0.3, 0.2, 10.0, alpha])
            .sphere([-1.0, 0.0, 0.6], 0.6, "faint")
            .sphere([0.6, -0.4, 0.4], 0.4, "faint")
            .plane([0.0; 3], UP, "faint");
        cases.push(picture(
            format!("faint mirrors, α = {alpha}, N = 255"),
            "weights fall below the smallest step of the format, and must fall to nothing",
            Setting::HERE.lit(draft).reflections(255),
        ));
    }
    cases
}
