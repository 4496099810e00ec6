//! Prints the counted instructions as tables for people, or as lines of JSON for programs.

use std::{collections::HashMap, fmt::Write as _};

use serde_json::{Value, json};

use super::stages::{STAGES, Stage};
use super::sums::Sums;

/// Returns the table of the stages and, if `rows` is given, the tables of the hottest functions,
/// each with at most this many rows.
pub fn tables(sums: &Sums, pixels: u64, rows: Option<usize>) -> String {
    let total = sums.total();
    let mut text = format!("{:<12}{:>12}{:>8}\n", "stage", "instr/pixel", "share");
    for (name, count) in stages(sums) {
        let (count, share) = (per(count, pixels), 100.0 * per(count, total));
        writeln!(text, "{name:<12}{count:>12.1}{share:>7.1}%").expect("a string takes all");
    }
    for table in rows.into_iter().flat_map(|rows| functions(sums, rows)) {
        table
            .print(&mut text, pixels, total)
            .expect("a string takes all");
    }
    text
}

pub fn json(sums: &Sums, pixels: u64, rows: Option<usize>) -> String {
    let total = sums.total();
    let figures = |count| {
        json!({
            "instructions": count,
            "instructions_per_pixel": per(count, pixels),
            "share": per(count, total),
        })
    };
    let stages = stages(sums).map(|(name, count)| {
        let mut line = figures(count);
        line["stage"] = name.into();
        line
    });
    let tables = rows.into_iter().flat_map(|rows| functions(sums, rows));
    let functions = tables.flat_map(|table| {
        let (key, second) = (table.key, table.second);
        table.rows.into_iter().map(move |row| {
            let mut line = figures(row.own);
            line["table"] = key.into();
            line["name"] = row.name.into();
            if let Some(stage) = row.stage {
                line["stage"] = stage.name().into();
            }
            if let Some(name) = second {
                line[format!("{name}_per_pixel")] = per(row.second, pixels).into();
            }
            line
        })
    });
    let lines = stages.chain(functions);
    lines.map(|line: Value| format!("{line}\n")).collect()
}

fn stages(sums: &Sums) -> impl Iterator<Item = (String, u64)> {
    let stages = STAGES.map(|stage| (stage.name(), sums.stage(stage)));
    stages
        .into_iter()
        .chain([("total".to_owned(), sums.total())])
}

struct Table {
    key: &'static str,
    title: &'static str,
    /// Name of the second number of a row, next to its own instructions: `all` or `calls`.
    second: Option<&'static str>,
    rows: Vec<Row>,
}

struct Row {
    stage: Option<Stage>,
    name: String,
    own: u64,
    second: u64,
}

impl Table {
    fn print(&self, text: &mut String, pixels: u64, total: u64) -> std::fmt::Result {
        let second = self.second.map(|name| format!("{name}/pixel"));
        let second = second.map_or(String::new(), |name| format!("{name:>13}"));
        writeln!(text, "\n{}", self.title)?;
        let stage = match self.rows.first().and_then(|row| row.stage) {
            Some(_) => format!("  {:<11}", "stage"),
            None => String::new(),
        };
        let head = "own/pixel";
        writeln!(text, "{head:>11}{:>8}{second}{stage}  name", "share")?;
        for row in &self.rows {
            let (own, share) = (per(row.own, pixels), 100.0 * per(row.own, total));
            write!(text, "{own:>11.2}{share:>7.1}%")?;
            if self.second.is_some() {
                write!(text, "{:>13.2}", per(row.second, pixels))?;
            }
            if let Some(stage) = row.stage {
                write!(text, "  {:<11}", stage.name())?;
            }
            writeln!(text, "  {}", row.name)?;
        }
        Ok(())
    }
}

fn functions(sums: &Sums, rows: usize) -> [Table; 4] {
    let row = |stage, name: &str, own, second| Row {
        stage,
        name: name.to_owned(),
        own,
        second,
    };
    let plain = |counts: &HashMap<(Stage, String), u64>| {
        let rows = counts.iter();
        rows.map(|((stage, name), &own)| row(Some(*stage), name, own, 0))
            .collect()
    };
    let library = sums.library.iter();
    let library = library.map(|((stage, name), it)| row(Some(*stage), name, it.own, it.all));
    let linked = sums.linked.iter();
    let linked = linked.map(|(name, it)| row(None, name, it.own, it.calls));
    let table = |key, title, second, all: Vec<Row>| Table {
        key,
        title,
        second,
        rows: hottest(all, rows),
    };
    [
        table(
            "library",
            "functions of the library, with the foreign ones in them, and with all that they call",
            Some("all"),
            library.collect(),
        ),
        table(
            "innermost",
            "innermost functions",
            None,
            plain(&sums.innermost),
        ),
        table(
            "line",
            "lines of the library, with the foreign functions in them",
            None,
            plain(&sums.lines),
        ),
        table(
            "linked",
            "functions as they are linked, and how often they are called",
            Some("calls"),
            linked.collect(),
        ),
    ]
}

/// Returns the `count` rows with the most instructions, largest first. Equal rows are sorted by
/// stage and name, so that the order is always the same.
fn hottest(mut rows: Vec<Row>, count: usize) -> Vec<Row> {
    rows.retain(|row| row.own > 0);
    rows.sort_unstable_by(|a, b| {
        let names = || (a.stage, &a.name).cmp(&(b.stage, &b.name));
        b.own.cmp(&a.own).then_with(names)
    });
    rows.truncate(count);
    rows
}

fn per(count: u64, whole: u64) -> f64 {
    count as f64 / whole as f64
}
