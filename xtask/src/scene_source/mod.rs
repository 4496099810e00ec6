//! `cargo xtask scene`: a scene file as the Rust source of a constant scene.
//!
//! The numbers are the file's own, to the last digit, and what the library would refuse is
//! refused before a line is written. [`names`] makes identifiers of the file's names, [`write`]
//! writes the source, rustfmt lays it out.

mod names;
mod write;

use std::{fs, path::Path};

use anyhow::{Context, Result};
use command_line::{Chosen, with_advice};
use reflet::host::file::SceneFile;

use crate::{command::Program, misuse::Misuse, print};

#[derive(Clone, Debug)]
pub struct Source {
    pub name: String,
    pub type_name: String,
    /// The source, as rustfmt lays it out.
    pub text: String,
}

/// Prints the source of the file's scene, or of the one called `chosen`.
pub fn run(path: &Path, chosen: &Chosen) -> Result<()> {
    let (_, source) = read(path, chosen)?;
    print(source.text)
}

/// Reads the file's scene, or the one called `chosen`, and writes its source.
///
/// # Errors
/// [`Misuse`] where the file cannot be used.
pub fn read(path: &Path, chosen: &Chosen) -> Result<(SceneFile, Source)> {
    let file = SceneFile::read(path, chosen.name.as_deref())
        .map_err(|error| Misuse::new(with_advice(error)))?;
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    let source = source(&file, &stem.to_string_lossy())?;
    Ok((file, source))
}

/// Writes the source of a scene that is given as the text of a file.
///
/// # Errors
/// [`Misuse`] where the text cannot be used.
pub fn parse(text: &str) -> Result<(SceneFile, Source)> {
    let file = SceneFile::parse(text, None).map_err(Misuse::new)?;
    let source = source(&file, "scene")?;
    Ok((file, source))
}

/// The source of the file's scene; `unnamed` is what a scene without a name is called.
fn source(file: &SceneFile, unnamed: &str) -> Result<Source> {
    file.build().map_err(Misuse::new)?;
    let name = file.name().unwrap_or(unnamed).to_owned();
    let (scene, camera) = file.reference();
    let type_name = names::type_name(&name);
    let materials = names::constants(file.materials(), &type_name);
    let text = write::source(&name, &type_name, &materials, &scene, &camera);
    let text = laid_out(&text)?;
    Ok(Source {
        name,
        type_name,
        text,
    })
}

/// The text as rustfmt's defaults have it.
fn laid_out(text: &str) -> Result<String> {
    let folder = tempfile::tempdir()?;
    let file = folder.path().join("scene.rs");
    fs::write(&file, text)?;
    // A folder of its own holds no configuration, and edition 2024 is what reflet is written in.
    Program::new("rustfmt")
        .args(["--edition", "2024"])
        .args([&file])
        .read()
        .context("the source is laid out by rustfmt: `cargo xtask setup` gets it")?;
    Ok(fs::read_to_string(&file)?)
}
