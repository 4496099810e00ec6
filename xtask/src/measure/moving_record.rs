//! The kept figures of scenes in which a shape moves: `docs/measured/moving.jsonl`, and their table.

use anyhow::Result;

use super::moving::{MovingFigures, measure};
use super::{CORES, Quality, Scene, Size, Task};
use crate::kept;
use crate::table::markdown;

const FILE: &str = "docs/measured/moving.jsonl";

const SCENES: [&str; 3] = ["castle", "mirror1", "primitives"];
pub const CORE_NAMES: [&str; 2] = ["m0", "m3"];
const SIZE: Size = Size::new(64, 64);

/// Measures the moving scenes again and writes their file of kept figures.
pub fn renew() -> Result<()> {
    let mut rows = Vec::new();
    for core in CORES.iter().filter(|core| CORE_NAMES.contains(&core.name)) {
        for name in SCENES {
            let task = Task::new(core, Scene::BuiltIn(name), SIZE, Quality::FAST);
            rows.push(measure(&task)?);
        }
    }
    kept::write_lines(FILE, &rows)
}

pub fn read() -> Result<Vec<MovingFigures>> {
    kept::read(FILE, "measure --all")
}

/// Formats the kept figures as a table of docs/boards.md.
pub fn table(rows: &[MovingFigures]) -> String {
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
        let frame = &row.frame;
        let percent = 100.0 * frame.flash as f64 / row.constant_flash as f64;
        vec![
            frame.core.clone(),
            frame.scene.clone(),
            row.move_instructions.to_string(),
            frame.prepare_instructions.to_string(),
            format!("{:.0}", row.constant_instructions_per_pixel),
            format!("{:.0}", frame.instructions_per_pixel),
            row.constant_flash.to_string(),
            format!("{} ({percent:.1} %)", frame.flash),
        ]
    });
    markdown(2, &HEAD, rows)
}
