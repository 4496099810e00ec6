//! Reads and writes the files that chores generate and the repository keeps.

use std::{fs, path::Path};

use anyhow::{Context, Result, bail};
use serde::{Serialize, de::DeserializeOwned};

use crate::root;

/// Reads a file of JSON lines in the repository, one value a line. `command` is the chore that writes the
/// file; the error names it.
pub fn read<T: DeserializeOwned>(file: &str, command: &str) -> Result<Vec<T>> {
    let file = root().join(file);
    let name = file.display();
    let Ok(text) = fs::read_to_string(&file) else {
        bail!("there is no {name}: `cargo xtask {command}` writes it");
    };
    let values = text.lines().map(serde_json::from_str);
    let values: Result<_, _> = values.collect();
    values.with_context(|| format!("{name} is not what the command writes"))
}

/// Writes a file of JSON lines in the repository, one value a line.
pub fn write_lines<T: Serialize>(file: &str, values: &[T]) -> Result<()> {
    let lines = values
        .iter()
        .map(|it| Ok(serde_json::to_string(it)? + "\n"));
    write(&root().join(file), &lines.collect::<Result<String>>()?)
}

pub fn write(file: &Path, text: &str) -> Result<()> {
    let name = file.display();
    fs::create_dir_all(file.parent().unwrap_or(file))
        .and_then(|()| fs::write(file, text))
        .with_context(|| format!("cannot write {name}"))?;
    println!("{name}");
    Ok(())
}
