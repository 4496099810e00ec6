//! Writes the files of a report. Measures nothing.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use command_line::shown;
use xtask::measure::words;

use crate::arguments::Arguments;
use crate::page::{Page, Section};
use crate::point::front;
use crate::scene::Measured;
use crate::{front as source, plot, table};

pub fn make(folder: &Path) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| format!("--out {} cannot be made", folder.display()))
}

pub fn all(arguments: &Arguments, scenes: &[Measured]) -> Result<()> {
    let write = |name: &str, text: &str| {
        let path = arguments.out.join(name);
        fs::write(&path, text).with_context(|| format!("{} cannot be written", path.display()))
    };
    let size = words(arguments.size);
    let table = table::csv(arguments.core.name, &size, scenes)?;
    write("points.csv", &table)?;
    write("front.rs", &source::source(&arguments.command(), scenes))?;
    let mut sections = Vec::new();
    for scene in scenes {
        let file = format!("{}-psnr.svg", file_name(&scene.name));
        write(&file, &plot::scene(scene)?)?;
        let front = front(&scene.points);
        sections.push(Section { scene, file, front });
    }
    let page = Page {
        arguments,
        sections,
    };
    write("index.md", &page.markdown())?;
    println!("{}", shown(&arguments.out.join("index.md")));
    Ok(())
}

pub fn file_name(scene: &str) -> String {
    let safe = |letter: char| {
        if letter.is_alphanumeric() || "-_".contains(letter) { letter } else { '_' }
    };
    scene.chars().map(safe).take(50).collect()
}
