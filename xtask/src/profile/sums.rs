//! Adds up the executed instructions, by stage and by function.

use std::collections::HashMap;

use super::names::Names;
use super::record::Record;
use super::stages::{Rule, STAGES, Stage, path, stage};

#[derive(Debug, Default)]
pub struct Sums {
    stages: HashMap<Stage, u64>,
    /// Instructions of each library function, with foreign functions inlined in it or called by it.
    pub(super) library: HashMap<(Stage, String), Library>,
    /// Instructions of each innermost function after inlining.
    pub(super) innermost: HashMap<(Stage, String), u64>,
    /// Instructions of each source line of the library, with foreign functions inlined in it or
    /// called by it.
    pub(super) lines: HashMap<(Stage, String), u64>,
    /// Instructions and calls of each linked function.
    pub(super) linked: HashMap<String, Linked>,
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Library {
    pub own: u64,
    /// Own instructions and those of all functions that it calls.
    pub all: u64,
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Linked {
    pub own: u64,
    pub calls: u64,
}

impl Sums {
    pub fn stage(&self, stage: Stage) -> u64 {
        self.stages.get(&stage).copied().unwrap_or(0)
    }

    pub fn total(&self) -> u64 {
        STAGES.iter().map(|&stage| self.stage(stage)).sum()
    }

    pub(super) fn of(record: &Record, names: &Names) -> Self {
        let mut sums = Self::default();
        for (way, ray, address, count) in record.all() {
            let frames = record.frames(way, address);
            let rules = frames.iter().filter_map(|frame| Rule::of(&frame.name));
            let stage = stage(rules, ray);
            *sums.stages.entry(stage).or_default() += count;
            let innermost = frames.first().map(|frame| frame.name.clone());
            let innermost = innermost.unwrap_or_else(|| format!("{address:#x}"));
            *sums.innermost.entry((stage, innermost)).or_default() += count;
            let linked = names.function(address).map(|(_, name)| name);
            let linked = linked.unwrap_or("no function").to_owned();
            sums.linked.entry(linked).or_default().own += count;
            let library = frames.iter().filter(|frame| is_of_library(&frame.name));
            let mut seen = Vec::new();
            for frame in library {
                let row = sums.library.entry((stage, frame.name.clone()));
                let row = row.or_default();
                if seen.is_empty() {
                    row.own += count;
                    let line = frame.line.clone();
                    let line = line.unwrap_or_else(|| format!("no line in {}", frame.name));
                    *sums.lines.entry((stage, line)).or_default() += count;
                }
                // A closure may occur again inside its own function.
                if !seen.contains(&&frame.name) {
                    row.all += count;
                    seen.push(&frame.name);
                }
            }
        }
        for (call, count) in record.calls.all() {
            if let Some((_, name)) = names.function(call.callee) {
                sums.linked.entry(name.to_owned()).or_default().calls += count;
            }
        }
        sums
    }
}

fn is_of_library(name: &str) -> bool {
    path(name).starts_with("reflet::")
}
