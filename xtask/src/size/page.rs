//! `docs/sizes.md`, from what was weighed.

use reflet::scenes;

use super::{Figures, QUALITIES, REFLECTIONS, TARGETS};
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

/// The page.
pub(super) fn write(figures: &[Figures], board: Weight) -> String {
    let mut page = HEAD.to_owned();
    for (target, _) in TARGETS {
        page += &format!("\n## {target}\n\n{}", flash(figures, target));
    }
    page += &format!(
        "\n## A whole firmware\n\nThe [castle alone](../examples/board/castle.rs) on the default board, \
         with the drivers of its display and keys, the words of a panic and all: {} bytes of flash, {} \
         of static RAM.\n",
        board.flash, board.ram
    );
    page += "\n## Stack and what is left out\n\n";
    for (target, _) in TARGETS {
        page += &format!("### {target}\n\n{}\n", rest(figures, target));
    }
    page.trim_end().to_owned() + "\n"
}

fn find<'a>(
    figures: &'a [Figures],
    target: &str,
    scene: &str,
    quality: &str,
    reflections: u8,
) -> Option<&'a Figures> {
    figures.iter().find(|it| {
        (it.target.as_str(), it.scene.as_str()) == (target, scene)
            && (it.quality.as_str(), it.reflections) == (quality, reflections)
    })
}

/// The scenes that were weighed with so many reflections, and their rows.
fn rows(
    figures: &[Figures],
    target: &str,
    cells: impl Fn(&dyn Fn(&str) -> Option<Figures>) -> Vec<String>,
) -> Vec<Vec<String>> {
    let mut rows = Vec::new();
    for scene in scenes::NAMES {
        for reflections in REFLECTIONS {
            let find = |quality: &str| find(figures, target, scene, quality, reflections).cloned();
            if find(QUALITIES[0].name()).is_none() {
                continue;
            }
            let mut row = vec![scene.to_owned(), reflections.to_string()];
            row.extend(cells(&find));
            rows.push(row);
        }
    }
    rows
}

/// Code, constants and flash by quality.
fn flash(figures: &[Figures], target: &str) -> String {
    let mut head = vec!["scene".to_owned(), "N".to_owned()];
    for quality in QUALITIES {
        head.extend(["code", "constants", "flash"].map(|it| format!("{} {it}", quality.name())));
    }
    let rows = rows(figures, target, |find| {
        let cells = QUALITIES.map(|quality| match find(quality.name()) {
            Some(it) => [it.code, it.constants, it.flash].map(|it| it.to_string()),
            None => ["-"; 3].map(str::to_owned),
        });
        cells.concat()
    });
    markdown(1, &head, &rows)
}

/// What is left out, and the stack by quality.
fn rest(figures: &[Figures], target: &str) -> String {
    let mut head = ["scene", "left out", "N"].map(str::to_owned).to_vec();
    head.extend(QUALITIES.map(|quality| format!("{} stack", quality.name())));
    let mut rows = rows(figures, target, |find| {
        let stacks = QUALITIES.map(|quality| find(quality.name()).map(|it| it.stack));
        let cell = |stack: Option<u64>| stack.map_or_else(|| "-".to_owned(), |it| it.to_string());
        let mut cells = stacks.map(cell).to_vec();
        let left_out = find(QUALITIES[0].name()).map(|it| it.left_out.join(", "));
        cells.push(left_out.unwrap_or_default());
        cells
    });
    for row in &mut rows {
        let left_out = row.pop().unwrap_or_default();
        row.insert(1, left_out);
    }
    markdown(2, &head, &rows)
}

/// A table of everything, for people at a terminal.
pub(super) fn table(figures: &[Figures]) -> (Vec<String>, Vec<Vec<String>>) {
    let head = [
        "target",
        "scene",
        "quality",
        "left out",
        "N",
        "code",
        "constants",
        "flash",
        "RAM",
        "stack",
    ];
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
    (head.map(str::to_owned).to_vec(), rows.collect())
}
