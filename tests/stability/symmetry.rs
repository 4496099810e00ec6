//! A scene that is mirrored, turned by a right angle, moved or made larger shows the same picture,
//! mirrored where it is.

use reflet::Exact;
use reflet::host::compare::{Difference, compare};
use reflet::host::file::SceneFile;
use reflet::host::reference::Picture;
use serde_json::Value;

use super::catalogue::draft::{Draft, Setting, lit_by, still_life};
use super::catalogue::judge::painted;

pub const SIDE: u32 = 96;

/// The picture of a scene file.
pub fn drawn(text: &str) -> Picture {
    let file = SceneFile::parse(text, None).unwrap();
    let (built, (_, camera)) = (file.build().unwrap(), file.runtime().unwrap());
    painted(built.frame(&camera).quality::<Exact>(), (SIDE, SIDE))
}

/// A scene file with every place and direction changed.
fn changed(text: &str, change: impl Fn([f64; 3], bool) -> [f64; 3] + Copy) -> String {
    let mut scene: Value = serde_json::from_str(text).unwrap();
    change_all(&mut scene, change);
    scene.to_string()
}

fn change_all(value: &mut Value, change: impl Fn([f64; 3], bool) -> [f64; 3] + Copy) {
    match value {
        Value::Array(items) => items.iter_mut().for_each(|item| change_all(item, change)),
        Value::Object(fields) => {
            for (name, field) in fields {
                let is_place = matches!(name.as_str(), "position" | "target" | "center");
                let is_way = matches!(name.as_str(), "up" | "normal" | "axis");
                if is_place || is_way {
                    let triple: [f64; 3] = serde_json::from_value(field.take()).unwrap();
                    *field = serde_json::json!(change(triple, is_place));
                } else {
                    change_all(field, change);
                }
            }
        }
        _ => {}
    }
}

/// Scenes with all kinds of shapes, mirrors and shadows.
fn scenes() -> Vec<Draft> {
    vec![
        Setting::HERE.still_life(),
        still_life([-3.0, -2.5, 0.7], [0.0, 0.0, 0.4], 70.0),
        still_life([-1.2, 0.1, 0.7], [0.0, 0.0, 0.5], 100.0),
        lit_by([-2.0, 1.5, 3.0]),
    ]
}

/// Rounding is downwards, so a mirrored ray is not the mirrored one to the last bit: colours differ by
/// a level where they are half way between two, and rims by a pixel.
fn assert_same(found: &Picture, expected: &Picture, what: &str) {
    let Difference { within1, same, .. } = compare(found, expected).unwrap();
    println!("{what}: same {same:.4}, within 1 {within1:.4}");
    assert!(within1 >= 0.998 && same >= 0.98, "{what}: {same} {within1}");
}

#[test]
fn mirrored_scene_shows_the_mirrored_picture() {
    for (number, scene) in scenes().iter().enumerate() {
        let picture = drawn(&scene.text());
        for axis in 0..3 {
            let mirror = |mut at: [f64; 3], _| {
                at[axis] = -at[axis];
                at
            };
            let mut mirrored = drawn(&changed(&scene.text(), mirror));
            // Right is forward x up, so every mirrored scene is seen with left and right exchanged.
            let rows = mirrored.pixels.chunks_exact_mut(SIDE as usize);
            rows.for_each(<[_]>::reverse);
            assert_same(&mirrored, &picture, &format!("scene {number}, axis {axis}"));
        }
    }
}

#[test]
fn turned_scene_shows_the_same_picture() {
    for (number, scene) in scenes().iter().enumerate() {
        let picture = drawn(&scene.text());
        for turned in [
            |[x, y, z]: [f64; 3]| [-y, x, z],
            |[x, y, z]: [f64; 3]| [y, z, x],
            |[x, y, z]: [f64; 3]| [x, -z, y],
        ] {
            let found = drawn(&changed(&scene.text(), |at, _| turned(at)));
            assert_same(&found, &picture, &format!("scene {number}, turned"));
        }
    }
}

/// A whole number of steps, from which every place is a whole number of steps away as before.
const WHOLE: [f64; 3] = [3.0, -5.0, 7.0];

#[test]
fn moved_scene_shows_the_same_picture() {
    for (number, scene) in scenes().iter().enumerate() {
        let picture = drawn(&scene.text());
        // A whole number of steps, and then any number.
        for offset in [WHOLE, [1234.567, -0.001, 99.9], [1e6, 2e6, -3e6]] {
            let shift = |at: [f64; 3], is_place: bool| match is_place {
                true => [0, 1, 2].map(|axis| at[axis] + offset[axis]),
                false => at,
            };
            let found = drawn(&changed(&scene.text(), shift));
            assert_same(&found, &picture, &format!("scene {number}, moved"));
            if offset == WHOLE {
                assert!(found.pixels == picture.pixels, "scene {number}");
            }
        }
    }
}

#[test]
fn directions_of_any_length_show_the_same_picture() {
    for scene in scenes() {
        let picture = drawn(&scene.text());
        for factor in [2f64.powi(-20), 3.0, 1e6] {
            let longer = |at: [f64; 3], is_place: bool| match is_place {
                true => at,
                false => at.map(|it| it * factor),
            };
            let found = drawn(&changed(&scene.text(), longer));
            assert_same(&found, &picture, "longer");
            if factor == 2f64.powi(-20) {
                assert!(found.pixels == picture.pixels, "a power of two");
            }
        }
    }
}
