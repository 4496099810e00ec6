//! Writes `docs/sizes.md` from the measured figures.

use super::{Figures, QUALITIES, REFLECTIONS};
use crate::measure::{Weight, profiles};
use crate::table::{filled, markdown, row};

/// Columns of the page: qualities by their names in the figures.
const SHOWN: [&str; 3] = ["fast", "small", "exact"];

/// Returns the text of the page. The figures must be in the order of [`tasks`](super::tasks), the
/// profiles in that of [`profiles::tasks`].
pub(super) fn write(figures: &[Figures], board: Weight, profiles: &[profiles::Row]) -> String {
    let targets = figures.chunk_by(|one, other| one.target == other.target);
    let part = |it: &[Figures]| format!("### {}\n\n{}\n", it[0].target, by_scene(it));
    let values = [
        ("sizes", targets.map(part).collect()),
        ("board flash", board.flash.to_string()),
        ("board RAM", board.ram.to_string()),
        ("profiles", profiles::long(profiles)),
    ];
    filled(include_str!("page.md"), &values)
}

/// Returns a table with flash and stack of each scene with all its reflections.
fn by_scene(figures: &[Figures]) -> String {
    let pairs = SHOWN.map(|name| [format!("{name} flash"), format!("{name} stack")]);
    let head = row("scene", pairs.concat());
    let whole = figures
        .chunks(QUALITIES.len())
        .filter(|it| it[0].reflections == REFLECTIONS[0]);
    let rows = whole.map(|qualities| {
        let shown = SHOWN.iter().flat_map(|name| {
            let figures = qualities.iter().find(|it| it.quality == *name);
            figures.into_iter().flat_map(|it| [it.flash, it.stack])
        });
        row(&qualities[0].scene, shown.map(|it| it.to_string()))
    });
    markdown(1, &head, rows)
}

/// Returns the head and the rows of a table of all figures, for the terminal.
pub(super) fn table(figures: &[Figures]) -> (Vec<String>, Vec<Vec<String>>) {
    let head = "target,scene,quality,left out,N,code,constants,flash,RAM,stack".split(',');
    let rows = figures.iter().map(|it| {
        let texts = [&it.target, &it.scene, &it.quality].map(Clone::clone);
        let numbers = [
            u64::from(it.reflections),
            it.code,
            it.constants,
            it.flash,
            it.ram,
            it.stack,
        ];
        let mut row = texts.to_vec();
        row.push(it.left_out.join(", "));
        row.extend(numbers.map(|it| it.to_string()));
        row
    });
    (head.map(str::to_owned).collect(), rows.collect())
}
