//! Scenes that are constants: what is wrong with one stops the compiler, whose message names the part
//! and the fix.
//!
//! All of them are programs of one small package that is written, checked once, and read by the
//! compiler's messages.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::{env, fs};

use reflet::ErrorKind;
use serde_json::Value;

// Each line is a case: what is wrong, an arrow, the name of the wrong part, and the kind of the error.

/// Parts of a scene as `scene!` and `SceneBuilder` take them.
const PARTS: &str = "
sphere([0.0; 3], 0.0, WHITE); => sphere 0: Radius
sphere([0.0; 3], -1.0, WHITE); => sphere 0: Radius
cylinder([0.0; 3], UP, 0.0, 1.0, WHITE); => cylinder 0: Radius
sphere([0.0; 3], f64::NAN, WHITE); => sphere 0: Coordinate
sphere([0.0; 3], f64::INFINITY, WHITE); => sphere 0: Coordinate
cylinder([0.0; 3], UP, 1.0, -0.5, WHITE); => cylinder 0: Height
plane([0.0; 3], [0.0; 3], WHITE); => plane 0: Normal
cylinder([0.0; 3], [0.0; 3], 1.0, 1.0, WHITE); => cylinder 0: Axis
disc([0.0; 3], UP, 0.0, WHITE); => disc 0: Radius
disc([0.0; 3], [0.0; 3], 1.0, WHITE); => disc 0: Normal
triangle([[0.0; 3], UP, UP], None, WHITE); => triangle 0: Corners
triangle([[0.0; 3], UP, [1.0, 0.0, 0.0]], Some([UP, [0.0; 3], UP]), WHITE); => triangle 0: Normal
sphere([0.0, 1.1e9, 0.0], 1.0, WHITE); => sphere 0: Coordinate
sphere([f64::NAN, 0.0, 0.0], 1.0, WHITE); => sphere 0: Coordinate
plane([0.0, 0.0, -1.1e9], UP, WHITE); => plane 0: Coordinate
light([0.0, f64::NEG_INFINITY, 0.0], [1.0; 3]); => light 0: Coordinate
light([0.0; 3], [1.0, 1.0, 16.1]); => light 0: Color
light([0.0; 3], [-0.1, 1.0, 1.0]); => light 0: Color
light_with_range([0.0; 3], [1.0; 3], 0.0); => light 0: Range
light_with_range([0.0; 3], [1.0; 3], f64::INFINITY); => light 0: Range
sun([0.0; 3], [1.0; 3]); => sun 0: Sun
sun_with_disc(UP, [1.0; 3], 91.0); => sun 0: Sun
sphere([0.0; 3], 1.0, WHITE); sphere([0.0; 3], -1.0, WHITE); => sphere 1: Radius
sphere([0.0; 3], 1.0, WHITE); sphere([0.0; 3], 1e-9, WHITE); => sphere 1: Tiny
sphere([0.0; 3], 1e-10, WHITE); => scene: Extent
background([0.0, 17.0, 0.0]); => scene: Background
sphere([0.0; 3], 1.0, WHITE.checker([0.0; 3], [0.0, 1e-9, 0.0])); => material 0: Checker
sphere([0.0; 3], 1.0, WHITE.checker([0.0; 3], [1e6, 0.0, 0.0])); => material 0: Checker
sky([0.0; 3], [[1.0; 3]; 3]); => sky: Sky
sky(UP, [[1.0; 3], [1.0; 3], [0.0, 17.0, 0.0]]); => sky: Color
epsilon(0.0); => scene: Epsilon
sphere([0.0; 3], 1e-4, WHITE); => sphere 0: BelowEpsilon
sphere([0.0; 3], 1.0, WHITE.diffuse(2.0)); light([9.0; 3], [16.0; 3]); => material 0: Brightness
sphere([0.0; 3], 1.0, WHITE.ambient(0.0)); => scene: NoLight
plane([0.0; 3], UP, WHITE.ambient(0.0)); background([1.0; 3]); => scene: NoLight
camera(Camera::look_at([1.0; 3], [1.0; 3], UP)); => camera: View
motion([0.0; 3], [1.0, -1.0, 1.0]); sphere([0.0; 3], 1.0, WHITE); => motion: Motion
motion([0.0; 3], [1.0, 2e9, 1.0]); sphere([0.0; 3], 1.0, WHITE); => motion: Coordinate";

/// Parts that move in a `scene!`.
const MOVING: &str = "
sphere BALL([0.0; 3], 1.0, WHITE); => sphere 0: Motion
motion([-1.0; 3], [1.0, 1.0, 0.9]); sphere BALL([0.0; 3], 1.0, WHITE); => sphere 0: Motion
motion([-2.0; 3], [2.0; 3]); disc([9.0; 3], UP, 1.0, WHITE); disc LID([0.0, 1.5, 0.0], UP, 1.0, WHITE); => disc 1: Motion
motion([-2.0; 3], [2.0; 3]); cylinder LOG([0.0; 3], UP, 1.0, 4.0, WHITE); => cylinder 0: Motion
plane FLOOR([0.0; 3], UP, WHITE); => FLOOR: NothingMoves
sphere([0.0; 3], 1.0, WHITE); light LAMP([9.0; 3], [1.0; 3]); => LAMP: NothingMoves
sphere([0.0; 3], 1.0, WHITE); sun SUN([9.0; 3], [1.0; 3]); => SUN: NothingMoves";

/// What does not fit the room of a `SceneBuilder`: the room, a bar, and the parts.
const ROOMS: &str = "
spheres: 1 | sphere([0.0; 3], 1.0, WHITE); sphere([1.0; 3], 1.0, WHITE); => sphere 1: TooManySpheres
planes: 1 | plane([0.0; 3], UP, WHITE); plane([1.0; 3], UP, WHITE); => plane 1: TooManyPlanes
cylinders: 1 | cylinder([0.0; 3], UP, 1.0, 1.0, WHITE); cylinder([1.0; 3], UP, 1.0, 1.0, WHITE); => cylinder 1: TooManyCylinders
discs: 1 | disc([0.0; 3], UP, 1.0, WHITE); disc([1.0; 3], UP, 1.0, WHITE); => disc 1: TooManyDiscs
lights: 1 | light([0.0; 3], [1.0; 3]); light([1.0; 3], [1.0; 3]); => light 1: TooManyLights
planes: 1 | sphere([0.0; 3], 1.0, WHITE); => sphere 0: TooManySpheres
spheres: 1, planes: 1, materials: 1 | sphere([0.0; 3], 1.0, WHITE); plane([0.0; 3], UP, WHITE.mirror(0.5)); => material 1: TooManyMaterials
spheres: 2 | sphere([0.0; 3], 1.0, WHITE); => spheres: UnusedRoom
spheres: 1, planes: 1 | sphere([0.0; 3], 1.0, WHITE); => planes: UnusedRoom
spheres: 1, cylinders: 1 | sphere([0.0; 3], 1.0, WHITE); => cylinders: UnusedRoom
spheres: 1, discs: 3 | sphere([0.0; 3], 1.0, WHITE); => discs: UnusedRoom
spheres: 1, lights: 1 | sphere([0.0; 3], 1.0, WHITE); => lights: UnusedRoom";

/// Constants of one material or camera.
const CONSTANTS: &str = "
Material::new([0.5, 0.5, 17.0]) => material: Color
Material::new([f64::NAN, 0.5, 0.5]) => material: Color
WHITE.ambient(-0.1) => material: Ambient
WHITE.diffuse(16.1) => material: Diffuse
WHITE.specular(-1.0, 4.0) => material: Specular
WHITE.specular(1.0, 1048577.0) => material: Shininess
WHITE.specular(1.0, -4.0) => material: Shininess
WHITE.mirror(1.1) => material: Mirror
WHITE.mirror(f64::NAN) => material: Mirror
Camera::look_at([0.0, 2e9, 0.0], [0.0; 3], UP) => camera: Coordinate
Camera::look_at([1.0; 3], [1.0; 3], UP) => camera: View
Camera::look_at([0.0; 3], [0.0, 0.0, 5.0], UP) => camera: Up
Camera::look_at([0.0; 3], [1.0; 3], [0.0; 3]) => camera: Up
Camera::look_at([0.0; 3], [1.0; 3], UP).fov(180.0) => camera: FieldOfView
Camera::look_at([0.0; 3], [1.0; 3], UP).fov(0.0) => camera: FieldOfView";

/// Mistakes that the compiler shows: items of a program, the first line of the message, and lines of it
/// that show the mistake.
const SHOWN: &[(&str, &str, &str)] = &[
    (
        "scene! { struct Tried { sphere([0, 0, 1], 1, WHITE); } }",
        "error[E0308]: mismatched types",
        "sphere([0, 0, 1], 1, WHITE); } }\n  |                                 ^ expected `f64`, found integer",
    ),
    (
        "scene! { struct Tried { spere([0.0; 3], 1.0, WHITE); } }",
        "error[E0599]: no method named `spere` found for struct `SceneBuilder<R>` in the current scope",
        "spere([0.0; 3], 1.0, WHITE)",
    ),
    (
        "type Tried = reflet::RuntimeScene<room!(spheres: 1, sperez: 2)>; const TRIED: Option<Tried> = None;",
        "error[E0080]: evaluation panicked: room!(..) has no such list; it has spheres, cylinders, discs, triangles, planes, lights, materials",
        "room!(spheres: 1, sperez: 2)",
    ),
    (
        "type Tried = reflet::RuntimeScene<room!(spheres: 66000)>; const TRIED: Option<Tried> = None;",
        "error[E0080]: evaluation panicked: room!(..) has room for at most 65535 of each kind",
        "room!(spheres: 66000)",
    ),
    (
        "scene! { struct Tried {\nsphere([0.0; 3], 1.0, WHITE);\nplane([0.0; 3], UP, WHITE.mirror(2.0));\n} }",
        "error[E0080]: evaluation panicked: material: mirror must be within 0 to 1",
        "plane([0.0; 3], UP, WHITE.mirror(2.0));\n  |                     ^^^^^^^^^^^^^^^^^",
    ),
];

/// Scenes of several lines, and the first line of the message, which has the line of the mistake. A part
/// with a name has only the line of the macro.
const LINES: &[(&str, &str)] = &[
    (
        "scene! { struct Tried {\nsphere([0.0; 3], 1.0, WHITE);\nsphere([0.0; 3], -1.0, WHITE);\n} }",
        "sphere 1 in line 7: radius must be greater than 0",
    ),
    (
        "scene! { struct Tried {\nsphere(\n[0.0; 3],\n0.0,\nWHITE,\n);\n} }",
        "sphere 0 in line 6: radius must be greater than 0",
    ),
    (
        "scene! { struct Tried {\nsphere([0.0; 3], 1.0, WHITE);\nlight([0.0; 3],\n[-1.0; 3]);\n} }",
        "light 0 in line 7: color components must be within 0 to 16, where white is 1",
    ),
    (
        "scene! { struct Tried {\nmotion([-2.0; 3], [2.0; 3]);\nsphere BALL([0.0; 3], 0.0, WHITE);\n} }",
        "sphere 0: radius must be greater than 0",
    ),
    (
        "const TRIED: Scene<room!(spheres: 1)> = SceneBuilder::new()\n.sphere([0.0; 3], 0.0, WHITE)\n.build();",
        "sphere 0 in line 6: radius must be greater than 0",
    ),
];

/// Where most programs have their parts.
const IN_LINE: &str = " in line 5";

/// Parts in which nothing is wrong.
const RIGHT: &str = "motion([-2.0; 3], [2.0; 3]); sphere BALL([0.0; 3], 1.0, WHITE); plane([0.0; 3], UP, WHITE); light([9.0; 3], [1.0; 3]);";

/// A program that does not compile.
struct Wrong {
    items: String,
    /// First line of the compiler's message.
    first_line: String,
    /// The lines of source that the compiler's message shows.
    shown: &'static str,
}

impl Wrong {
    /// Creates a program that must not compile. The message names the faulty part and what is wrong with it.
    fn new(items: String, part: &str, kind: ErrorKind) -> Self {
        Self::stopped(items, &format!("{part}: {}", kind.message()))
    }

    /// Creates a program that must not compile. The compiler's message has these words.
    fn stopped(items: String, words: &str) -> Self {
        Self {
            items,
            first_line: format!("error[E0080]: evaluation panicked: {words}"),
            shown: "",
        }
    }
}

/// Returns the kind of an error by its name.
fn kind(name: &str) -> ErrorKind {
    macro_rules! by_name {
        ($($kind:ident)*) => {
            match name {
                $(stringify!($kind) => ErrorKind::$kind,)*
                _ => panic!("{name} is not in this list"),
            }
        };
    }
    by_name! {
        Ambient Axis Background BelowEpsilon Brightness Checker Color Coordinate Corners Diffuse Epsilon Extent
        FieldOfView Height Mirror Motion NoLight Normal NothingMoves Radius Range Shininess Sky Specular Sun Tiny
        TooManyCylinders TooManyDiscs TooManyLights TooManyMaterials TooManyPlanes TooManySpheres
        UnusedRoom Up View
    }
}

/// Returns the cases of a table: what is wrong, the name of the wrong part, and the kind of the error.
fn cases(table: &str) -> impl Iterator<Item = (&str, &str, ErrorKind)> {
    table.lines().skip(1).map(|line| {
        let (wrong, expected) = line.split_once(" => ").expect("an arrow");
        let (part, name) = expected.split_once(": ").expect("a part and a kind");
        (wrong, part, kind(name))
    })
}

/// Returns every program that does not compile.
fn wrong() -> Vec<Wrong> {
    let described = cases(PARTS).flat_map(|(parts, name, kind)| {
        let items = [in_macro(parts), in_builder(&fitting(parts), parts)];
        items.map(|items| Wrong::new(items, name, kind))
    });
    let moving = cases(MOVING).map(|(parts, name, kind)| Wrong::new(in_macro(parts), name, kind));
    let rooms = cases(ROOMS).map(|(both, name, kind)| {
        let (room, parts) = both.split_once(" | ").expect("a bar");
        Wrong::new(in_builder(room, parts), name, kind)
    });
    let constants = cases(CONSTANTS).map(|(value, part, kind)| {
        let (start, rest) = part.split_at(1);
        let type_of = start.to_uppercase() + rest;
        Wrong::new(format!("const TRIED: {type_of} = {value};"), part, kind)
    });
    let lights = "light([9.0; 3], [1.0; 3]); ".repeat(17);
    let many = Wrong::new(in_macro(&lights), "light 16", ErrorKind::TooManyLights);
    let balls = (0..17).map(|number| format!("sphere BALL{number}([0.0; 3], 1.0, WHITE); "));
    let balls = format!("motion([-2.0; 3], [2.0; 3]); {}", balls.collect::<String>());
    let many_move = Wrong::new(in_macro(&balls), "sphere 16", ErrorKind::TooManyMoving);
    let lines = LINES.iter();
    let lines = lines.map(|(items, words)| Wrong::stopped((*items).to_owned(), words));
    let shown = SHOWN.iter().map(|&(items, first_line, shown)| Wrong {
        items: items.to_owned(),
        first_line: first_line.to_owned(),
        shown,
    });
    described
        .chain(lines)
        .chain(moving)
        .chain(rooms)
        .chain(constants)
        .chain([many, many_move])
        .chain(shown)
        .collect()
}

/// Writes a scene with `scene!`.
fn in_macro(parts: &str) -> String {
    format!("scene! {{ struct Tried {{ {parts} }} }}")
}

/// Writes a scene with `SceneBuilder`.
fn in_builder(room: &str, parts: &str) -> String {
    let calls: String = calls(parts).map(|call| format!(".{call}")).collect();
    format!("const TRIED: Scene<room!({room})> = SceneBuilder::new(){calls}.build();")
}

/// Returns the parts of a scene, each as a call.
fn calls(parts: &str) -> impl Iterator<Item = &str> {
    parts
        .split_inclusive(");")
        .map(|call| call.trim().trim_end_matches(';'))
}

/// Returns the room that parts fill.
fn fitting(parts: &str) -> String {
    let kinds = ["sphere", "plane", "cylinder", "disc", "triangle", "light"];
    // A sun takes the room of a light.
    let parts = parts
        .replace("light_with_range(", "light(")
        .replace("sun_with_disc(", "light(")
        .replace("sun(", "light(");
    let counted = kinds.map(|kind| {
        let count = calls(&parts)
            .filter(|call| call.starts_with(&format!("{kind}(")))
            .count();
        format!("{kind}s: {count}")
    });
    counted.join(", ")
}

fn program(items: &str) -> String {
    format!(
        "#![allow(unused)]
use reflet::{{Camera, Material, Scene, SceneBuilder, room, scene}};
const UP: [f64; 3] = [0.0, 0.0, 1.0];
const WHITE: Material = Material::new([1.0; 3]);
{items}
fn main() {{}}
"
    )
}

/// Writes the package of all programs. It has the versions and the profile of this one, so cargo checks what both need
/// only once.
fn written() -> PathBuf {
    let this = Path::new(env!("CARGO_MANIFEST_DIR"));
    let own = fs::read_to_string(this.join("Cargo.toml")).unwrap();
    let is_own = |it: &&str| it.contains("[profile.dev]") || it.contains("dev.package.\"*\"]");
    let profile: String = own.split_inclusive("\n\n").filter(is_own).collect();
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("bad_scenes");
    let programs = folder.join("src/bin");
    fs::remove_dir_all(folder.join("src")).ok();
    fs::create_dir_all(&programs).unwrap();
    for (number, wrong) in wrong().iter().enumerate() {
        let path = programs.join(format!("wrong_{number}.rs"));
        fs::write(path, program(&wrong.items)).unwrap();
    }
    fs::write(programs.join("right.rs"), program(&in_macro(RIGHT))).unwrap();
    let manifest = format!(
        "[package]
name = \"bad_scenes\"
version = \"0.0.0\"
edition = \"2024\"
[dependencies]
reflet = {{ path = {this:?} }}
[workspace]
{profile}"
    );
    fs::write(folder.join("Cargo.toml"), manifest).unwrap();
    fs::copy(this.join("Cargo.lock"), folder.join("Cargo.lock")).unwrap();
    folder
}

/// What the compiler has against each program, by its name.
fn complaints(folder: &Path) -> BTreeMap<String, String> {
    let output = Command::new(env!("CARGO"))
        .args(["check", "--bins", "--keep-going", "--offline"])
        .args(["--message-format=json", "--target-dir=../.."])
        .current_dir(folder)
        .env_remove("RUSTFLAGS")
        .output()
        .unwrap();
    let (mut complaints, mut finished) = (BTreeMap::<String, String>::new(), 0);
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
    let (complaints, wrong) = (complaints(&written()), wrong());
    let mut differences = Vec::new();
    for (number, wrong) in wrong.iter().enumerate() {
        let Some(found) = complaints.get(&format!("wrong_{number}")) else {
            differences.push(format!("it compiles: {}", wrong.items));
            continue;
        };
        // The compiler breaks no line of a message. Most programs have all parts in the same line.
        let first = found.lines().next().unwrap_or_default();
        let is_said = first.replacen(IN_LINE, "", 1) == wrong.first_line;
        if !is_said || !found.contains(wrong.shown) {
            let (items, line, shown) = (&wrong.items, &wrong.first_line, &wrong.shown);
            differences.push(format!(
                "{items}\nshould say: {line}\nand {shown}\nbut says: {found}"
            ));
        }
    }
    assert!(differences.is_empty(), "{}", differences.join("\n\n"));
    assert_eq!(complaints.get("right"), None, "{RIGHT}");
    assert_eq!(complaints.len(), wrong.len());
}
