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

/// A board whose core is not one of [`ALL`]: nobody publishes the cycles of its instructions.
const UNTIMED: &str = "ESP32-C3";

/// Its clock in hertz: each of its instructions takes a cycle at least.
const CLOCK: f64 = 160e6;

/// Seconds in which its example sends a frame, of 16 bits a pixel at 40 MHz.
const SENDING: f64 = 16.0 * 240.0 * 240.0 / 40e6;

#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kept {
    pub board: String,
    pub scene: String,
    pub frames_per_second: f64,
    /// Whether the board draws fewer.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub is_limit: bool,
}

/// Measures all boards and scenes again, and writes the file, the table in README.md and docs/boards.md.
pub fn renew() -> Result<()> {
    let mut lines = Vec::new();
    for (board, owned) in boards() {
        for scene in FILES.into_iter().chain(scenes::NAMES) {
            let seconds = match owned {
                Some(owned) => estimated(owned, scene)?,
                None => {
                    let core = Core::find("rv32").context("no such core")?;
                    let tracing = outcome(&task(core, scene)?)?.instructions() as f64 / CLOCK;
                    tracing.max(SENDING)
                }
            };
            let frames_per_second = rounded(1.0 / seconds, 2);
            println!("{board}, {scene}: {frames_per_second:.2}");
            lines.push(Kept {
                board: board.to_owned(),
                scene: scene.to_owned(),
                frames_per_second,
                is_limit: owned.is_none(),
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

/// Returns the titles of all boards, in the order of the tables, and those whose frames are estimated.
fn boards() -> impl Iterator<Item = (&'static str, Option<&'static Owned>)> {
    let owned = ALL.into_iter().map(|board| (board.title, Some(board)));
    owned.chain([(UNTIMED, None)])
}

/// Returns the seconds of a scene's frame on a board, estimated now.
pub fn estimated(board: &'static Owned, scene: &str) -> Result<f64> {
    let task = task(Core::find(board.core).context("no such core")?, scene)?;
    Ok(Board::of(board).speed(&task, &outcome(&task)?)?.frame())
}

/// Returns the task of a scene's frame on a core.
fn task(core: &'static Core, scene: &str) -> Result<Task> {
    let path = if FILES.contains(&scene) {
        root().join(format!("examples/scenes/{scene}.json"))
    } else {
        PathBuf::from(scene)
    };
    let scene = Scene::open(&path, &Chosen::default())?;
    Ok(Task::new(core, scene, SIZE, Quality::FAST))
}

pub fn read() -> Result<Vec<Kept>> {
    kept::read(FILE, "measure --frames")
}

/// Formats the table of README.md: a row for each board, a column for each scene.
pub fn readme_table(kept: &[Kept]) -> String {
    let head = row("board", SHOWN.map(|scene| format!("`{scene}`")));
    let rows =
        boards().map(|(board, _)| row(board, SHOWN.map(|it| frames_per_second(kept, board, it))));
    markdown(1, &head, rows)
}

/// Formats the table of docs/boards.md: a row for each scene, a column for each board.
pub fn page_table(kept: &[Kept]) -> String {
    let head = row("scene", boards().map(|(board, _)| board.to_owned()));
    let rows = FILES.into_iter().chain(scenes::NAMES).map(|scene| {
        let cells = boards().map(|(board, _)| frames_per_second(kept, board, scene));
        row(scene, cells)
    });
    markdown(1, &head, rows)
}

fn frames_per_second(kept: &[Kept], board: &str, scene: &str) -> String {
    let mut lines = kept.iter();
    let line = lines.find(|line| line.board == board && line.scene == scene);
    cell(line.map(|line| {
        let less = if line.is_limit { "< " } else { "" };
        format!("{less}{:.2}", line.frames_per_second)
    }))
}
