//! `cargo xtask copies`: tests that an example builds the same firmware when it is copied out of the
//! repository.
//!
//! A copy has every file of the example's folder. Only the path of reflet in its Cargo.toml is
//! changed. The copy is built in its own folder by the command that its README names.

use std::{
    fs,
    path::{Path, PathBuf},
};

use anyhow::{Context, Result, ensure};
use clap::{Args, builder::PossibleValuesParser};

use crate::measure::{Weight, fingerprint, images, weigh};
use crate::toolchain::{M0, M4F, M33, RV32IMAC, RV32IMC};
use crate::{enter_root, root, table, toolchain};

/// Copies examples out of the repository, builds the copies, and fails if one is not the firmware that
/// is built in the repository.
#[derive(Args, Debug)]
pub struct Arguments {
    /// The boards whose examples are copied [default: all]
    #[arg(value_name = "BOARD", value_parser = PossibleValuesParser::new(EXAMPLES.map(|it| it.board)))]
    examples: Vec<String>,
}

#[derive(Clone, Copy)]
pub(crate) struct Example {
    board: &'static str,
    folder: &'static str,
    pub target: &'static str,
    /// The program that shows the castle.
    pub program: &'static str,
}

const fn example(
    board: &'static str,
    folder: &'static str,
    target: &'static str,
    program: &'static str,
) -> Example {
    Example {
        board,
        folder,
        target,
        program,
    }
}

const EXAMPLES: [Example; 6] = [
    example("pico", "pico", M0, "pico"),
    example("pico2", "pico", M33, "castle"),
    example("blackpill", "blackpill", M4F, "blackpill"),
    example("esp32c3", "esp32c3", RV32IMC, "esp32c3"),
    example("microbit", "small", M0, "small"),
    example("riscv", "small", RV32IMAC, "small"),
];

impl Example {
    pub(crate) fn of(board: &str) -> Result<Self> {
        let example = EXAMPLES.into_iter().find(|it| it.board == board);
        example.with_context(|| format!("there is no example for {board}"))
    }

    /// Returns the path of its folder in the repository.
    pub(crate) fn folder(self) -> PathBuf {
        Path::new("examples").join(self.folder)
    }
}

pub fn run(arguments: &Arguments) -> Result<()> {
    enter_root()?;
    let names = &arguments.examples;
    let is_meant = |name: &&str| names.is_empty() || names.iter().any(|it| it == name);
    let mut rows = Vec::new();
    for name in EXAMPLES.map(|it| it.board).into_iter().filter(is_meant) {
        println!("copies: building {name} and its copy");
        let [there, copied] = both(name)?;
        let flash = [there, copied].map(|it| it.flash.to_string());
        rows.push(table::row(name, flash));
    }
    let head = ["example", "flash in place", "flash of a copy"];
    print!("{}", table::markdown(1, &head, rows));
    Ok(())
}

/// Builds an example and a copy of it, and returns the sizes of both.
///
/// # Errors
/// Fails if any loaded byte differs, or if the firmware contains no code.
fn both(name: &str) -> Result<[Weight; 2]> {
    let example = Example::of(name)?;
    let there = toolchain::build_for_chip(example.target, &example.folder(), example.program)?;
    // The copy is built to the same place.
    let (weight, content) = (weigh(&there)?, fingerprint(&there)?);
    ensure!(
        weight.code > 0,
        "the firmware of {name} is empty: its linker script is missing"
    );
    // Every program of the copy, as its README says.
    let copied = build_changed(name, (example.program, &[]), |_| Ok(()))?;
    let weights = [weight, weigh(&copied)?];
    let [one, other] = weights.map(|it| it.flash);
    ensure!(
        content == fingerprint(&copied)?,
        "a copy of {name} is not the same firmware: {one} bytes of flash in place, {other} in the copy"
    );
    Ok(weights)
}

/// Returns the firmware that a copy of an example builds.
pub fn firmware(name: &str) -> Result<PathBuf> {
    program(name, Example::of(name)?.program)
}

/// Copies an example, and returns one program that the copy builds. One build serves all tests.
pub fn program(name: &str, program: &str) -> Result<PathBuf> {
    program_with(name, program, "")
}

/// Does what [`program`] does, with features of the example.
pub fn program_with(name: &str, program: &str, features: &str) -> Result<PathBuf> {
    let example = Example::of(name)?;
    let only: &[&str] = &["--bin", program, "--features", features];
    let called = format!("{program} {features}");
    images::kept((&example.folder(), example.target, &called), || {
        build_changed(name, (program, only), |_| Ok(()))
    })
}

/// Builds a copy that draws another scene, as a person would: writes its source over `scene.rs`, and its name into the
/// line with `Shown`.
pub fn build_with_scene(name: &str, source: &str, scene: &str) -> Result<PathBuf> {
    let Example {
        folder, program, ..
    } = Example::of(name)?;
    // A package of another name: cargo takes packages of one name for the same, wherever they are.
    let package = format!("{folder}_scene");
    let (sources, built) = if program == folder {
        (PathBuf::from("src"), &*package)
    } else {
        (Path::new("src/bin").join(program), program)
    };
    build_changed(name, (built, &["--bin", built]), |copy| {
        let change = |file: &Path, old: &str, new: &str| {
            let file = copy.join(file);
            let text = fs::read_to_string(&file)?;
            ensure!(text.matches(old).count() == 1, "{}: {old}", file.display());
            Ok(fs::write(file, text.replace(old, new))?)
        };
        fs::write(copy.join(&sources).join("scene.rs"), source)?;
        let shown = |scene: &str| format!("{scene} as Shown");
        change(&sources.join("main.rs"), &shown("Castle"), &shown(scene))?;
        let name = |package: &str| format!("\nname = \"{package}\"\n");
        for file in ["Cargo.lock", "Cargo.toml"] {
            change(file.as_ref(), &name(folder), &name(&package))?;
        }
        let run = |package: &str| format!("default-run = \"{package}\"");
        change("Cargo.toml".as_ref(), &run(folder), &run(&package))
    })
}

/// Copies an example out of the repository, changes the copy, builds it with these arguments, and returns the program
/// of a name. What other packages for boards have compiled is not compiled again.
fn build_changed(
    name: &str,
    (program, arguments): (&str, &[&str]),
    change: impl FnOnce(&Path) -> Result<()>,
) -> Result<PathBuf> {
    let example = Example::of(name)?;
    let place = tempfile::tempdir().context("there is no folder for a copy")?;
    let is_outside = !place.path().starts_with(root());
    ensure!(is_outside, "temporary files lie in the repository");
    let copy = place.path().join(name);
    copy_example(&root().join(example.folder()), &copy)?;
    change(&copy)?;
    let folder = toolchain::directory_for(example.target);
    let cargo = toolchain::cargo_build("release", example.target)?.in_folder(&copy);
    let cargo = cargo.args(["--target-dir".as_ref(), folder.as_os_str()]);
    let built = toolchain::built(cargo.args(arguments))?;
    Ok(built.with_file_name(program))
}

/// Copies an example's folder. In the copy, the manifest names reflet by its absolute path.
fn copy_example(from: &Path, to: &Path) -> Result<()> {
    copy_folder(from, to)?;
    let manifest = to.join("Cargo.toml");
    let text = fs::read_to_string(&manifest).context("an example has a manifest")?;
    let root = root().into_os_string().into_string();
    let root = root.ok().context("the path of the repository is no text")?;
    fs::write(manifest, with_reflet_in(&text, &root)).context("cannot write a manifest")
}

/// Returns the manifest with the path of reflet replaced by `root`.
fn with_reflet_in(manifest: &str, root: &str) -> String {
    manifest.replace("path = \"../..\"", &format!("path = \"{root}\""))
}

/// Copies all files of a folder, except what cargo built in its `target` folders.
fn copy_folder(from: &Path, to: &Path) -> Result<()> {
    let failed = || format!("cannot copy {}", from.display());
    fs::create_dir_all(to).with_context(failed)?;
    for entry in from.read_dir().with_context(failed)? {
        let entry = entry.with_context(failed)?;
        let (path, copy) = (entry.path(), to.join(entry.file_name()));
        if !path.is_dir() {
            fs::copy(&path, &copy).with_context(failed)?;
        } else if entry.file_name() != "target" {
            copy_folder(&path, &copy)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_the_path_of_reflet_changes() {
        let manifest = "[dependencies]\nheapless = \"0.9\"\n\
            reflet = { path = \"../..\", features = [\"scenes\"] }\n\
            other = { path = \"../../other\" }\n";
        let expected = "[dependencies]\nheapless = \"0.9\"\n\
            reflet = { path = \"/there\", features = [\"scenes\"] }\n\
            other = { path = \"../../other\" }\n";
        assert_eq!(with_reflet_in(manifest, "/there"), expected);
    }

    #[test]
    fn copy_has_every_file_but_what_was_built() {
        let place = tempfile::tempdir().unwrap();
        let (from, to) = (place.path().join("from"), place.path().join("to"));
        for folder in ["src", ".cargo", "target"] {
            fs::create_dir_all(from.join(folder)).unwrap();
            fs::write(from.join(folder).join("file"), folder).unwrap();
        }
        fs::write(from.join("Cargo.toml"), "path = \"../..\"").unwrap();
        copy_example(&from, &to).unwrap();
        for folder in ["src", ".cargo"] {
            let copied = fs::read_to_string(to.join(folder).join("file"));
            assert_eq!(copied.unwrap(), folder);
        }
        assert!(!to.join("target").exists());
        let manifest = fs::read_to_string(to.join("Cargo.toml")).unwrap();
        assert_eq!(manifest, format!("path = \"{}\"", root().display()));
    }
}
