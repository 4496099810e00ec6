//! `cargo xtask scene`: a scene file as the Rust source of a constant scene.
//!
//! The numbers are the file's own, to the last digit, and what the library would refuse is
//! refused before a line is written. [`names`] makes identifiers of the file's names, [`write`]
//! writes the source, rustfmt lays it out.

mod names;
mod write;

use std::{fs, io::Write as _, path::Path};

use anyhow::{Context, Result};
use reflet::host::file::SceneFile;
use serde_json::Value;

use crate::{command::Program, misuse::Misuse};

#[derive(Clone, Debug)]
pub struct Source {
    pub name: String,
    pub type_name: String,
    /// The source, as rustfmt lays it out.
    pub text: String,
}

/// Prints the source of the file's scene, or of the one called `chosen`.
pub fn run(path: &Path, chosen: Option<&str>) -> Result<()> {
    let (_, source) = read(path, chosen)?;
    std::io::stdout().write_all(source.text.as_bytes())?;
    Ok(())
}

/// Reads the file's scene, or the one called `chosen`, and writes its source.
///
/// # Errors
/// [`Misuse`] where the file cannot be used.
pub fn read(path: &Path, chosen: Option<&str>) -> Result<(SceneFile, Source)> {
    let file = SceneFile::read(path, chosen).map_err(Misuse::new)?;
    let text = fs::read_to_string(path).map_err(Misuse::new)?;
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    let source = source(&file, &text, &stem.to_string_lossy())?;
    Ok((file, source))
}

/// Writes the source of a scene that is given as the text of a file.
///
/// # Errors
/// [`Misuse`] where the text cannot be used.
pub fn parse(text: &str) -> Result<(SceneFile, Source)> {
    let file = SceneFile::parse(text, None).map_err(Misuse::new)?;
    let source = source(&file, text, "scene")?;
    Ok((file, source))
}

/// The source of the scene that was read from `text`; `unnamed` is what a scene without a name is
/// called.
fn source(file: &SceneFile, text: &str, unnamed: &str) -> Result<Source> {
    file.build().map_err(Misuse::new)?;
    let name = file.name().unwrap_or(unnamed).to_owned();
    let (scene, camera) = file.reference();
    let type_name = names::type_name(&name);
    let materials = names::constants(&material_names(text, file.name())?, &type_name);
    let text = write::source(&name, &type_name, &materials, &scene, &camera);
    let text = laid_out(&text)?;
    Ok(Source {
        name,
        type_name,
        text,
    })
}

/// The names of the materials, which the library does not keep. The text has been read without
/// an error before.
fn material_names(text: &str, scene: Option<&str>) -> Result<Vec<String>> {
    let document: Value = serde_json::from_str(text.trim_start_matches('\u{feff}'))?;
    let scenes = match document {
        Value::Array(scenes) => scenes,
        scene => vec![scene],
    };
    let is_meant = |document: &&Value| scene.is_none() || document["name"].as_str() == scene;
    let meant = scenes.iter().find(is_meant);
    let materials = meant.and_then(|scene| scene["materials"].as_array());
    let name = |material: &Value| material["name"].as_str().unwrap_or_default().to_owned();
    Ok(materials.into_iter().flatten().map(name).collect())
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
