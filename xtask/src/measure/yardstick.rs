//! Scenes after ray tracers that others published: measured, kept in `docs/measured/yardstick.jsonl`, and shown
//! in docs/yardstick.md.

use std::{fs, path::PathBuf};

use anyhow::{Context, Result};
use command_line::Chosen;

use super::{Core, Figures, Quality, Scene, Size, Task, measure};
use crate::table::{markdown, with_table};
use crate::{kept, root};

const FILE: &str = "docs/measured/yardstick.jsonl";

const CORES: [&str; 2] = ["m3", "m4f"];

const QVGA: Size = Size::new(320, 240);
const BADGE: Size = Size::new(160, 128);

/// Scenes in files: name, size, number of reflections, and what is published for a pixel.
const SCENES: [(&str, Size, u8, &str); 7] = [
    (
        "four_spheres",
        QVGA,
        2,
        "RX72N, FPU, 240 MHz, 342 ms: 1069 cycles; RX220, no FPU, 32 MHz, 291 s: 121427 cycles; \
         STM32F7, 620 ms",
    ),
    (
        "tinyraytracer",
        QVGA,
        4,
        "M3, Q16.16: 10040 instr; soft float: 38462; M4F: 1471",
    ),
    ("pybadge0", BADGE, 4, "M4F: 177 instr"),
    ("pybadge1", BADGE, 4, "M4F: 174 instr"),
    ("pybadge2", BADGE, 4, "M4F: 187 instr"),
    ("pybadge3", BADGE, 4, "M4F: 184 instr"),
    ("pybadge4", BADGE, 4, "M4F: 156 instr"),
];

/// Measures the scenes again, and writes their file and the table of docs/yardstick.md.
pub fn renew() -> Result<()> {
    let rows = tasks()?.iter().map(measure).collect::<Result<Vec<_>>>()?;
    kept::write_lines(FILE, &rows)?;
    let old = fs::read_to_string(page()).context("cannot read docs/yardstick.md")?;
    let new = with_table(&old, "", &table(&rows)).context("docs/yardstick.md has no table")?;
    kept::write(&page(), &new)
}

/// What is measured: every scene on the first core, then on the second.
pub fn tasks() -> Result<Vec<Task>> {
    let task = |core, (name, size, reflections, _)| {
        let path = root().join(format!("examples/yardstick/{name}.json"));
        let scene = Scene::open(&path, &Chosen::default())?;
        let core = Core::find(core).context("no such core")?;
        let mut task = Task::new(core, scene, size, Quality::FAST);
        task.settings.reflections = reflections;
        Ok(task)
    };
    let tasks = CORES.map(|core| SCENES.map(|scene| task(core, scene)));
    tasks.into_iter().flatten().collect()
}

/// The figures that the repository keeps, in the order of [`tasks`].
pub fn read() -> Result<Vec<Figures>> {
    kept::read(FILE, "measure --yardstick")
}

fn page() -> PathBuf {
    root().join("docs/yardstick.md")
}

/// Formats the table: a row for each scene, and one for the mean of the layouts of the PyBadge.
fn table(rows: &[Figures]) -> String {
    const HEAD: &str = "scene,published,m3 instr,m3 cycles,m4f instr,m4f cycles";
    let line = |name: &str, scenes: &str, published: &str| {
        let figures = CORES.iter().flat_map(|core| mean(rows, core, scenes));
        let texts = [name, published].map(str::to_owned).into_iter();
        texts.chain(figures.map(|it| format!("{it:.0}"))).collect()
    };
    let lines = SCENES.map(|(name, _, _, published)| line(name, name, published));
    let mean = line("mean of five", "pybadge", "M4F: 176 instr");
    let head: Vec<_> = HEAD.split(',').collect();
    markdown(2, &head, lines.into_iter().chain([mean]))
}

/// Returns the mean instructions and cycles a pixel on a core, over the scenes whose names begin with `scenes`.
fn mean(rows: &[Figures], core: &str, scenes: &str) -> [f64; 2] {
    let is_meant = |row: &&Figures| row.core == core && row.scene.starts_with(scenes);
    let meant = || rows.iter().filter(is_meant);
    let sums = meant().fold([0.0; 2], |[instructions, cycles], row| {
        let more = row.cycles_per_pixel.unwrap_or(f64::NAN);
        [instructions + row.instructions_per_pixel, cycles + more]
    });
    sums.map(|sum| sum / meant().count() as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn page_about_published_ray_tracers_has_the_kept_figures() {
        let text = fs::read_to_string(page()).unwrap();
        assert_eq!(with_table(&text, "", &table(&read().unwrap())), Some(text));
    }
}
