//! Tests that the built-in scenes have exactly the numbers that their authors wrote.
//!
//! The authors' file is in the folder `REFLET_COURSE`, or else next to the repository.

use std::{env, fs, path::PathBuf};

use reflet::description::Description;
use reflet::scenes::{BuiltIn, NAMES, Visitor, visit};
use reflet::{Camera, MaterialId, Number, Position};
use serde_json::{Value, json};

#[test]
fn every_built_in_scene_has_the_figures_of_its_source() {
    let folder = env::var_os("REFLET_COURSE").map_or_else(
        || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/course"),
        PathBuf::from,
    );
    let Ok(text) = fs::read_to_string(folder.join("scenes.json")) else {
        println!("skipped: there is no scenes.json in {}", folder.display());
        return;
    };
    let sources: Vec<Value> = serde_json::from_str(&text).unwrap();
    let names: Vec<&str> = sources
        .iter()
        .map(|it| it["name"].as_str().unwrap())
        .collect();
    assert_eq!(names, NAMES);
    for source in sources {
        let name = source["name"].as_str().unwrap().to_owned();
        let built_in = visit(&name, Describe).unwrap();
        let differences = differences(&name, &built_in, &resolved(&source));
        assert!(differences.is_empty(), "{}", differences.join("\n"));
    }
}

/// Converts a built-in scene to the form of the file, with each shape's material written out.
struct Describe;

impl Visitor for Describe {
    type Output = Value;

    fn visit<S: BuiltIn>(self) -> Value {
        S::with_description(|scene| described(&scene, &S::CAMERA))
    }
}

fn described(scene: &Description<'_>, camera: &Camera) -> Value {
    assert_eq!(scene.camera.as_ref(), Some(camera));
    let camera = camera.description();
    assert_eq!(scene.background, [Number::ZERO; 3]);
    assert_eq!(scene.epsilon, Number::new(1e-3));
    let material = |id: MaterialId| {
        let material = &scene.materials[id.index()];
        let coefficients = material.described_coefficients();
        let [ambient, diffuse, specular, shininess, mirror] = coefficients.map(Number::to_f64);
        json!({
            "color": material.described_color().map(Number::to_f64),
            "ambient": ambient, "diffuse": diffuse,
            "specular": specular, "shininess": shininess, "mirror": mirror,
        })
    };
    let list = |items: Vec<Value>| Value::Array(items);
    json!({
        "camera": {
            "position": triple(camera.position), "target": triple(camera.target),
            "up": triple(camera.up), "fov": camera.fov.to_f64(),
        },
        "spheres": list(scene.spheres.iter().map(|it| json!({
            "center": triple(it.center), "radius": it.radius.to_f64(),
            "material": material(it.material),
        })).collect()),
        "planes": list(scene.planes.iter().map(|it| json!({
            "center": triple(it.point), "normal": triple(it.normal),
            "material": material(it.material),
        })).collect()),
        "cylinders": list(scene.cylinders.iter().map(|it| json!({
            "center": triple(it.center), "axis": triple(it.axis),
            "radius": it.radius.to_f64(), "height": it.height.to_f64(),
            "material": material(it.material),
        })).collect()),
        "lights": list(scene.lights.iter().map(|it| json!({
            "position": triple(it.position), "color": it.color.map(Number::to_f64),
        })).collect()),
    })
}

fn triple(position: Position) -> [f64; 3] {
    position.0.map(Number::to_f64)
}

/// Returns a scene of the file with each shape's material written out and every number as an `f64`.
fn resolved(source: &Value) -> Value {
    let mut scene = source.clone();
    for kind in ["spheres", "planes", "cylinders"] {
        for shape in scene[kind].as_array_mut().unwrap() {
            let mut named = source["materials"].as_array().unwrap().iter();
            let material = named.find(|it| it["name"] == shape["material"]).unwrap();
            shape["material"] = material.clone();
            shape["material"].as_object_mut().unwrap().remove("name");
        }
    }
    let fields = scene.as_object_mut().unwrap();
    fields.retain(|name, _| name != "name" && name != "materials");
    with_floats(scene)
}

fn with_floats(value: Value) -> Value {
    match value {
        Value::Number(number) => json!(number.as_f64()),
        Value::Array(items) => items.into_iter().map(with_floats).collect(),
        Value::Object(fields) => fields
            .into_iter()
            .map(|(name, value)| (name, with_floats(value)))
            .collect(),
        other => other,
    }
}

/// Returns a line for each place where two values differ.
fn differences(place: &str, built_in: &Value, source: &Value) -> Vec<String> {
    match (built_in, source) {
        (Value::Array(ours), Value::Array(theirs)) if ours.len() == theirs.len() => {
            let pairs = ours.iter().zip(theirs).enumerate();
            pairs
                .flat_map(|(index, (a, b))| differences(&format!("{place}[{index}]"), a, b))
                .collect()
        }
        (Value::Object(ours), Value::Object(theirs)) if ours.keys().eq(theirs.keys()) => ours
            .iter()
            .flat_map(|(name, value)| differences(&format!("{place}.{name}"), value, &theirs[name]))
            .collect(),
        (ours, theirs) if ours == theirs => Vec::new(),
        (ours, theirs) => vec![format!("{place}: {ours} is {theirs} in the source")],
    }
}
