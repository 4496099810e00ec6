//! Tests that a scene that is mirrored, turned by a right angle, moved or enlarged gives the same
//! picture; mirrored if the scene is.

use std::collections::BTreeSet;

use command_line::Quality;
use embedded_graphics::geometry::Size;
use lost::case::differing;
use reflet::host::compare::{Difference, compare};
use reflet::host::reference::{Picture, Vector};
use serde_json::{Value, json};

use stability::catalogue::draft::{Draft, Setting, TARGET, UP, lit_by, still_life};
use stability::catalogue::scene::Scene;

pub const SIDE: u32 = 96;

/// Fields of a scene file that hold points, and those that hold directions.
const PLACES: [&str; 3] = ["position", "target", "center"];
const WAYS: [&str; 3] = ["up", "normal", "axis"];

/// Returns the picture of a scene in `Exact`.
pub fn drawn(draft: &Draft) -> Picture {
    drawn_in(Quality::Exact, draft)
}

fn drawn_in(quality: Quality, draft: &Draft) -> Picture {
    let scene = Scene::read(draft).unwrap();
    scene.drawn(quality, Size::new_equal(SIDE))
}

/// Returns the number of colours in a picture.
fn colors(picture: &Picture) -> usize {
    BTreeSet::from_iter(&picture.pixels).len()
}

/// Applies `change` to the points or directions in the fields of these names.
fn changed(draft: &Draft, names: &[&str], change: impl Fn([f64; 3]) -> [f64; 3]) -> Draft {
    let mut draft = draft.clone();
    change_fields(&mut draft.file, &|name, field| {
        if names.contains(&name) {
            let triple: [f64; 3] = serde_json::from_value(field.take()).unwrap();
            *field = json!(change(triple));
        }
    });
    draft
}

/// Moves every point.
fn moved(draft: &Draft, offset: [f64; 3]) -> Draft {
    changed(draft, &PLACES, |at| (Vector(at) + Vector(offset)).0)
}

/// Applies `change` to every point and direction.
fn turned(draft: &Draft, change: impl Fn([f64; 3]) -> [f64; 3]) -> Draft {
    changed(draft, &[PLACES, WAYS].concat(), change)
}

/// Calls `change` with the name and the value of every field, at any depth.
fn change_fields(value: &mut Value, change: &impl Fn(&str, &mut Value)) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|it| change_fields(it, change)),
        Value::Object(fields) => fields.iter_mut().for_each(|(name, field)| {
            change(name, field);
            change_fields(field, change);
        }),
        _ => {}
    }
}

/// Returns scenes with all kinds of shapes, mirrors and shadows.
fn scenes() -> Vec<Draft> {
    vec![
        Setting::HERE.still_life(),
        still_life([-3.0, -2.5, 0.7], [0.0, 0.0, 0.4], 70.0),
        // From inside of the golden sphere; only a light inside makes its wall visible.
        still_life([-1.2, 0.1, 0.7], TARGET, 100.0).shining([-0.9, -0.2, 0.8], [0.5, 0.6, 0.7]),
        lit_by([-2.0, 1.5, 3.0]),
    ]
}

/// Checks that two pictures are the same except for rounding. Numbers round down, so mirroring a
/// scene changes last bits: colours half way between two levels differ by one level, and rims by a
/// pixel.
fn assert_same(found: &Picture, expected: &Picture, what: &str) {
    let Difference { within1, same, .. } = compare(found, expected).unwrap();
    println!("{what}: same {same:.4}, within 1 {within1:.4}");
    assert!(within1 >= 0.998 && same >= 0.98, "{what}: {same} {within1}");
}

#[test]
fn mirrored_scene_shows_the_mirrored_picture() {
    for (number, scene) in scenes().iter().enumerate() {
        let picture = drawn(scene);
        for axis in 0..3 {
            let mut mirrored = drawn(&turned(scene, |mut at| {
                at[axis] = -at[axis];
                at
            }));
            // Right is forward x up, so the picture of every mirrored scene has left and right
            // exchanged.
            let rows = mirrored.pixels.chunks_exact_mut(SIDE as usize);
            rows.for_each(<[_]>::reverse);
            assert_same(&mirrored, &picture, &format!("scene {number}, axis {axis}"));
        }
    }
}

/// Checks that a change of a scene changes no picture, except for rounding. If `is_exact`, not even a bit.
fn assert_unchanged(what: &str, is_exact: bool, change: impl Fn(&Draft) -> Draft) {
    for (number, scene) in scenes().iter().enumerate() {
        let (found, expected) = (drawn(&change(scene)), drawn(scene));
        let what = format!("scene {number}, {what}");
        assert_same(&found, &expected, &what);
        assert!(!is_exact || found.pixels == expected.pixels, "{what}");
    }
}

#[test]
fn turned_scene_shows_the_same_picture() {
    for turn in [
        |[x, y, z]: [f64; 3]| [-y, x, z],
        |[x, y, z]: [f64; 3]| [y, z, x],
        |[x, y, z]: [f64; 3]| [x, -z, y],
    ] {
        assert_unchanged("turned", false, |scene| turned(scene, turn));
    }
}

#[test]
fn moved_scene_shows_the_same_picture() {
    for (offset, is_exact) in [
        // A whole number of grid steps: all points keep their distances in whole steps.
        ([3.0, -5.0, 7.0], true),
        ([1234.567, -0.001, 99.9], false),
        ([1e6, 2e6, -3e6], false),
    ] {
        let what = format!("moved by {offset:?}");
        assert_unchanged(&what, is_exact, |scene| moved(scene, offset));
    }
}

#[test]
fn directions_of_any_length_show_the_same_picture() {
    for (factor, is_exact) in [(2f64.powi(-20), true), (3.0, false), (1e6, false)] {
        let longer = |way: [f64; 3]| way.map(|it| it * factor);
        let what = format!("directions times {factor}");
        assert_unchanged(&what, is_exact, |scene| changed(scene, &WAYS, longer));
    }
}

/// Multiplies every point and length by a factor.
fn enlarged(draft: &Draft, factor: f64) -> Draft {
    let mut draft = changed(draft, &PLACES, |at| at.map(|it| it * factor));
    change_fields(&mut draft.file, &|name, field| {
        if ["radius", "height", "epsilon"].contains(&name) {
            *field = json!(field.as_f64().unwrap() * factor);
        }
    });
    // Without this field epsilon would be a thousandth of a unit, whatever the scene's lengths are.
    assert!(draft.file["epsilon"].is_number());
    draft
}

/// Returns scenes that are no still life.
fn other_scenes() -> Vec<(&'static str, Draft)> {
    let pebbles = Draft::seen_from([0.5, -6.0, 2.0], [0.0, 0.0, 0.8])
        .sphere([0.0, 0.0, -1e3], 1e3, "chalk")
        .sphere([0.0, 0.0, 1.0], 1.0, "gold")
        .sphere([1.6, 0.0, 0.5], 0.5, "water");
    let room = [0, 1, 2].into_iter().fold(
        Draft::through([0.7, -0.6, 0.1], [-0.3, 0.8, -0.2], UP, 110.0),
        |draft, axis| {
            let wall = |side: f64| {
                let mut at = [0.0; 3];
                at[axis] = side;
                at
            };
            draft
                .plane(wall(-1.1), wall(1.0), "water")
                .plane(wall(1.3), wall(-1.0), "gold")
        },
    );
    let room = room.sphere([0.2, 0.4, -0.6], 0.4, "mirror");
    let tube = Draft::through([-1.9, 0.1, 0.05], [0.0; 3], UP, 90.0)
        .cylinder([0.0; 3], [1.0, 0.1, 0.05], (0.5, 5.0), "gold")
        .sphere([0.6, 0.1, -0.2], 0.2, "mirror");
    let bubble = Draft::through([0.3, -0.4, 0.2], [0.0, 0.5, 0.0], UP, 100.0)
        .sphere([0.0; 3], 1.0, "gold")
        .sphere([-0.3, 0.4, -0.2], 0.25, "water");
    let reeds = (0..8).map(f64::from).fold(
        Draft::seen_from([0.0, -3.0, 0.6], [0.0; 3]),
        |draft, number| {
            let at = [0.3 * number - 1.0, (2.4 * number).sin(), 0.1 * number - 0.5];
            let axis = [(1.7 * number).cos(), 0.3, 1.0];
            draft
                .cylinder(at, axis, (1e-3, 2.0), "gold")
                .sphere(at.map(|it| 0.7 * it), 2e-3, "red")
        },
    );
    let horizon = Draft::through([0.0, 0.0, 0.3], [1.0, 3.0, 0.2], UP, 70.0)
        .plane([0.0; 3], [0.03, -0.02, 1.0], "water")
        .plane([0.0, 40.0, 0.0], [0.1, -1.0, 0.2], "chalk");
    let lit = [
        ("planet", pebbles, [3.0, -5.0, 6.0]),
        ("room", room, [0.2, 0.3, 0.9]),
        ("tube", tube, [-1.0, 0.0, 0.2]),
        ("bubble", bubble, [0.1, -0.2, 0.7]),
        ("reeds", reeds, [700.0, -900.0, 450.0]),
        ("horizon", horizon, [900.0, -300.0, 600.0]),
    ];
    let lit = lit.into_iter();
    lit.map(|(name, draft, light)| (name, draft.light(light).epsilon(1e-3)))
        .collect()
}

/// Scaling by a power of two moves the binary point of every number and changes no digit, so no
/// pixel differs.
#[test]
fn scene_made_larger_by_a_power_of_two_shows_the_same_picture() {
    let still_lifes = scenes().into_iter().map(|scene| ("still life", scene));
    for (name, scene) in still_lifes.chain(other_scenes()) {
        for quality in [Quality::Exact, Quality::Fast] {
            let expected = drawn_in(quality, &scene);
            let colors = colors(&expected);
            println!("{name}: {colors} colours");
            assert!(colors > 20, "{name} shows nothing");
            for power in [-20, -7, 1, 20] {
                let found = drawn_in(quality, &enlarged(&scene, 2f64.powi(power)));
                let differ = differing(&found, &expected, 0);
                assert_eq!(differ, 0, "{name}, 2^{power}, {quality:?}");
            }
        }
    }
}

/// Returns a scene with a far light and floors without an end. Every coordinate is a multiple of 1/64,
/// and the camera is at this many times its usual distance.
fn in_64ths(distance: f64) -> Draft {
    let eye = [0.5, -5.5, 2.0].map(|it| it * distance);
    Draft::through(eye, TARGET, [0.0, 0.125, 1.0], 50.0 / distance)
        .sphere([-1.0, 0.0, 0.75], 0.75, "gold")
        .sphere([0.5, -1.0, 0.25], 0.25, "chalk")
        .sphere([1.5, 0.5, 0.5], 0.5, "water")
        .cylinder([0.5, 0.75, 0.75], [0.0, 0.25, 1.0], (0.375, 1.5), "gold")
        .cylinder([0.0, 1.5, 0.25], [1.0, 0.0, 0.0], (0.125, 4.0), "chalk")
        .plane([5.0, 7.0, 0.0], UP, "water")
        .plane([0.0, 40.0, 0.0], [1.0, -9.0, 0.0], "chalk")
        .shining([3.0, -4.0, 6.0], [0.75, 0.75, 0.5])
        .shining([-3000.0, -4000.0, 6000.0], [0.5; 3])
        .epsilon(1.0 / 1024.0)
}

/// A scene has no position of its own: moved by numbers that the format holds, it gives the same
/// picture to the bit.
#[test]
fn scene_moved_by_what_the_format_holds_shows_the_same_picture() {
    for distance in [1.0, 16.0] {
        let scene = in_64ths(distance);
        let picture = drawn(&scene);
        let colors = colors(&picture);
        assert!(colors > 1000, "{colors} colours");
        for (power, offset) in [
            (0, [1.0, 0.0, 0.0]),
            (0, [-0.015625, 1000.0, 3.5]),
            (0, [1e8, -1e8, 123_456_789.0]),
            (-9, [1e6, 2e6, -3e6]),
            (9, [-7777.5, 0.25, 31.0]),
        ] {
            let found = drawn(&enlarged(&moved(&scene, offset), 2f64.powi(power)));
            let differ = differing(&found, &picture, 0);
            assert_eq!(differ, 0, "{distance}, {power}, {offset:?}");
        }
    }
}
