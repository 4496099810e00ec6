//! What a unit of work costs: the difference of two small measurements, over the units that one has more than the
//! other. The figures of the M3 are kept in `docs/measured/units.jsonl` and shown in docs/internals/units.md.

use std::path::PathBuf;

use anyhow::{Context, Error, Result, ensure};
use clap::ValueEnum;
use command_line::{Chosen, Quality as Fixed, Settings, Source, size};
use serde::{Deserialize, Serialize};

use super::figures::aligned;
use super::{CORES, Core, Quality, Scene, Size, Task, outcome};
use crate::table::{filled, markdown, rounded, row};
use crate::{kept, print, root};

const FILE: &str = "docs/measured/units.jsonl";

/// A unit of work, and how its cost is measured.
#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Unit {
    name: String,
    /// What is measured, in words.
    how: String,
    /// The picture that has `count` units more than the other.
    more: Shot,
    less: Shot,
    count: u32,
    /// Number of rays that `more` follows beyond `less`.
    rays: u64,
    /// The units that each of these contains: how many, and which. Their costs are subtracted.
    without: Vec<(u32, String)>,
}

/// A small picture: a scene of `units/scenes.json`, quality, size and number of reflections.
#[derive(Deserialize)]
struct Shot(String, String, String, u8);

impl Shot {
    fn chosen(&self) -> Chosen {
        let name = Some(self.0.clone());
        Chosen { name }
    }

    fn quality(&self) -> Result<Fixed> {
        Fixed::from_str(&self.1, false).map_err(Error::msg)
    }

    fn size(&self) -> Result<Size> {
        size(&self.2).map_err(Error::msg)
    }

    /// Returns the executed instructions of all rows, without the preparation.
    fn instructions(&self, core: &'static Core) -> Result<f64> {
        let scene = Scene::open(&file("scenes"), &self.chosen())?;
        let mut task = Task::new(core, scene, self.size()?, Quality::Fixed(self.quality()?));
        task.settings.reflections = self.3;
        Ok(outcome(&task)?.drawing() as f64)
    }

    /// Returns the number of rays of the same picture, drawn on this machine.
    fn rays(&self) -> Result<u64> {
        let source = Source::open(&file("scenes"), &self.chosen()).map_err(Error::from_boxed)?;
        let (size, settings) = (self.size()?, Settings::blinn_phong(self.quality()?, self.3));
        let report = source.draw_rows(&source.camera(), size, settings, &mut |_, _| ());
        Ok(report.rays)
    }
}

impl Unit {
    fn all() -> Result<Vec<Self>> {
        serde_json::from_str(include_str!("units/units.json")).context("units.json")
    }

    /// Measures the cost of a unit on a core. `known` has the costs of the units before it.
    fn cost(&self, core: &'static Core, known: &[Kept]) -> Result<f64> {
        let rays = self.more.rays()?.checked_sub(self.less.rays()?);
        ensure!(rays == Some(self.rays), "{}: {rays:?} rays", self.name);
        let more = self.more.instructions(core)? - self.less.instructions(core)?;
        let mut cost = more / f64::from(self.count);
        for (count, name) in &self.without {
            let other = known.iter().find(|it| it.unit == *name);
            let other = other.with_context(|| format!("{name} is no unit"))?;
            cost -= f64::from(*count) * other.instructions;
        }
        Ok(rounded(cost, 1))
    }
}

/// What a unit takes on a core: a line of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kept {
    pub core: String,
    pub unit: String,
    pub instructions: f64,
}

/// Measures the units on one core, or on all of them, and prints a table. Writes the file and the page if the M3 is
/// measured.
pub fn run(core: Option<&'static Core>) -> Result<()> {
    let cores: Vec<_> = match core {
        Some(core) => vec![core],
        None => CORES.iter().collect(),
    };
    let columns = cores.iter().map(|core| measured(core));
    let columns = columns.collect::<Result<Vec<_>>>()?;
    print(aligned(&table(&columns)?) + "\n")?;
    let Some(at) = cores.iter().position(|core| *core == Core::M3) else {
        return Ok(());
    };
    kept::write_lines(FILE, &columns[at])?;
    kept::write(&page(), &text(&columns[at])?)
}

pub fn measured(core: &'static Core) -> Result<Vec<Kept>> {
    let mut costs = Vec::new();
    for unit in Unit::all()? {
        let instructions = unit.cost(core, &costs)?;
        costs.push(Kept {
            core: core.name.to_owned(),
            unit: unit.name,
            instructions,
        });
    }
    Ok(costs)
}

/// The figures that the repository keeps.
pub fn read() -> Result<Vec<Kept>> {
    kept::read(FILE, "measure --units")
}

fn file(name: &str) -> PathBuf {
    root().join(format!("xtask/src/measure/units/{name}.json"))
}

fn page() -> PathBuf {
    root().join("docs/internals/units.md")
}

/// Returns the cells of a table: its head, then a row for each unit. `columns` has the costs of a core each.
fn table(columns: &[Vec<Kept>]) -> Result<Vec<Vec<String>>> {
    let cores = columns.iter().filter_map(|column| column.first());
    let cores = cores.map(|it| it.core.clone());
    let mut rows = vec![row("unit", cores.chain(["measured as".to_owned()]))];
    for (index, unit) in Unit::all()?.iter().enumerate() {
        let costs = columns.iter().filter_map(|column| column.get(index));
        let costs = costs.map(|it| format!("{:.1}", it.instructions));
        let how = format!("`{}`: {}", unit.more.quality()?.type_name(), unit.how);
        rows.push(row(&unit.name, costs.chain([how])));
    }
    Ok(rows)
}

fn text(kept: &[Kept]) -> Result<String> {
    let rows = table(&[kept.to_vec()])?;
    let (head, rows) = rows.split_first().context("the table has a head")?;
    let units = markdown(1, head, rows.to_vec());
    Ok(filled(include_str!("units/page.md"), &[("units", units)]))
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn page_about_units_has_the_kept_figures() {
        let kept = read().unwrap();
        let names = kept.iter().map(|it| &it.unit);
        assert!(names.eq(Unit::all().unwrap().iter().map(|unit| &unit.name)));
        let is_new = fs::read_to_string(page()).unwrap() == text(&kept).unwrap();
        assert!(is_new, "docs/internals/units.md is old");
    }
}
