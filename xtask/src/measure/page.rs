//! `docs/boards.md`, from what was measured.

use reflet::scenes;

use super::cores::{CORES, Core};
use super::{figures::Figures, frames, moving::MovingFigures, moving_record};
use crate::table::{cell, filled, markdown, row};

pub fn write(rows: &[Figures], moving: &[MovingFigures], frames: &[frames::Kept]) -> String {
    let page = Page(rows);
    let longest = page.longest_preparation();
    let values = [
        ("fast", page.instructions()),
        ("float", page.float()),
        ("fast_row", page.worst_row()),
        ("prepare scene", longest.to_owned()),
        ("prepare m0", page.preparation("m0", longest)),
        ("prepare m3", page.preparation("m3", longest)),
        ("moving", moving_record::table(moving)),
        ("frames", frames::page_table(frames)),
        ("sending", frames::sending()),
    ];
    filled(include_str!("page.md"), &values)
}

struct Page<'a>(&'a [Figures]);

impl Page<'_> {
    fn row(&self, core: &str, scene: &str, quality: &str) -> Option<&Figures> {
        let mut rows = self.0.iter();
        rows.find(|row| row.core == core && row.scene == scene && row.quality == quality)
    }

    fn instructions(&self) -> String {
        self.by_core(|row| format!("{:.0}", row.instructions_per_pixel))
    }

    fn worst_row(&self) -> String {
        self.by_core(|row| row.worst_row_instructions.to_string())
    }

    /// Returns the scene whose preparation takes the most instructions on a Cortex-M3.
    fn longest_preparation(&self) -> &'static str {
        let instructions = |scene: &&str| {
            let row = self.row("m3", scene, "fast");
            row.map(|row| row.prepare_instructions)
        };
        let longest = scenes::NAMES.into_iter().max_by_key(instructions);
        longest.unwrap_or_default()
    }

    fn preparation(&self, core: &str, scene: &str) -> String {
        let row = self.row(core, scene, "fast");
        cell(row.map(|row| row.prepare_instructions.to_string()))
    }

    /// Formats a table with a row for each scene and a column for each core.
    fn by_core(&self, cell: impl Fn(&Figures) -> String) -> String {
        let titles = CORES.iter().map(|core| core.title.to_owned());
        by_scene(titles, |scene| {
            let cell = |core: &Core| self.row(core.name, scene, "fast").map(&cell);
            CORES.iter().map(cell).collect()
        })
    }

    fn float(&self) -> String {
        const CORES: [&str; 2] = ["m3", "m4f"];
        let head = CORES.map(|core| {
            let [fast, float] = ["Fast", "float"].map(|name| format!("{core} {name}"));
            [fast, float, "float / Fast".to_owned()]
        });
        by_scene(head.concat(), |scene| {
            let cells = CORES.map(|core| {
                let figure = |quality| {
                    let row = self.row(core, scene, quality);
                    row.map(|row| row.instructions_per_pixel)
                };
                let [fast, float] = ["fast", "float"].map(figure);
                let whole = |figure: Option<f64>| figure.map(|figure| format!("{figure:.0}"));
                let times = |(fast, float)| format!("{:.1}", float / fast);
                [whole(fast), whole(float), fast.zip(float).map(times)]
            });
            cells.concat()
        })
    }
}

/// Formats a table with a row for each built-in scene.
fn by_scene(
    columns: impl IntoIterator<Item = String>,
    cells: impl Fn(&str) -> Vec<Option<String>>,
) -> String {
    let rows = scenes::NAMES.map(|scene| row(scene, cells(scene).into_iter().map(cell)));
    markdown(1, &row("scene", columns), rows)
}
