//! `docs/sizes.md`, from what was weighed.

use super::{Figures, QUALITIES};
use crate::{measure::Weight, table::markdown};

const HEAD: &str = "\
<!-- Written by `cargo xtask size`. Do not edit: the next run writes over it. -->

# What a scene takes of flash

A constant scene is known to the compiler, and what it does not need is not in the firmware. These
are the bytes of code and constants that the library and the scene have in flash, runtime and display
apart: what a release firmware (`opt-level = 3`) has beyond the same firmware with an empty frame.
N is how often a ray is reflected at most, known when the firmware is compiled: 4, and 0 where there
are mirrors that this leaves out.

`render --needs SCENE` says what a scene of yours needs, and why; `cargo xtask measure --scene
FILE.json` weighs it. The tests fail when a scene grows by more than 2 % beyond these figures.
";

/// The page. The figures lie in the order of [`tasks`](super::tasks).
pub(super) fn write(figures: &[Figures], board: Weight) -> String {
    let targets = || figures.chunk_by(|one, other| one.target == other.target);
    let mut page = HEAD.to_owned();
    for figures in targets() {
        page += &format!("\n## {}\n\n{}", figures[0].target, flash(figures));
    }
    page += &format!(
        "\n## A whole firmware\n\nThe [castle alone](../examples/board/castle.rs) on the default board, \
         with the drivers of its display and keys, the words of a panic and all: {} bytes of flash, {} \
         of static RAM.\n",
        board.flash, board.ram
    );
    page += "\n## Stack and what is left out\n\n";
    for figures in targets() {
        page += &format!("### {}\n\n{}\n", figures[0].target, rest(figures));
    }
    page.trim_end().to_owned() + "\n"
}

/// A table with a row for each scene and number of reflections, of the figures of one target.
/// A row begins with these cells `before` the others, which are for each of the qualities.
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

/// Code, constants and flash by quality.
fn flash(figures: &[Figures]) -> String {
    let before = |it: &Figures| [it.scene.clone(), it.reflections.to_string()];
    let names = ["code", "constants", "flash"];
    by_quality(figures, ["scene", "N"], before, names, |it| {
        [it.code, it.constants, it.flash]
    })
}

/// What is left out, and the stack by quality.
fn rest(figures: &[Figures]) -> String {
    let before = |it: &Figures| {
        let left_out = it.left_out.join(", ");
        [it.scene.clone(), left_out, it.reflections.to_string()]
    };
    let head = ["scene", "left out", "N"];
    by_quality(figures, head, before, ["stack"], |it| [it.stack])
}

/// A table of everything, for people at a terminal.
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
