//! Scenes that are constants: what is wrong with one stops the compiler with the fault's words.
//!
//! All of them are programs of one small package that is written, checked once, and read by the
//! compiler's messages.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use reflet::Error;
use reflet::Fault::{self, *};
use serde_json::Value;

/// A constant of a scene or a material, and its fault.
const FAULTS: [(&str, Fault); 37] = [
    (".sphere([0.0; 3], 0.0, WHITE)", Radius),
    (".sphere([0.0; 3], -1.0, WHITE)", Radius),
    (".cylinder([0.0; 3], UP, 0.0, 1.0, WHITE)", Radius),
    (".sphere([0.0; 3], f64::NAN, WHITE)", Coordinate),
    (".sphere([0.0; 3], f64::INFINITY, WHITE)", Coordinate),
    (".cylinder([0.0; 3], UP, 1.0, -0.5, WHITE)", Height),
    (".plane([0.0; 3], [0.0; 3], WHITE)", Normal),
    (".cylinder([0.0; 3], [0.0; 3], 1.0, 1.0, WHITE)", Axis),
    (".disc([0.0; 3], UP, 0.0, WHITE)", Radius),
    (".disc([0.0; 3], [0.0; 3], 1.0, WHITE)", Normal),
    (".sphere([0.0, 1.1e9, 0.0], 1.0, WHITE)", Coordinate),
    (".sphere([f64::NAN, 0.0, 0.0], 1.0, WHITE)", Coordinate),
    (".plane([0.0, 0.0, -1.1e9], UP, WHITE)", Coordinate),
    (
        ".light([0.0, f64::NEG_INFINITY, 0.0], [1.0; 3])",
        Coordinate,
    ),
    (".light([0.0; 3], [1.0, 1.0, 16.1])", Color),
    (".light([0.0; 3], [-0.1, 1.0, 1.0])", Color),
    (
        ".sphere([0.0; 3], 1.0, WHITE).sphere([0.0; 3], 1e-9, WHITE)",
        Tiny,
    ),
    (".sphere([0.0; 3], 1e-10, WHITE)", Extent),
    (".background([0.0, 17.0, 0.0])", Background),
    (".epsilon(0.0)", Epsilon),
    (".sphere([0.0; 3], 1e-4, WHITE)", Epsilon),
    (
        ".sphere([0.0; 3], 1.0, WHITE.diffuse(2.0)).light([9.0; 3], [16.0; 3])",
        Brightness,
    ),
    (
        ".sphere([0.0; 3], 1.0, WHITE).sphere([1.0; 3], 1.0, WHITE).sphere([2.0; 3], 1.0, WHITE)",
        TooManySpheres,
    ),
    (
        ".plane([0.0; 3], UP, WHITE).plane([1.0; 3], UP, WHITE)",
        TooManyPlanes,
    ),
    (
        ".cylinder([0.0; 3], UP, 1.0, 1.0, WHITE).cylinder([1.0; 3], UP, 1.0, 1.0, WHITE)",
        TooManyCylinders,
    ),
    (
        ".disc([0.0; 3], UP, 1.0, WHITE).disc([1.0; 3], UP, 1.0, WHITE)",
        TooManyDiscs,
    ),
    (
        ".light([0.0; 3], [1.0; 3]).light([1.0; 3], [1.0; 3])",
        TooManyLights,
    ),
    (
        ".sphere([0.0; 3], 1.0, WHITE).plane([0.0; 3], UP, WHITE.mirror(0.5))",
        TooManyMaterials,
    ),
    ("Material::new([0.5, 0.5, 17.0])", Color),
    ("Material::new([f64::NAN, 0.5, 0.5])", Color),
    ("WHITE.ambient(-0.1)", Ambient),
    ("WHITE.diffuse(16.1)", Diffuse),
    ("WHITE.specular(-1.0, 4.0)", Specular),
    ("WHITE.specular(1.0, 1048577.0)", Shininess),
    ("WHITE.specular(1.0, -4.0)", Shininess),
    ("WHITE.mirror(1.1)", Mirror),
    ("WHITE.mirror(f64::NAN)", Mirror),
];

const CAMERAS: [(&str, CameraError); 6] = [
    (
        "Camera::look_at([0.0, 2e9, 0.0], [0.0; 3], UP)",
        CameraError::Coordinate,
    ),
    ("Camera::look_at([1.0; 3], [1.0; 3], UP)", CameraError::View),
    (
        "Camera::look_at([0.0; 3], [0.0, 0.0, 5.0], UP)",
        CameraError::Up,
    ),
    (
        "Camera::look_at([0.0; 3], [1.0; 3], [0.0; 3])",
        CameraError::Up,
    ),
    (
        "Camera::look_at([0.0; 3], [1.0; 3], UP).fov(180.0)",
        CameraError::FieldOfView,
    ),
    (
        "Camera::look_at([0.0; 3], [1.0; 3], UP).fov(0.0)",
        CameraError::FieldOfView,
    ),
];

/// A constant in which nothing is wrong.
const CONTROL: &str =
    ".sphere([0.0; 3], 1.0, WHITE).plane([0.0; 3], UP, WHITE).light([9.0; 3], [1.0; 3])";

/// Every constant that does not compile, and the words that the compiler must say.
fn cases() -> impl Iterator<Item = (&'static str, &'static str)> {
    let faults = FAULTS.map(|(constant, fault)| (constant, fault.words()));
    let cameras = CAMERAS.map(|(constant, error)| (constant, error.words()));
    faults.into_iter().chain(cameras)
}

/// A program with one constant: what a case says, as a method of a scene or by itself.
fn program(constant: &str) -> String {
    let (kind, value) = match constant.split_once(['(', '.']) {
        Some(("", _)) => {
            let scene = "Scene<room!(spheres: 2, planes: 1, cylinders: 1, discs: 1, lights: 1, materials: 1)>";
            (scene, format!("Scene::builder(){constant}.build()"))
        }
        Some(("Camera::look_at", _)) => ("Camera", constant.to_owned()),
        _ => ("Material", constant.to_owned()),
    };
    format!(
        "#![allow(unused)]
use reflet::{Camera, Material, Scene, room};
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
    for (number, (constant, _)) in cases().enumerate() {
        let path = programs.join(format!("wrong_{number}.rs"));
        fs::write(path, program(constant)).unwrap();
    }
    fs::write(programs.join("right.rs"), program(CONTROL)).unwrap();
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
        .args(["check", "--bins", "--keep-going", "--offline"])
        .args(["--message-format=json", "--target-dir=target"])
        .current_dir(folder)
        .env_remove("RUSTFLAGS")
        .output()
        .unwrap();
    let mut complaints = BTreeMap::<String, String>::new();
    let mut finished = 0;
    for line in String::from_utf8(output.stdout).unwrap().lines() {
        let message: Value = serde_json::from_str(line).unwrap();
        finished += u32::from(message["reason"] == "build-finished");
        if message["reason"] == "compiler-message" && message["message"]["level"] == "error" {
            let name = message["target"]["name"].as_str().unwrap();
            let words = message["message"]["rendered"].as_str().unwrap();
            *complaints.entry(name.to_owned()).or_default() += words;
        }
    }
    let errors = String::from_utf8_lossy(&output.stderr);
    assert_eq!(finished, 1, "the package was not checked: {errors}");
    complaints
}

#[test]
fn constants_that_are_wrong_do_not_compile_and_say_why() {
    let complaints = complaints(&written());
    for (number, (constant, words)) in cases().enumerate() {
        let found = complaints.get(&format!("wrong_{number}"));
        let found = found.unwrap_or_else(|| panic!("it compiles: {constant}"));
        // The compiler breaks no line of a message.
        assert!(found.contains(words), "{constant}: {found}");
    }
    assert_eq!(complaints.get("right"), None, "{CONTROL}");
    assert_eq!(complaints.len(), cases().count());
}
