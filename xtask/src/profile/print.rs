//! Prints the counted instructions as tables.

use std::fmt::{Result, Write};

use super::stages::STAGES;
use super::sums::{Sums, Table};

/// The tables of functions: title, and name of the second figure of a row, if it has one.
const TABLES: [(Table, &str, Option<&str>); 4] = [
    (
        Table::Library,
        "functions of the library, with the foreign ones in them, and with all that they call",
        Some("all"),
    ),
    (Table::Innermost, "innermost functions", None),
    (
        Table::Lines,
        "lines of the library, with the foreign functions in them",
        None,
    ),
    (
        Table::Linked,
        "functions as they are linked, and how often they are called",
        Some("calls"),
    ),
];

/// Returns the table of the stages and, if `rows` is given, the tables of the hottest functions,
/// each with at most this many rows.
pub fn tables(sums: &Sums, pixels: u64, rows: Option<usize>) -> String {
    let mut text = String::new();
    write_all(&mut text, sums, pixels, rows).expect("a string takes all");
    text
}

fn write_all(text: &mut String, sums: &Sums, pixels: u64, rows: Option<usize>) -> Result {
    writeln!(text, "{:<12}{:>12}{:>8}", "stage", "instr/pixel", "share")?;
    let stages = STAGES.map(|stage| (stage.name(), sums.stage(stage)));
    let total = [("total".to_owned(), sums.total())];
    for (name, count) in stages.into_iter().chain(total) {
        let (count, share) = (per(count, pixels), 100.0 * per(count, sums.total()));
        writeln!(text, "{name:<12}{count:>12.1}{share:>7.1}%")?;
    }
    for (table, title, second) in TABLES {
        if let Some(most) = rows {
            writeln!(text, "\n{title}")?;
            write_rows(text, sums, table, second, (pixels, most))?;
        }
    }
    Ok(())
}

/// Writes the rows with the most instructions, largest first. Equal rows are sorted by stage and name,
/// so that the order is always the same.
fn write_rows(
    text: &mut String,
    sums: &Sums,
    table: Table,
    second: Option<&str>,
    (pixels, most): (u64, usize),
) -> Result {
    let rows = sums.rows(table).filter(|(_, _, row)| row.own > 0);
    let mut rows: Vec<_> = rows.collect();
    rows.sort_unstable_by_key(|&(stage, name, row)| (std::cmp::Reverse(row.own), stage, name));
    let has_stages = rows.first().is_some_and(|(stage, ..)| stage.is_some());
    write!(text, "{:>11}{:>8}", "own/pixel", "share")?;
    if let Some(name) = second {
        write!(text, "{:>13}", format!("{name}/pixel"))?;
    }
    let stage = if has_stages { "  stage      " } else { "" };
    writeln!(text, "{stage}  name")?;
    for (stage, name, row) in rows.into_iter().take(most) {
        let (own, share) = (per(row.own, pixels), 100.0 * per(row.own, sums.total()));
        write!(text, "{own:>11.2}{share:>7.1}%")?;
        if second.is_some() {
            write!(text, "{:>13.2}", per(row.second, pixels))?;
        }
        if let Some(stage) = stage {
            write!(text, "  {:<11}", stage.name())?;
        }
        writeln!(text, "  {name}")?;
    }
    Ok(())
}

fn per(count: u64, whole: u64) -> f64 {
    count as f64 / whole as f64
}
