mod mistakes;
mod suns;

use std::borrow::ToOwned;
use std::io;
use std::path::Path;
use std::string::{String, ToString};
use std::vec::Vec;

use serde_json::{Value, json};

use super::*;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::host::reference;

/// A scene with one part of every kind, in which all numbers differ.
fn scene() -> Value {
    json!({
        "name": "still life",
        "camera": { "position": [1, -5, 2], "target": [0, 0, 1], "up": [0, 0.5, 1], "fov": 40 },
        "materials": [
            { "name": "clay", "color": [0.5, 0.25, 0.125], "ambient": 0.1, "diffuse": 0.75,
              "specular": 0, "shininess": 1, "mirror": 0 },
            { "name": "gold", "color": [0.75, 0.625, 0], "ambient": 0.2, "diffuse": 0.4,
              "specular": 0.8, "shininess": 4, "mirror": 0.5 }
        ],
        "lights": [ { "position": [3, -4, 6], "color": [1, 0.5, 0.25] } ],
        "spheres": [ { "center": [0, 0, 1.5], "radius": 1.25, "material": "gold" } ],
        "planes": [ { "center": [0, 0, -1], "normal": [0, 0, 2], "material": "clay" } ],
        "cylinders": [ { "center": [2, 0, 1], "axis": [0, 0, 3], "radius": 0.5, "height": 2.5,
                         "material": "gold" } ],
        "discs": [ { "center": [2, 0.5, 3], "normal": [0, 0, 4], "radius": 0.75, "material": "clay" } ],
        "triangles": [ { "corners": [[4, 0, 1], [5, 0, 1], [4, 0, 2.5]], "material": "gold",
                         "normals": [[0, -1, 0], [0.5, -1, 0], [0, -1, 0.5]] },
                       { "corners": [[4, 0, 1], [5, 0, 1], [4, 1, 1]], "material": "clay" } ],
        "background": [0.125, 0.25, 0.375],
        "epsilon": 0.0078125
    })
}

/// Returns the scene as text with the value at the JSON pointer replaced.
fn scene_with(pointer: &str, value: impl Into<Value>) -> String {
    let mut scene = scene();
    *scene.pointer_mut(pointer).expect(pointer) = value.into();
    scene.to_string()
}

/// Returns the scene as text without the key in the object at the JSON pointer.
fn scene_without(pointer: &str, key: &str) -> String {
    let mut scene = scene();
    let object = scene.pointer_mut(pointer).and_then(Value::as_object_mut);
    object.expect(pointer).remove(key).expect(key);
    scene.to_string()
}

fn parsed(text: &str) -> SceneFile {
    SceneFile::parse(text, None).unwrap()
}

/// Returns the message of the error that a text causes when it is read or built.
fn complaint(text: &str) -> String {
    let built = SceneFile::parse(text, None).and_then(|file| file.build().map(|_| ()));
    let complaint = built.unwrap_err().to_string();
    assert!(
        !complaint.contains(char::is_control),
        "{complaint:?} is one line"
    );
    complaint
}

#[test]
fn every_number_arrives_in_the_reference() {
    let file = parsed(&scene().to_string());
    assert_eq!(file.name(), Some("still life"));
    let (scene, camera) = file.reference();
    let clay = reference::Material {
        color: [0.5, 0.25, 0.125],
        ambient: 0.1,
        diffuse: 0.75,
        specular: 0.0,
        shininess: 1.0,
        mirror: 0.0,
        checker: None,
    };
    let gold = reference::Material {
        color: [0.75, 0.625, 0.0],
        ambient: 0.2,
        diffuse: 0.4,
        specular: 0.8,
        shininess: 4.0,
        mirror: 0.5,
        checker: None,
    };
    let expected = Scene {
        spheres: vec![reference::Sphere {
            center: [0.0, 0.0, 1.5],
            radius: 1.25,
            material: 1,
        }],
        planes: vec![reference::Plane {
            point: [0.0, 0.0, -1.0],
            normal: [0.0, 0.0, 2.0],
            material: 0,
        }],
        cylinders: vec![reference::Cylinder {
            center: [2.0, 0.0, 1.0],
            axis: [0.0, 0.0, 3.0],
            radius: 0.5,
            height: 2.5,
            material: 1,
        }],
        discs: vec![reference::Disc {
            center: [2.0, 0.5, 3.0],
            normal: [0.0, 0.0, 4.0],
            radius: 0.75,
            material: 0,
        }],
        triangles: vec![
            reference::Triangle {
                corners: [[4.0, 0.0, 1.0], [5.0, 0.0, 1.0], [4.0, 0.0, 2.5]],
                normals: Some([[0.0, -1.0, 0.0], [0.5, -1.0, 0.0], [0.0, -1.0, 0.5]]),
                material: 1,
            },
            reference::Triangle {
                corners: [[4.0, 0.0, 1.0], [5.0, 0.0, 1.0], [4.0, 1.0, 1.0]],
                normals: None,
                material: 0,
            },
        ],
        lights: vec![reference::Light {
            position: [3.0, -4.0, 6.0],
            color: [1.0, 0.5, 0.25],
            sun: None,
            range: None,
        }],
        materials: vec![clay, gold],
        background: [0.125, 0.25, 0.375],
        sky: None,
        epsilon: 0.0078125,
    };
    assert_eq!(scene, expected);
    let expected = Camera {
        position: [1.0, -5.0, 2.0],
        target: [0.0, 0.0, 1.0],
        up: [0.0, 0.5, 1.0],
        fov: 40.0,
    };
    assert_eq!(camera, expected);
}

#[test]
fn core_and_reference_are_given_the_same_scene() {
    let file = parsed(&scene().to_string());
    let (runtime, core_camera) = file.runtime().unwrap();
    let described = runtime.description();
    let (scene, camera) = file.reference();
    assert_eq!(Scene::from(&described), scene);
    assert_eq!(Camera::from(&core_camera.description()), camera);
    assert_eq!(described.camera, Some(core_camera));
    assert!(file.build().is_ok());
}

#[test]
fn what_may_be_left_out_has_a_value() {
    let camera = &scene()["camera"];
    let file = parsed(&json!({ "camera": camera }).to_string());
    assert_eq!(file.name(), None);
    assert_eq!(file.reference().0, Scene::default());
    assert!(file.build().is_ok());
}

#[test]
fn material_of_a_colour_alone_is_that_of_the_core() {
    let mut scene = scene();
    scene["materials"][1] = json!({ "name": "gold", "color": [0.75, 0.625, 0] });
    let file = parsed(&scene.to_string());
    let (runtime, _) = file.runtime().unwrap();
    let gold = crate::Material::new([0.75, 0.625, 0.0]);
    assert_eq!(runtime.description().materials[1], gold);
    let Value::Object(given) = &mut scene["materials"][1] else {
        unreachable!()
    };
    for key in ["ambient", "diffuse", "specular", "shininess", "mirror"] {
        given.insert(key.into(), Value::Null);
    }
    assert_eq!(
        parsed(&scene.to_string()).reference(),
        file.reference(),
        "null is the default"
    );
}

#[test]
fn schema_of_a_scene_is_ignored() {
    let mut with_schema = scene();
    with_schema["$schema"] = "../../docs/scene.schema.json".into();
    let plain = parsed(&scene().to_string()).reference();
    assert_eq!(parsed(&with_schema.to_string()).reference(), plain);
    let array = json!([with_schema]).to_string();
    assert_eq!(parsed(&array).reference(), plain);
    with_schema["$schema"] = 3.into();
    assert!(complaint(&with_schema.to_string()).contains("$schema"));
}

#[test]
fn byte_order_mark_is_skipped() {
    let text = format!("\u{feff}{}", scene());
    assert_eq!(parsed(&text).name(), Some("still life"));
}

#[test]
fn scene_of_an_array_is_chosen_by_name() {
    let camera = &scene()["camera"];
    let nameless = json!({ "camera": camera });
    let array = |names: &[&str]| {
        let scene = |name| json!({ "camera": camera, "name": name });
        let mut scenes: Vec<_> = names.iter().map(scene).collect();
        scenes.push(nameless.clone());
        Value::from(scenes).to_string()
    };
    let chosen = |text: &str, name| match SceneFile::parse(text, name) {
        Ok(file) => file.name().map(str::to_owned).unwrap_or_default(),
        Err(error) => error.to_string(),
    };
    assert_eq!(chosen(&array(&["a", "b"]), Some("b")), "b");
    assert_eq!(chosen(&array(&[]), None), "");
    assert_eq!(
        chosen(&scene().to_string(), Some("still life")),
        "still life"
    );

    let undecided = "choose one of the scenes a, b, (one without name)";
    assert_eq!(chosen(&array(&["a", "b"]), None), undecided);
    let missing = "there is no scene c, only a, b, (one without name)";
    assert_eq!(chosen(&array(&["a", "b"]), Some("c")), missing);
    let missing = "there is no scene c, only still life";
    assert_eq!(chosen(&scene().to_string(), Some("c")), missing);
    assert_eq!(
        chosen(&array(&["a", "b", "a"]), Some("a")),
        "scene 2 has the name a of scene 0"
    );
    assert_eq!(chosen("[]", None), "there is no scene in the file");
    assert_eq!(chosen(" [ ] ", Some("a")), "there is no scene in the file");
}

#[test]
fn file_may_hold_as_many_parts_as_it_says() {
    let bounds = [
        ("spheres", 512),
        ("planes", 32),
        ("cylinders", 128),
        ("discs", 128),
        ("lights", 16),
        ("materials", 256),
    ];
    for (list, bound) in bounds {
        let mut scene = scene();
        let parts = scene[list].as_array_mut().unwrap();
        let used = parts.len();
        let numbered = |number: usize| {
            let mut part = parts[0].clone();
            if list == "materials" {
                part["name"] = number.to_string().into();
            }
            part
        };
        let more: Vec<_> = (used..bound).map(numbered).collect();
        parts.extend(more);
        assert!(
            parsed(&scene.to_string()).runtime().is_ok(),
            "{bound} {list}"
        );

        let mut last = scene[list][0].clone();
        if list == "materials" {
            last["name"] = "last".into();
        }
        scene[list].as_array_mut().unwrap().push(last);
        let expected =
            format!("scene still life: {list}[{bound}]: there is room for {bound} {list} at most");
        assert_eq!(complaint(&scene.to_string()), expected);
    }
}

#[test]
fn error_is_one_line_whatever_the_names() {
    let text = scene_with("/name", "two\nlines\u{2028}").replace("\"gold\"", "\"go\\nld\"");
    let text = text.replacen("go\\nld", "g", 1);
    let found = complaint(&text);
    assert!(found.starts_with("scene two\\nlines\\u{2028}: "), "{found}");
}

#[test]
fn file_that_cannot_be_read_is_named() {
    let error = SceneFile::read("no/such/file.json", None).unwrap_err();
    assert!(
        error.to_string().starts_with("no/such/file.json: "),
        "{error}"
    );
    assert_eq!(error.file(), Some(Path::new("no/such/file.json")));
    let Problem::Unreadable(reason) = error.problem() else {
        panic!("{error:?}");
    };
    assert_eq!(reason.kind(), io::ErrorKind::NotFound);
}

#[test]
fn error_keeps_what_it_says_as_values() {
    let error = parsed(&scene_with("/spheres/0/radius", 0))
        .runtime()
        .unwrap_err();
    assert_eq!((error.file(), error.scene()), (None, Some("still life")));
    let expected = Error::at("sphere", 0, ErrorKind::Radius);
    assert!(
        matches!(error.problem(), Problem::Scene(found) if *found == expected),
        "{error:?}"
    );
}

#[test]
fn sky_arrives_in_core_and_reference_and_excludes_a_background() {
    let mut sky = scene();
    let (below, horizon, above) = ([0.5, 0.25, 0.0], [1.0, 1.0, 0.5], [0.0, 0.25, 2.0]);
    sky["sky"] = json!({ "up": [0, 0, 2], "below": below, "horizon": horizon, "above": above });
    assert_eq!(
        complaint(&sky.to_string()),
        "scene still life: a scene has a background or a sky: leave one out"
    );
    sky.as_object_mut().unwrap().remove("background");
    let mut flat = sky.clone();
    flat["sky"]["up"] = json!([0, 0, 0]);
    assert_eq!(
        complaint(&flat.to_string()),
        "scene still life: sky: up must not be zero"
    );
    let file = parsed(&sky.to_string());
    let (exact, _) = file.reference();
    let up = [0.0, 0.0, 2.0];
    let expected = reference::Sky {
        up,
        below,
        horizon,
        above,
    };
    assert_eq!(exact.sky, Some(expected));
    let (described, _) = file.runtime().unwrap();
    assert_eq!(Scene::from(&described.description()).sky, Some(expected));
}
