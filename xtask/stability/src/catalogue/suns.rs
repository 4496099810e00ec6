//! Cases of suns: the limit of far lamps, grazing light, light along an axis, and discs in the sky.

use super::draft::{Draft, Setting, lit_by, usual};
use super::judge::{Pictures, SIDE};
use super::{Case, Trial, picture};

/// Direction towards the sun of the limit.
const TOWARDS: [f64; 3] = [0.8, -1.0, 0.7];

/// Tangent of half the field of view of a [`Draft::seen_from`].
const HALF_VIEW: f64 = 0.466_307_658;

/// Returns the still life with its water and usual camera, lit by this sun only.
fn sunny(direction: [f64; 3], disc: f64) -> Draft {
    Setting::HERE.furnish(usual()).sun(direction, disc)
}

/// Returns the still life, seen by a camera that looks up a little, under a sun whose middle is seen this far to
/// the right and upwards, in halves of the picture's side.
fn seen_at(place: [f64; 2], disc: f64) -> Draft {
    let length = 17f64.sqrt();
    let [right, up] = place.map(|it| it * HALF_VIEW);
    let direction = [right, (4.0 - up) / length, (1.0 + 4.0 * up) / length];
    let draft = Draft::seen_from([0.0, -4.0, 1.5], [0.0, 0.0, 2.5]);
    Setting::HERE.furnish(draft).sun(direction, disc)
}

/// Checks that pictures lit by a lamp come nearer to that of a sun as the lamp moves away, and that a lamp 10^9 away
/// gives the same one: to the bit in `Exact`, within one level in `Fast`. `Fast` interpolates a sun on round surfaces and
/// traces all that a far lamp may reach.
fn limit_of_lamps() -> Result<String, String> {
    let drawn = |draft: Draft| Pictures::of(&draft, false);
    let sun = drawn(sunny(TOWARDS, 0.0))?;
    let mut counts = Vec::new();
    for power in 1..=9 {
        let lamp = drawn(lit_by(TOWARDS.map(|it| it * 10f64.powi(power))))?;
        counts.push(lamp.differing(&sun));
    }
    let words = format!("pixels that differ from the sun's, lamps 10 to 10^9 away: {counts:?}");
    if counts.is_sorted_by(|near, far| near >= far) && counts.ends_with(&[0]) {
        Ok(words)
    } else {
        Err(words)
    }
}

pub fn cases() -> Vec<Case> {
    let grazing = "n · l is next to nothing or nothing, and shadows are as long as the floor";
    let axis = "products with the direction's zeros must be zero, and n · l is 1 or 0";
    let disc =
        "whether a pixel shows the disc is decided by the last bits of a cosine, in mirrors, too";
    // The middle of a pixel.
    let pixel = 39.0 / f64::from(SIDE);
    let limit = Case::new(
        "a lamp that moves away becomes a sun",
        "a sun is the limit of a lamp",
        Trial::Claim(limit_of_lamps),
    );
    let low = [
        ("sun at a height of 1 / 2000", [1000.0, 0.3, 0.5], 0.0),
        ("sun at a height of 5 / 10^6", [100.0, 0.0, 5e-4], 0.0),
        ("sun at the horizon", [1.0, -0.2, 0.0], 6.0),
    ];
    let along = [
        ("sun along x", [1.0, 0.0, 0.0]),
        ("sun behind the camera, along y", [0.0, -1.0, 0.0]),
        ("sun overhead, along z", [0.0, 0.0, 1.0]),
        ("sun under the floor, along z", [0.0, 0.0, -1.0]),
    ];
    let seen = [
        ("disc at the picture's edge", [1.0, 0.4], 6.0),
        ("disc in the picture's corner", [1.0, 1.0], 6.0),
        (
            "disc that reaches a pixel into the picture",
            [0.4, 1.12],
            6.0,
        ),
        ("disc smaller than a pixel", [pixel; 2], 0.1),
        ("disc of 90°", [-1.0, 0.4], 90.0),
    ];
    let low = low.map(|(name, direction, disc)| picture(name, grazing, sunny(direction, disc)));
    let along = along.map(|(name, direction)| picture(name, axis, sunny(direction, 6.0)));
    let seen = seen.map(|(name, place, angle)| picture(name, disc, seen_at(place, angle)));
    [limit]
        .into_iter()
        .chain(low)
        .chain(along)
        .chain(seen)
        .collect()
}
