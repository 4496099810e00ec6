//! Frames a second of boards that people own: measured, kept in `docs/measured/frames.jsonl`, and shown
//! in README.md and docs/boards.md.

use std::{fs, path::PathBuf};

use anyhow::{Context, Result};
use command_line::Chosen;
use reflet::scenes;
use serde::{Deserialize, Serialize};

use super::speed::{Board, SIZE};
use super::{Core, Quality, Scene, Task, outcome, record};
use crate::owned::{ALL, Owned};
use crate::table::{cell, markdown, rounded, row, with_table};
use crate::{kept, root};

const FILE: &str = "docs/measured/frames.jsonl";

/// Scenes in files, which come first: people know them at sight.
const FILES: [&str; 5] = ["harbour", "harbour_sun", "matt3", "chrome3", "pybadge"];

/// Scenes in the table of README.md.
const SHOWN: [&str; 3] = ["harbour", "columns", "castle"];

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kept {
    pub board: String,
    pub scene: String,
    pub frames_per_second: f64,
}

/// Measures all boards and scenes again, and writes the file, the table in README.md and docs/boards.md.
pub fn renew() -> Result<()> {
    let mut lines = Vec::new();
    for board in ALL {
        for scene in FILES.into_iter().chain(scenes::NAMES) {
            let frames_per_second = rounded(1.0 / estimated(board, scene)?, 2);
            println!("{}, {scene}: {frames_per_second:.2}", board.title);
            lines.push(Kept {
                board: board.title.to_owned(),
                scene: scene.to_owned(),
                frames_per_second,
            });
        }
    }
    kept::write_lines(FILE, &lines)?;
    let readme = root().join("README.md");
    let old = fs::read_to_string(&readme).context("cannot read README.md")?;
    let new =
        with_table(&old, "", &readme_table(&lines)).context("README.md has no table of boards")?;
    kept::write(&readme, &new)?;
    record::renew_page()
}

/// Returns the times in which the boards send a frame, in words.
pub fn sending() -> String {
    let times = ALL.map(|board| {
        let [sending, hidden] = [board.sending, board.hidden];
        format!(
            "{sending:.0} ms on the {} (by DMA {hidden:.0} ms)",
            board.title
        )
    });
    times.join(", ")
}

/// Returns the seconds of a scene's frame on a board, estimated now.
pub fn estimated(board: &'static Owned, scene: &str) -> Result<f64> {
    let path = if FILES.contains(&scene) {
        root().join(format!("examples/scenes/{scene}.json"))
    } else {
        PathBuf::from(scene)
    };
    let core = Core::find(board.core).context("no such core")?;
    let scene = Scene::open(&path, &Chosen::default())?;
    let task = Task::new(core, scene, SIZE, Quality::FAST);
    Ok(Board::of(board).speed(&task, &outcome(&task)?)?.frame())
}

pub fn read() -> Result<Vec<Kept>> {
    kept::read(FILE, "measure --frames")
}

/// Formats the table of README.md: a row for each board, a column for each scene.
pub fn readme_table(kept: &[Kept]) -> String {
    let head = row("board", SHOWN.map(|scene| format!("`{scene}`")));
    let boards = ALL.iter().map(|board| {
        let cells = SHOWN.map(|scene| frames_per_second(kept, board.title, scene));
        row(board.title, cells)
    });
    let esp = ["no published timings", "", ""].map(str::to_owned);
    markdown(1, &head, boards.chain([row("ESP32-C3", esp)]))
}

/// Formats the table of docs/boards.md: a row for each scene, a column for each board.
pub fn page_table(kept: &[Kept]) -> String {
    let head = row("scene", ALL.map(|board| board.title.to_owned()));
    let rows = FILES.into_iter().chain(scenes::NAMES).map(|scene| {
        row(
            scene,
            ALL.map(|board| frames_per_second(kept, board.title, scene)),
        )
    });
    markdown(1, &head, rows)
}

fn frames_per_second(kept: &[Kept], board: &str, scene: &str) -> String {
    let mut lines = kept.iter();
    let line = lines.find(|line| line.board == board && line.scene == scene);
    cell(line.map(|line| format!("{:.2}", line.frames_per_second)))
}
