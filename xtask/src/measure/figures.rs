//! What a measurement comes to, for people and for programs.

use anyhow::{Context, Result};
use command_line::one_line;
use serde::{Deserialize, Serialize};

use super::{Weight, outcome::Outcome, pixels, task::Task, words};
use crate::table::{cell, rounded};

/// The figures of one measurement: one row of a table. In JSON the keys are the names of the fields.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    pub core: String,
    pub scene: String,
    pub size: String,
    pub reflections: u8,
    pub shading: String,
    pub quality: String,
    /// Executed instructions of the whole frame, preparation included, over its pixels.
    pub instructions_per_pixel: f64,
    pub prepare_instructions: u64,
    pub worst_row_instructions: u64,
    /// Number of the row that took the most instructions, from 0 at the top.
    pub worst_row: u32,
    /// Bytes of code and constants that belong to the library and the scene.
    pub flash: u64,
    /// Bytes of static variables that belong to the library and the scene.
    pub ram: u64,
    /// Most bytes of stack in use at a time.
    pub stack: u64,
    /// FNV-1a, 64 bits, of the frame's RGB8 bytes.
    pub hash: String,
    /// An estimate, for memory as fast as the core; `None` where no timings are published.
    pub cycles_per_pixel: Option<f64>,
}

impl Figures {
    pub(super) fn new(task: &Task, outcome: &Outcome, weight: Weight) -> Self {
        let settings = task.settings;
        let (worst_row, worst_row_instructions) = outcome.worst_row;
        Self {
            core: task.core.name.to_owned(),
            scene: task.scene.name().to_owned(),
            size: words(settings.size),
            reflections: settings.reflections,
            shading: settings.shading.name().to_owned(),
            quality: settings.quality.name().to_owned(),
            instructions_per_pixel: per_pixel(task, outcome),
            prepare_instructions: outcome.prepare,
            worst_row_instructions,
            worst_row,
            flash: weight.flash,
            ram: weight.ram,
            stack: outcome.stack,
            hash: format!("{:016x}", outcome.hash),
            cycles_per_pixel: None,
        }
    }

    pub fn json(&self) -> Result<String> {
        serde_json::to_string(self).context("figures are plain")
    }
}

pub(super) fn per_pixel(task: &Task, outcome: &Outcome) -> f64 {
    let instructions = outcome.instructions() as f64;
    rounded(instructions / pixels(task.settings.size) as f64, 1)
}

pub fn table(rows: &[Figures]) -> String {
    let head = "core scene size refl. shading quality instr/pixel prepare worst-row at-row flash RAM \
                stack hash cycles/pixel";
    let mut cells = vec![head.split(' ').map(str::to_owned).collect()];
    cells.extend(rows.iter().map(|row| {
        vec![
            row.core.clone(),
            one_line(&row.scene),
            row.size.clone(),
            row.reflections.to_string(),
            row.shading.clone(),
            row.quality.clone(),
            format!("{:.1}", row.instructions_per_pixel),
            row.prepare_instructions.to_string(),
            row.worst_row_instructions.to_string(),
            row.worst_row.to_string(),
            row.flash.to_string(),
            row.ram.to_string(),
            row.stack.to_string(),
            row.hash.clone(),
            cell(row.cycles_per_pixel.map(|it| format!("{it:.0}"))),
        ]
    }));
    aligned(&cells)
}

/// Columns as wide as their widest cell; numbers to the right.
pub(super) fn aligned(rows: &[Vec<String>]) -> String {
    let width = |column: usize| {
        let cells = rows.iter().map(|row| row[column].chars().count());
        cells.max().unwrap_or(0)
    };
    let widths: Vec<_> = (0..rows[0].len()).map(width).collect();
    let is_number = |column: usize| {
        let mut cells = rows.iter().skip(1).map(|row| &row[column]);
        cells.all(|cell| cell.parse::<f64>().is_ok())
    };
    let lines = rows.iter().map(|row| {
        let cells = row.iter().enumerate().map(|(column, cell)| {
            let width = widths[column];
            if is_number(column) {
                format!("{cell:>width$}")
            } else {
                format!("{cell:<width$}")
            }
        });
        cells.collect::<Vec<_>>().join("  ").trim_end().to_owned()
    });
    lines.collect::<Vec<_>>().join("\n")
}
