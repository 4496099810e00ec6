//! Scenes that are constants: what is wrong with one stops the compiler with the fault's words.
//!
//! All of them are programs of one small package that is written, checked once, and read by the
//! compiler's messages.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use reflet::{CameraError, Fault};
use serde_json::Value;

/// A program's name, what its constant is, and the words the compiler must say.
type Case = (&'static str, &'static str, &'static str);

/// The name of the program in which nothing is wrong.
const CONTROL: &str = "nothing";

const CASES: [Case; 41] = [
    case("radius", ".sphere([0.0; 3], 0.0, WHITE)", Fault::Radius),
    case(
        "radius_below_zero",
        ".sphere([0.0; 3], -1.0, WHITE)",
        Fault::Radius,
    ),
    case(
        "radius_of_a_cylinder",
        ".cylinder([0.0; 3], UP, 0.0, 1.0, WHITE)",
        Fault::Radius,
    ),
    case(
        "radius_that_is_none",
        ".sphere([0.0; 3], f64::NAN, WHITE)",
        Fault::Coordinate,
    ),
    case(
        "radius_without_end",
        ".sphere([0.0; 3], f64::INFINITY, WHITE)",
        Fault::Coordinate,
    ),
    case(
        "height",
        ".cylinder([0.0; 3], UP, 1.0, -0.5, WHITE)",
        Fault::Height,
    ),
    case("normal", ".plane([0.0; 3], [0.0; 3], WHITE)", Fault::Normal),
    case(
        "axis",
        ".cylinder([0.0; 3], [0.0; 3], 1.0, 1.0, WHITE)",
        Fault::Axis,
    ),
    case(
        "center",
        ".sphere([0.0, 1.1e9, 0.0], 1.0, WHITE)",
        Fault::Coordinate,
    ),
    case(
        "center_that_is_none",
        ".sphere([f64::NAN, 0.0, 0.0], 1.0, WHITE)",
        Fault::Coordinate,
    ),
    case(
        "point",
        ".plane([0.0, 0.0, -1.1e9], UP, WHITE)",
        Fault::Coordinate,
    ),
    case(
        "light",
        ".light([0.0, f64::NEG_INFINITY, 0.0], [1.0; 3])",
        Fault::Coordinate,
    ),
    case(
        "light_color",
        ".light([0.0; 3], [1.0, 1.0, 16.1])",
        Fault::Color,
    ),
    case(
        "light_color_below_zero",
        ".light([0.0; 3], [-0.1, 1.0, 1.0])",
        Fault::Color,
    ),
    case(
        "tiny",
        ".sphere([0.0; 3], 1.0, WHITE).sphere([0.0; 3], 1e-9, WHITE)",
        Fault::Tiny,
    ),
    case("extent", ".sphere([0.0; 3], 1e-10, WHITE)", Fault::Extent),
    case(
        "background",
        ".background([0.0, 17.0, 0.0])",
        Fault::Background,
    ),
    case("epsilon", ".epsilon(0.0)", Fault::Epsilon),
    case(
        "epsilon_of_a_small_scene",
        ".sphere([0.0; 3], 1e-4, WHITE)",
        Fault::Epsilon,
    ),
    case(
        "brightness",
        ".sphere([0.0; 3], 1.0, WHITE.diffuse(2.0)).light([9.0; 3], [16.0; 3])",
        Fault::Brightness,
    ),
    case(
        "spheres",
        ".sphere([0.0; 3], 1.0, WHITE).sphere([1.0; 3], 1.0, WHITE).sphere([2.0; 3], 1.0, WHITE)",
        Fault::TooManySpheres,
    ),
    case(
        "planes",
        ".plane([0.0; 3], UP, WHITE).plane([1.0; 3], UP, WHITE)",
        Fault::TooManyPlanes,
    ),
    case(
        "cylinders",
        ".cylinder([0.0; 3], UP, 1.0, 1.0, WHITE).cylinder([1.0; 3], UP, 1.0, 1.0, WHITE)",
        Fault::TooManyCylinders,
    ),
    case(
        "lights",
        ".light([0.0; 3], [1.0; 3]).light([1.0; 3], [1.0; 3])",
        Fault::TooManyLights,
    ),
    case(
        "materials",
        ".sphere([0.0; 3], 1.0, WHITE).plane([0.0; 3], UP, WHITE.mirror(0.5))",
        Fault::TooManyMaterials,
    ),
    case("color", "Material::new([0.5, 0.5, 17.0])", Fault::Color),
    case(
        "color_that_is_none",
        "Material::new([f64::NAN, 0.5, 0.5])",
        Fault::Color,
    ),
    case("ambient", "WHITE.ambient(-0.1)", Fault::Ambient),
    case("diffuse", "WHITE.diffuse(16.1)", Fault::Diffuse),
    case("specular", "WHITE.specular(-1.0, 4.0)", Fault::Specular),
    case(
        "shininess",
        "WHITE.specular(1.0, 1048577.0)",
        Fault::Shininess,
    ),
    case(
        "shininess_below_zero",
        "WHITE.specular(1.0, -4.0)",
        Fault::Shininess,
    ),
    case("mirror", "WHITE.mirror(1.1)", Fault::Mirror),
    case(
        "mirror_that_is_none",
        "WHITE.mirror(f64::NAN)",
        Fault::Mirror,
    ),
    view(
        "camera_coordinate",
        "Camera::look_at([0.0, 2e9, 0.0], [0.0; 3], UP)",
        CameraError::Coordinate,
    ),
    view(
        "camera_view",
        "Camera::look_at([1.0; 3], [1.0; 3], UP)",
        CameraError::View,
    ),
    view(
        "camera_up",
        "Camera::look_at([0.0; 3], [0.0, 0.0, 5.0], UP)",
        CameraError::Up,
    ),
    view(
        "camera_up_of_zero",
        "Camera::look_at([0.0; 3], [1.0; 3], [0.0; 3])",
        CameraError::Up,
    ),
    view(
        "camera_fov",
        "Camera::look_at([0.0; 3], [1.0; 3], UP).fov(180.0)",
        CameraError::FieldOfView,
    ),
    view(
        "camera_fov_of_zero",
        "Camera::look_at([0.0; 3], [1.0; 3], UP).fov(0.0)",
        CameraError::FieldOfView,
    ),
    (
        CONTROL,
        ".sphere([0.0; 3], 1.0, WHITE).plane([0.0; 3], UP, WHITE).light([9.0; 3], [1.0; 3])",
        "",
    ),
];

const fn case(name: &'static str, constant: &'static str, fault: Fault) -> Case {
    (name, constant, fault.words())
}

const fn view(name: &'static str, constant: &'static str, error: CameraError) -> Case {
    (name, constant, error.words())
}

/// A program with one constant: what a case says, as a method of a scene or by itself.
fn program(constant: &str) -> String {
    let (kind, value) = match constant.split_once(['(', '.']) {
        Some(("", _)) => {
            let scene = "Scene<2, 1, 1, 1, 1>";
            (scene, format!("Scene::builder(){constant}.build()"))
        }
        Some(("Camera::look_at", _)) => ("Camera", constant.to_owned()),
        _ => ("Material", constant.to_owned()),
    };
    format!(
        "#![allow(unused)]
use reflet::{{Camera, Material, Scene}};
const UP: [f64; 3] = [0.0, 0.0, 1.0];
const WHITE: Material = Material::new([1.0; 3]);
const TRIED: {kind} = {value};
fn main() {{}}
"
    )
}

/// Writes the package of all cases, with the versions that this one is locked to.
fn written() -> PathBuf {
    let this = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bad_scenes");
    let programs = folder.join("src/bin");
    fs::remove_dir_all(folder.join("src")).ok();
    fs::create_dir_all(&programs).unwrap();
    for (name, constant, _) in CASES {
        fs::write(programs.join(format!("{name}.rs")), program(constant)).unwrap();
    }
    let manifest = format!(
        "[package]
name = \"bad_scenes\"
version = \"0.0.0\"
edition = \"2024\"
[dependencies]
reflet = {{ path = {this:?} }}
[workspace]
"
    );
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    fs::copy(this.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    folder
}

/// What the compiler has against each program, by its name.
fn complaints(folder: &Path) -> BTreeMap<String, String> {
    let output = Command::new(env!("CARGO"))
        .args([
            "check",
            "--bins",
            "--keep-going",
            "--offline",
            "--message-format=json",
        ])
        .arg("--target-dir")
        .arg(folder.join("target"))
        .current_dir(folder)
        .env_remove("RUSTFLAGS")
        .output()
        .unwrap();
    let mut complaints = BTreeMap::<String, String>::new();
    let mut finished = 0;
    let text = String::from_utf8(output.stdout).unwrap();
    for message in text
        .lines()
        .map(|line| serde_json::from_str::<Value>(line).unwrap())
    {
        finished += u32::from(message["reason"] == "build-finished");
        if message["reason"] == "compiler-message" && message["message"]["level"] == "error" {
            let name = message["target"]["name"].as_str().unwrap();
            let words = message["message"]["rendered"].as_str().unwrap();
            complaints
                .entry(name.to_owned())
                .or_default()
                .push_str(words);
        }
    }
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(finished, 1, "the package was not checked: {errors}");
    complaints
}

#[test]
fn constants_that_are_wrong_do_not_compile_and_say_why() {
    let complaints = complaints(&written());
    for (name, constant, words) in CASES {
        let found = complaints.get(name);
        if name == CONTROL {
            assert_eq!(found, None, "{constant}");
            continue;
        }
        let found = found.unwrap_or_else(|| panic!("{name} compiles: {constant}"));
        // The compiler breaks no line of a message.
        assert!(found.contains(words), "{name}: {constant}: {found}");
    }
    assert_eq!(complaints.len(), CASES.len() - 1);
}
