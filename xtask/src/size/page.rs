//! Writes `docs/sizes.md` from the measured figures.

use super::{Figures, QUALITIES};
use crate::measure::Weight;
use crate::table::{filled, markdown};

/// Returns the text of the page. The figures must be in the order of [`tasks`](super::tasks).
pub(super) fn write(figures: &[Figures], board: Weight) -> String {
    let by_target = |level: &str, table: fn(&[Figures]) -> String| -> String {
        let targets = figures.chunk_by(|one, other| one.target == other.target);
        let part = |it: &[Figures]| format!("{level} {}\n\n{}\n", it[0].target, table(it));
        targets.map(part).collect()
    };
    let values = [
        ("flash", by_target("##", flash)),
        ("board flash", board.flash.to_string()),
        ("board RAM", board.ram.to_string()),
        ("rest", by_target("###", rest)),
    ];
    filled(include_str!("page.md"), &values)
}

/// Returns a table with one row for each scene and number of reflections: the cells of `before`,
/// then those of `cells` for each quality.
fn by_quality<const B: usize, const N: usize>(
    figures: &[Figures],
    head: [&str; B],
    before: impl Fn(&Figures) -> [String; B],
    names: [&str; N],
    cells: impl Fn(&Figures) -> [u64; N],
) -> String {
    let mut head = head.map(str::to_owned).to_vec();
    for quality in QUALITIES {
        head.extend(names.map(|name| format!("{} {name}", quality.name())));
    }
    let rows = figures.chunks(QUALITIES.len()).map(|qualities| {
        let numbers = qualities.iter().flat_map(&cells);
        let mut row = before(&qualities[0]).to_vec();
        row.extend(numbers.map(|number| number.to_string()));
        row
    });
    markdown(B - 1, &head, &rows.collect::<Vec<_>>())
}

fn flash(figures: &[Figures]) -> String {
    let before = |it: &Figures| [it.scene.clone(), it.reflections.to_string()];
    let names = ["code", "constants", "flash"];
    by_quality(figures, ["scene", "N"], before, names, |it| {
        [it.code, it.constants, it.flash]
    })
}

fn rest(figures: &[Figures]) -> String {
    let before = |it: &Figures| {
        let left_out = it.left_out.join(", ");
        [it.scene.clone(), left_out, it.reflections.to_string()]
    };
    let head = ["scene", "left out", "N"];
    by_quality(figures, head, before, ["stack"], |it| [it.stack])
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
