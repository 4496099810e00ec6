//! Finds the scenes that the command line names: built-in scenes, scene files, and folders of them.

use std::fs;
use std::path::{Path, PathBuf};

use command_line::{Chosen, Failure, Source, shown};
use lost::case::Case;

/// Opens all named scenes. A folder stands for its files that end in `.json`, sorted by name.
///
/// # Errors
///
/// A scene does not exist or is not one; a folder has no scene file.
pub fn cases(paths: &[PathBuf], chosen: &Chosen, reflections: u8) -> Result<Vec<Case>, Failure> {
    let mut cases = Vec::new();
    for path in paths {
        if !path.is_dir() {
            cases.push(case(path, chosen, reflections)?);
            continue;
        }
        let files = files(path)?;
        if files.is_empty() {
            return Err(format!("there is no file *.json in {}", shown(path)).into());
        }
        for file in files {
            cases.push(case(&file, chosen, reflections)?);
        }
    }
    Ok(cases)
}

fn files(folder: &Path) -> Result<Vec<PathBuf>, Failure> {
    let unreadable = |error| format!("{} cannot be read: {error}", shown(folder));
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        if path.extension().is_some_and(|it| it == "json") {
            files.push(path);
        }
    }
    files.sort();
    Ok(files)
}

fn case(path: &Path, chosen: &Chosen, reflections: u8) -> Result<Case, Failure> {
    let source = Source::open(path, chosen)?;
    let (scene, camera) = source.reference();
    // The names inside scene files are often the same.
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    let name = match chosen.name {
        Some(_) => source.name().to_owned(),
        None => stem.to_string_lossy().into_owned(),
    };
    Ok(Case {
        name,
        scene,
        camera,
        reflections,
    })
}
