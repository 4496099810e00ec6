//! `cargo xtask measure --profiles`: what a frame takes in several build profiles.
//!
//! The figures are lines in `docs/measured/profiles.jsonl`. The tables in `docs/sizes.md` and
//! `src/lib.rs` are made of them.

use std::{fs, path::PathBuf};

use anyhow::{Context, Result, ensure};
use serde::{Deserialize, Serialize};

use super::build_profile::PROFILES;
use super::{Core, Figures, Quality, Scene, Size, Task, count};
use crate::table::{markdown, row, with_table};
use crate::{kept, root};

const FILE: &str = "docs/measured/profiles.jsonl";

/// Scenes from which build profiles are measured: a large one and a small one.
const SCENES: [&str; 2] = ["castle", "corner1"];

/// Size of the pictures from which build profiles are measured: as in docs/boards.md.
const SIZE: Size = Size::new(64, 64);

/// One line of the file: what a scene takes in a build profile. In JSON the keys are the names of the fields.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Row {
    pub profile: String,
    #[serde(flatten)]
    pub figures: Figures,
}

/// Measures every profile again and writes all that is made of the figures.
pub fn renew() -> Result<()> {
    let mut rows = Vec::new();
    for task in tasks() {
        let (profile, figures) = (task.profile.name.to_owned(), count(&task)?);
        println!(
            "{profile:<46} {:<8} {:>10.1} instructions a pixel, {:>7} bytes of flash",
            figures.scene, figures.instructions_per_pixel, figures.flash
        );
        rows.push(Row { profile, figures });
    }
    ensure!(draw_the_same(&rows), "profiles draw different pictures");
    kept::write_lines(FILE, &rows)?;
    for (name, prefix, table) in pages(&rows) {
        let old = fs::read_to_string(file(name)).with_context(|| format!("cannot read {name}"))?;
        let new = with_table(&old, prefix, &table)
            .with_context(|| format!("{name} has no table of profiles"))?;
        // What says the same is left alone: the library would be compiled again.
        if new != old {
            kept::write(&file(name), &new)?;
        }
    }
    Ok(())
}

/// Returns the tables of the figures: the file in which each stands, what its lines begin with there, and
/// the table.
fn pages(rows: &[Row]) -> [(&'static str, &'static str, String); 2] {
    [
        ("docs/sizes.md", "", long(rows)),
        ("src/lib.rs", "//! ", short(rows)),
    ]
}

/// What is measured: every scene in the first profile, then in the second, and so on.
pub fn tasks() -> Vec<Task> {
    let with = |profile, scene| {
        let mut task = Task::new(Core::M3, Scene::BuiltIn(scene), SIZE, Quality::FAST);
        task.profile = profile;
        task
    };
    let tasks = PROFILES.iter();
    let tasks = tasks.flat_map(|profile| SCENES.map(|scene| with(profile, scene)));
    tasks.collect()
}

/// The rows that the repository keeps, in the order of [`tasks`].
pub fn read() -> Result<Vec<Row>> {
    kept::read(FILE, "measure --profiles")
}

fn file(name: &str) -> PathBuf {
    root().join(name)
}

/// Whether each scene has one picture in all profiles.
fn draw_the_same(rows: &[Row]) -> bool {
    let first = &rows[..SCENES.len()];
    let mut profiles = rows.chunks(SCENES.len());
    profiles.all(|rows| {
        rows.iter()
            .zip(first)
            .all(|(row, first)| row.figures.hash == first.figures.hash)
    })
}

/// Returns the table of src/lib.rs: flash and instructions a pixel of each scene.
fn short(rows: &[Row]) -> String {
    let cells = |it: &Figures| [it.flash.to_string(), whole(it.instructions_per_pixel)];
    table(rows, ["flash", "instr/pixel"], cells)
}

/// Returns the table of docs/sizes.md, which also has the stack.
pub fn long(rows: &[Row]) -> String {
    let cells = |it: &Figures| {
        let instructions = whole(it.instructions_per_pixel);
        [it.flash.to_string(), instructions, it.stack.to_string()]
    };
    table(rows, ["flash", "instr/pixel", "stack"], cells)
}

/// Formats a table with a row for each build profile. `cells` makes the columns of one scene.
fn table<const N: usize>(
    rows: &[Row],
    names: [&str; N],
    cells: impl Fn(&Figures) -> [String; N],
) -> String {
    let columns = SCENES.map(|scene| names.map(|name| format!("{scene} {name}")));
    let head = row("profile", columns.into_iter().flatten());
    let lines = rows.chunks(SCENES.len());
    let cells = |row: &Row| cells(&row.figures);
    let lines = lines.map(|scenes| row(&scenes[0].profile, scenes.iter().flat_map(cells)));
    markdown(1, &head, lines)
}

fn whole(number: f64) -> String {
    format!("{number:.0}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the rows of two profiles that do not exist, with figures that are easy to read.
    fn rows() -> Vec<Row> {
        let mut rows = read().unwrap();
        rows.truncate(2 * SCENES.len());
        for (index, Row { profile, figures }) in rows.iter_mut().enumerate() {
            let (name, instructions) = [("one", 100.0), ("other", 250.0)][index / SCENES.len()];
            *profile = name.to_owned();
            (figures.instructions_per_pixel, figures.flash, figures.stack) = (instructions, 7, 8);
        }
        rows
    }

    #[test]
    fn table_has_a_row_a_profile() {
        let expected = "\
| profile | castle flash | castle instr/pixel | corner1 flash | corner1 instr/pixel |
|---|--:|--:|--:|--:|
| one | 7 | 100 | 7 | 100 |
| other | 7 | 250 | 7 | 250 |
";
        assert_eq!(short(&rows()), expected);
        let line = "| other | 7 | 250 | 8 | 7 | 250 | 8 |";
        assert!(long(&rows()).contains(line));
    }

    #[test]
    fn pages_have_the_kept_figures() {
        for (name, prefix, table) in pages(&read().unwrap()) {
            let page = fs::read_to_string(file(name)).unwrap();
            assert_eq!(with_table(&page, prefix, &table), Some(page), "{name}");
        }
    }

    #[test]
    fn profile_that_draws_another_picture_is_noticed() {
        let mut rows = rows();
        assert!(draw_the_same(&rows));
        rows[3].figures.hash.clear();
        assert!(!draw_the_same(&rows));
    }
}
