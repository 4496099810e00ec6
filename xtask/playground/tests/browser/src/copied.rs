//! Compiles scenes that the page copied as Rust, all in one program, and runs it on this machine.

use std::fs;
use std::process::Command;

use crate::site::{repository, target};

/// Source of a program that draws each scene and prints the hash of its picture.
const MAIN: &str = r#"
use embedded_graphics::{geometry::Size, pixelcolor::{Rgb888, RgbColor}};
use frame_hash::FrameHash;

macro_rules! draw {
    ($scene:path, $camera:expr, $side:expr) => {{
        let frame = <$scene>::frame(&$camera).reflections(4).prepare(Size::new($side, $side));
        let rows = frame.on(&$scene).unwrap();
        let (mut row, mut hash) = ([Rgb888::BLACK; $side], FrameHash::NONE);
        for y in 0..$side {
            rows.row(y, 0, &mut row);
            row.iter().for_each(|it| hash.add([it.r(), it.g(), it.b()]));
        }
        hash.value()
    }};
}
"#;

const MANIFEST: &str = "[package]\nname = \"copied\"\nedition = \"2024\"\n[workspace]\n[dependencies]\n\
     embedded-graphics = { version = \"0.8\", default-features = false }\n";

/// Returns the lines that the program prints: the hash of each source at 64x64.
pub fn run(sources: &[String]) -> Vec<String> {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).unwrap();
    fs::create_dir(folder.path().join("src")).unwrap();
    let (root, mut manifest) = (repository(), MANIFEST.to_owned());
    for (package, path) in [("reflet", "."), ("frame_hash", "xtask/frame_hash")] {
        manifest += &format!("{package} = {{ path = {:?} }}\n", root.join(path));
    }
    write("Cargo.toml", &manifest);
    fs::copy(root.join("Cargo.lock"), folder.path().join("Cargo.lock")).unwrap();
    let (mut modules, mut calls) = (String::new(), String::new());
    for (at, source) in sources.iter().enumerate() {
        write(&format!("src/s{at}.rs"), source);
        modules += &format!("mod s{at};\n");
        let scene = format!("s{at}::{}, s{at}::CAMERA", type_name(source));
        calls += &format!("println!(\"{{:016x}}\", draw!({scene}, 64));\n");
    }
    let main = format!("{modules}{MAIN}fn main() {{\n{calls}}}\n");
    write("src/main.rs", &main);
    let cargo = Command::new("cargo")
        .args(["run", "--release", "--target-dir"])
        .arg(target().join("copied"))
        .current_dir(folder.path())
        .output()
        .unwrap();
    let words = String::from_utf8_lossy(&cargo.stderr);
    assert!(cargo.status.success(), "{words}");
    let printed = String::from_utf8(cargo.stdout).unwrap();
    printed.lines().map(str::to_owned).collect()
}

fn type_name(source: &str) -> &str {
    let rest = source.split_once("pub struct ").expect("a scene").1;
    rest.split_once(" {").expect("its parts").0
}
