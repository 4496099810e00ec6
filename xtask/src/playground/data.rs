//! Gathers what the page shows beside pictures: scene files, kept figures of boards and hashes. All
//! figures come from files that commands wrote.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use command_line::{Source, scene_file};
use reflet::scenes;
use serde::Serialize;

use super::PACKAGE;
use crate::measure::{Core, frames, record};
use crate::root;

#[derive(Serialize)]
struct Data {
    scenes: Vec<Scene>,
    boards: Vec<frames::Kept>,
    hashes: BTreeMap<String, String>,
    version: String,
}

/// A scene that the page offers.
#[derive(Serialize)]
struct Scene {
    name: String,
    group: &'static str,
    json: String,
}

pub fn json() -> Result<String> {
    let mut scenes = built_in()?;
    scenes.extend(samples(&root().join("examples/scenes"))?);
    scenes.extend(samples(&root().join(PACKAGE).join("page/scenes"))?);
    Ok(serde_json::to_string(&Data {
        scenes,
        boards: frames::read()?,
        hashes: hashes()?,
        version: version()?,
    })?)
}

fn built_in() -> Result<Vec<Scene>> {
    let scene = |name: &str| {
        let source = Source::built_in(name).context("no such built-in scene")?;
        let file = format!("src/scenes/{name}.rs");
        let code = fs::read_to_string(root().join(&file)).context(file)?;
        let (scene, camera) = source.reference();
        Ok(Scene {
            name: name.to_owned(),
            group: "built in",
            json: scene_file::text(name, &scene_file::materials(&code, &scene), &scene, &camera),
        })
    };
    scenes::NAMES.into_iter().map(scene).collect()
}

/// Returns the scene files of a folder, in the order of their names.
fn samples(folder: &Path) -> Result<Vec<Scene>> {
    let entries = fs::read_dir(folder).with_context(|| format!("no {}", folder.display()))?;
    let mut files: Vec<_> = entries.flatten().map(|entry| entry.path()).collect();
    files.retain(|file| file.extension().is_some_and(|it| it == "json"));
    files.sort();
    let scene = |file: &PathBuf| {
        let stem = file.file_stem().unwrap_or_default();
        let text = fs::read_to_string(file);
        Ok(Scene {
            name: stem.to_string_lossy().into_owned(),
            group: "sample",
            json: text.with_context(|| format!("cannot read {}", file.display()))?,
        })
    };
    files.iter().map(scene).collect()
}

/// Returns the hash of each built-in scene that an emulated Cortex-M3 reported.
fn hashes() -> Result<BTreeMap<String, String>> {
    let figures = record::read(Core::find("m3").context("no such core")?)?;
    let fast = figures.into_iter().filter(|it| it.quality == "fast");
    Ok(fast.map(|it| (it.scene, it.hash)).collect())
}

fn version() -> Result<String> {
    let manifest = fs::read_to_string(root().join("Cargo.toml"))?;
    let mut lines = manifest.lines();
    let version = lines.find_map(|line| line.strip_prefix("version = \"")?.strip_suffix('"'));
    let version = version.context("no version in Cargo.toml")?;
    Ok(version.to_owned())
}

#[cfg(test)]
mod tests {
    use command_line::{Quality, Settings};
    use embedded_graphics::geometry::Size;
    use frame_hash::FrameHash;
    use reflet::host::file::SceneFile;

    use super::*;

    #[test]
    fn built_in_scenes_draw_the_hashes_of_the_boards_when_their_files_are_read() {
        let (scenes, hashes) = (built_in().unwrap(), hashes().unwrap());
        assert_eq!(scenes.len(), hashes.len());
        for Scene { name, json, .. } in scenes {
            let file = SceneFile::parse(&json, None).unwrap();
            assert_eq!(file.name(), Some(&*name));
            let (scene, camera) = file.reference();
            let source = Source::described(name.clone(), scene, camera).unwrap();
            let settings = Settings::blinn_phong(Quality::Fast, 4);
            let hash = FrameHash::of(source.drawn(Size::new(64, 64), settings).pixels);
            assert_eq!(format!("{hash:016x}"), hashes[&name], "{name}");
        }
    }

    #[test]
    fn materials_of_built_in_scenes_have_the_names_of_their_source() {
        for Scene { name, json, .. } in built_in().unwrap() {
            assert!(!json.contains("material 1"), "{name}: {json}");
        }
    }
}
