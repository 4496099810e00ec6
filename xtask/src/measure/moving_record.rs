//! The kept figures of scenes in which a shape moves: `docs/measured/moving.jsonl`, and their table.

use anyhow::Result;
use serde::{Deserialize, Serialize};

use super::Size;
use super::cores::CORES;
use super::moving::{MovingFigures, measure};
use super::scene::Scene;
use super::task::{Quality, Task};
use crate::kept;
use crate::table::markdown;

const FILE: &str = "docs/measured/moving.jsonl";

const SCENES: [&str; 3] = ["castle", "mirror1", "primitives"];
pub const CORE_NAMES: [&str; 2] = ["m0", "m3"];
const SIZE: Size = Size::new(64, 64);

/// One row of the file. In JSON the keys are the names of the fields.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kept {
    core: String,
    scene: String,
    move_instructions: u64,
    prepare_instructions: u64,
    instructions_per_pixel: f64,
    constant_instructions_per_pixel: f64,
    flash: u64,
    constant_flash: u64,
    stack: u64,
}

impl From<MovingFigures> for Kept {
    fn from(figures: MovingFigures) -> Self {
        let frame = figures.frame;
        Self {
            core: frame.core,
            scene: frame.scene,
            move_instructions: figures.move_instructions,
            prepare_instructions: frame.prepare_instructions,
            instructions_per_pixel: frame.instructions_per_pixel,
            constant_instructions_per_pixel: figures.constant_instructions_per_pixel,
            flash: frame.flash,
            constant_flash: figures.constant_flash,
            stack: frame.stack,
        }
    }
}

/// Measures the moving scenes again and writes their file of kept figures.
pub fn renew() -> Result<()> {
    let mut rows = Vec::new();
    for core in CORES.iter().filter(|core| CORE_NAMES.contains(&core.name)) {
        for name in SCENES {
            let task = Task::new(core, Scene::BuiltIn(name), SIZE, Quality::FAST);
            rows.push(Kept::from(measure(&task)?));
        }
    }
    kept::write_lines(FILE, &rows)
}

pub fn read() -> Result<Vec<Kept>> {
    kept::read(FILE, "measure --all")
}

/// Formats the kept figures as a table of docs/boards.md.
pub fn table(rows: &[Kept]) -> String {
    const HEAD: [&str; 8] = [
        "core",
        "scene",
        "move",
        "preparation",
        "instr/pixel, constant",
        "instr/pixel, moving",
        "flash, constant",
        "flash, moving",
    ];
    let rows = rows.iter().map(|row| {
        let percent = 100.0 * row.flash as f64 / row.constant_flash as f64;
        vec![
            row.core.clone(),
            row.scene.clone(),
            row.move_instructions.to_string(),
            row.prepare_instructions.to_string(),
            format!("{:.0}", row.constant_instructions_per_pixel),
            format!("{:.0}", row.instructions_per_pixel),
            row.constant_flash.to_string(),
            format!("{} ({percent:.1} %)", row.flash),
        ]
    });
    markdown(2, &HEAD, rows)
}
