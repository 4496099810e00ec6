//! What a page gets for what it asks, for the built-in scenes.

use reflet::host::reference::{Camera, Scene};
use reflet::scenes::{self, BuiltIn, Visitor};
use serde_json::{Value, json};

use super::*;

/// The settings of the measured pictures: 64x64, 4 reflections, Blinn-Phong, `Fast`.
const MEASURED: Settings = Settings {
    width: 64,
    height: 64,
    reflections: 4,
    quality: 0,
    shading: 0,
    smooth: 1,
    display: 0,
};

#[allow(dead_code)]
const EXACT: Settings = Settings {
    quality: 1,
    ..MEASURED
};

/// Writes a built-in scene as a scene file.
struct AsFile;

impl Visitor for AsFile {
    type Output = Value;

    fn visit<S: BuiltIn>(self) -> Value {
        let scene = S::with_description(|description| Scene::from(&description));
        let camera = Camera::from(&S::CAMERA);
        let material = |index: usize| format!("material {index}");
        let mut file = json!({
            "name": S::NAME,
            "camera": { "position": camera.position, "target": camera.target, "up": camera.up, "fov": camera.fov },
            "epsilon": scene.epsilon,
        });
        file["lights"] = scene
            .lights
            .iter()
            .map(|it| json!({ "position": it.position, "color": it.color }))
            .collect();
        file["materials"] = scene.materials.iter().enumerate().map(|(index, it)| {
            let checker = it.checker.map(|it| json!({ "color": it.color, "size": it.size }));
            json!({
                "name": material(index), "color": it.color, "ambient": it.ambient, "diffuse": it.diffuse,
                "specular": it.specular, "shininess": it.shininess, "mirror": it.mirror, "checker": checker,
            })
        }).collect();
        file["spheres"] = scene
            .spheres
            .iter()
            .map(|it| {
                json!({
                    "center": it.center, "radius": it.radius, "material": material(it.material),
                })
            })
            .collect();
        file["planes"] = scene
            .planes
            .iter()
            .map(|it| {
                json!({
                    "center": it.point, "normal": it.normal, "material": material(it.material),
                })
            })
            .collect();
        file["cylinders"] = scene
            .cylinders
            .iter()
            .map(|it| {
                json!({
                    "center": it.center, "axis": it.axis, "radius": it.radius, "height": it.height,
                    "material": material(it.material),
                })
            })
            .collect();
        file["discs"] = scene.discs.iter().map(|it| json!({
            "center": it.center, "normal": it.normal, "radius": it.radius, "material": material(it.material),
        })).collect();
        match scene.sky {
            None => file["background"] = json!(scene.background),
            Some(sky) => {
                file["sky"] = json!({
                    "up": sky.up, "below": sky.below, "horizon": sky.horizon, "above": sky.above,
                })
            }
        }
        file
    }
}

fn file(name: &str) -> Value {
    scenes::visit(name, AsFile).unwrap()
}

fn parsed(answer: &Answer) -> Value {
    assert!(!answer.is_refused, "{}", answer.text);
    serde_json::from_str(&answer.text).unwrap()
}

fn refused(answer: &Answer) -> Value {
    assert!(answer.is_refused, "{}", answer.text);
    serde_json::from_str(&answer.text).unwrap()
}

fn opened(name: &str) -> Playground {
    let mut playground = Playground::default();
    parsed(&playground.open(&file(name).to_string(), -1));
    playground
}

/// Draws a frame, and returns its pixels and what it tells.
fn drawn(playground: &mut Playground, settings: Settings) -> (Vec<u8>, Value) {
    assert_eq!(playground.frame(settings), Answer::nothing());
    let rows = (0..settings.height).flat_map(|y| playground.row(y).to_vec());
    let pixels = rows.collect();
    (pixels, parsed(&playground.finish()))
}

#[test]
fn pictures_have_the_hashes_that_an_emulated_board_reported() {
    let measured = include_str!("../../../docs/measured/m3.jsonl");
    let records = measured
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap());
    let is_meant = |it: &Value| {
        it["size"] == "64x64"
            && it["reflections"] == 4
            && it["shading"] == "blinn-phong"
            && it["quality"] == "fast"
    };
    let mut seen = 0;
    for record in records.filter(is_meant) {
        let Some(name) = scenes::NAMES.iter().find(|name| record["scene"] == **name) else {
            continue;
        };
        let (_, told) = drawn(&mut opened(name), MEASURED);
        assert_eq!(told["hash"], record["hash"], "{name}");
        seen += 1;
    }
    assert_eq!(seen, scenes::NAMES.len());
}

#[test]
fn open_scene_tells_what_it_has_and_needs() {
    let mut playground = Playground::default();
    let facts = parsed(&playground.open(&file("castle").to_string(), -1));
    assert_eq!(
        (&facts["name"], &facts["names"]),
        (&json!("castle"), &json!(["castle"]))
    );
    assert_eq!((&facts["planes"], &facts["lights"]), (&json!(2), &json!(1)));
    let has = |list: &str, word: &str| facts[list].as_array().unwrap().contains(&json!(word));
    assert!(
        has("needs", "spheres") && has("left_out", "discs"),
        "{facts}"
    );
    assert_eq!(facts["camera"], parsed(&playground.camera()));
}
