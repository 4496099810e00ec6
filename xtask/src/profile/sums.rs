//! Adds up the executed instructions, by stage and by function.

use std::collections::HashMap;

use super::names::{Frame, Names};
use super::record::Record;
use super::stages::{Rule, STAGES, Stage, path, stage};

#[derive(Clone, Copy, Debug)]
pub enum Table {
    /// Functions of the library, with foreign functions inlined in them or called by them.
    Library,
    /// Innermost functions after inlining.
    Innermost,
    /// Source lines of the library, with foreign functions inlined in them or called by them.
    Lines,
    /// Linked functions, whatever their stage.
    Linked,
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Row {
    pub own: u64,
    /// Of [`Table::Library`]: own instructions and those of all functions that it calls.
    /// Of [`Table::Linked`]: calls of the function. Else 0.
    pub second: u64,
}

/// Rows by their stage, if they have one, and their name.
type Rows = HashMap<(Option<Stage>, String), Row>;

#[derive(Debug, Default)]
pub struct Sums {
    stages: HashMap<Stage, u64>,
    tables: [Rows; 4],
}

impl Sums {
    pub fn stage(&self, stage: Stage) -> u64 {
        self.stages.get(&stage).copied().unwrap_or(0)
    }

    pub fn total(&self) -> u64 {
        STAGES.iter().map(|&stage| self.stage(stage)).sum()
    }

    pub fn rows(&self, table: Table) -> impl Iterator<Item = (Option<Stage>, &str, Row)> {
        let rows = self.tables[table as usize].iter();
        rows.map(|((stage, name), row)| (*stage, name.as_str(), *row))
    }

    fn row(&mut self, table: Table, stage: Option<Stage>, name: impl Into<String>) -> &mut Row {
        let rows = &mut self.tables[table as usize];
        rows.entry((stage, name.into())).or_default()
    }

    pub(super) fn of(record: &Record, names: &Names) -> Self {
        let mut sums = Self::default();
        for (way, ray, address, count) in record.all() {
            let frames = record.frames(way, address);
            let rules = frames.iter().filter_map(|frame| Rule::of(&frame.name));
            let stage = stage(rules, ray);
            *sums.stages.entry(stage).or_default() += count;
            let stage = Some(stage);
            let innermost = frames.first().map(|frame| frame.name.clone());
            let innermost = innermost.unwrap_or_else(|| format!("{address:#x}"));
            sums.row(Table::Innermost, stage, innermost).own += count;
            let linked = names.function(address).map(|(_, name)| name);
            let linked = linked.unwrap_or("no function");
            sums.row(Table::Linked, None, linked).own += count;
            let is_of_library = |it: &&&Frame| path(&it.name).starts_with("reflet::");
            let library = frames.iter().filter(is_of_library);
            let mut seen = Vec::new();
            for frame in library {
                let row = sums.row(Table::Library, stage, &frame.name);
                let is_first = seen.is_empty();
                // A closure may occur again inside its own function.
                if !seen.contains(&&frame.name) {
                    row.second += count;
                    seen.push(&frame.name);
                }
                if is_first {
                    row.own += count;
                    let line = frame.line.clone();
                    let line = line.unwrap_or_else(|| format!("no line in {}", frame.name));
                    sums.row(Table::Lines, stage, line).own += count;
                }
            }
        }
        for (call, count) in record.calls.all() {
            if let Some((_, name)) = names.function(call.callee) {
                sums.row(Table::Linked, None, name).second += count;
            }
        }
        sums
    }
}
