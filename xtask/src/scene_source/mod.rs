//! `cargo xtask scene`: converts a scene file to the Rust source of a constant scene.
//!
//! The numbers are those of the file, to the last digit. A scene that the library would refuse is
//! refused before anything is written. The library writes the source
//! ([`reflet::host::file::RustSource`]), [`moving`] chooses a shape that moves, and rustfmt lays it out.

pub(crate) mod moving;

use std::{fs, path::Path};

use anyhow::{Context, Result};
use command_line::{Chosen, with_advice};
use reflet::host::{
    file::{RustSource, SceneFile},
    reference,
};

use self::moving::Moving;

use crate::{command::Program, misuse::Misuse, need, print};

#[derive(Clone, Debug)]
pub struct Source {
    pub name: String,
    pub type_name: String,
    /// The source, formatted by rustfmt.
    pub text: String,
}

impl Source {
    fn new(name: &str, source: &RustSource) -> Result<Self> {
        Ok(Self {
            name: name.to_owned(),
            type_name: source.type_name(),
            text: laid_out(&source.text())?,
        })
    }
}

/// Prints the source of the file's scene, or of its scene with the name `chosen`.
pub fn run(path: &Path, chosen: &Chosen) -> Result<()> {
    let (_, source) = read(path, chosen)?;
    print(source.text)
}

/// Reads the file's scene, or its scene with the name `chosen`, and returns it with its source.
///
/// # Errors
/// [`Misuse`] if the file cannot be used.
pub fn read(path: &Path, chosen: &Chosen) -> Result<(SceneFile, Source)> {
    let file = SceneFile::read(path, chosen.name.as_deref())
        .map_err(|error| Misuse::new(with_advice(error)))?;
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    let source = source(&file, &stem.to_string_lossy())?;
    Ok((file, source))
}

/// Returns the scene in the text of a scene file, with its source.
///
/// # Errors
/// [`Misuse`] if the text cannot be used.
pub fn parse(text: &str) -> Result<(SceneFile, Source)> {
    let file = SceneFile::parse(text, None).map_err(Misuse::new)?;
    let source = source(&file, "scene")?;
    Ok((file, source))
}

/// Returns the source of the file's scene. `unnamed` is the name for a scene that has none.
fn source(file: &SceneFile, unnamed: &str) -> Result<Source> {
    file.build().map_err(Misuse::new)?;
    let name = file.name().unwrap_or(unnamed);
    Source::new(name, &file.rust_source().name(name))
}

/// Returns the source of a scene of which one shape moves, and that shape.
///
/// # Errors
/// [`Misuse`] if the scene has no bounded shape.
pub(crate) fn with_motion(
    name: &str,
    (scene, camera): (&reference::Scene, &reference::Camera),
) -> Result<(Source, Moving)> {
    let moving = Moving::of(scene).ok_or_else(|| {
        Misuse::new(format!(
            "nothing moves in {name}: it has no sphere, cylinder or disc"
        ))
    })?;
    let [low, high] = moving.room();
    let source = RustSource::new(name, scene, camera).motion(moving.kind, low, high);
    Ok((Source::new(name, &source)?, moving))
}

/// Formats the text with rustfmt's default settings. Installs rustfmt if it is missing.
fn laid_out(text: &str) -> Result<String> {
    need::RUSTFMT.get_if_missing()?;
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("scene.rs");
    fs::write(&file, text)?;
    // In this new folder rustfmt finds no configuration. Edition 2024 is reflet's own.
    let rustfmt = Program::new("rustfmt").args(["--edition", "2024"]);
    let done = rustfmt.args([&file]).read();
    done.context("the source is laid out by rustfmt")?;
    Ok(fs::read_to_string(&file)?)
}
