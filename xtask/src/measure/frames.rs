//! Frames a second of boards that people own: measured, kept in `docs/measured/frames.jsonl`, and shown
//! in README.md and docs/boards.md.

use std::{fs, path::PathBuf};

use anyhow::{Context, Result};
use command_line::Chosen;
use reflet::scenes;
use serde::{Deserialize, Serialize};

use super::speed::Board;
use super::{Core, Quality, Scene, Size, Task};
use crate::{kept, root, table::markdown};

/// A board with a display of 240 by 240 pixels.
struct Owned {
    name: &'static str,
    core: &'static str,
    /// Clock of the cores in MHz.
    clock: f64,
    cores: u8,
    /// Seconds in which the board sends a frame.
    sending: f64,
}

/// The boards, with the clocks that the examples set. The Pico and the Pico 2 send a frame in the time that
/// the emulated board takes for the scene `empty`: their drivers wait for each byte, so this is longer than
/// the bus alone would take. On the Black Pill it is the bus at 48 MHz, 16 bits a pixel.
const BOARDS: [Owned; 3] = [
    Owned {
        name: "Raspberry Pi Pico",
        core: "m0",
        clock: 125.0,
        cores: 2,
        sending: 0.077,
    },
    Owned {
        name: "Raspberry Pi Pico 2",
        core: "m33",
        clock: 150.0,
        cores: 2,
        sending: 0.062,
    },
    Owned {
        name: "Black Pill (STM32F411)",
        core: "m4f",
        clock: 96.0,
        cores: 1,
        sending: 0.0192,
    },
];

/// Scenes in files, which come first: people know them at sight.
const FILES: [&str; 5] = ["harbour", "harbour_sun", "matt3", "chrome3", "pybadge"];

/// Scenes in the table of README.md.
const SHOWN: [&str; 3] = ["harbour", "columns", "castle"];

const SIZE: Size = Size::new(240, 240);

/// A line of the file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Kept {
    pub board: String,
    pub scene: String,
    pub frames_per_second: f64,
}

/// Measures all boards and scenes again, and writes the file and the table in README.md.
pub fn renew() -> Result<()> {
    let mut lines = Vec::new();
    for board in &BOARDS {
        for scene in FILES.into_iter().chain(scenes::NAMES) {
            let frames_per_second = hundredths(board.frames_per_second(scene)?);
            println!("{}, {scene}: {frames_per_second:.2}", board.name);
            lines.push(Kept {
                board: board.name.to_owned(),
                scene: scene.to_owned(),
                frames_per_second,
            });
        }
    }
    let text = lines
        .iter()
        .map(|line| Ok(serde_json::to_string(line)? + "\n"));
    kept::write(&file(), &text.collect::<Result<String>>()?)?;
    let readme = root().join("README.md");
    let old = fs::read_to_string(&readme).context("cannot read README.md")?;
    let new =
        with_table(&old, &readme_table(&lines)).context("README.md has no table of boards")?;
    kept::write(&readme, &new)
}

/// Returns the frames a second of a scene on a board, estimated now and not rounded.
pub fn estimated(board: &str, scene: &str) -> Result<f64> {
    let board = BOARDS.iter().find(|it| it.name == board);
    board.context("no such board")?.frames_per_second(scene)
}

pub fn read() -> Result<Vec<Kept>> {
    kept::read(&file(), "measure --frames")
}

fn file() -> PathBuf {
    root().join("docs/measured/frames.jsonl")
}

fn hundredths(number: f64) -> f64 {
    (100.0 * number).round() / 100.0
}

impl Owned {
    fn frames_per_second(&self, scene: &str) -> Result<f64> {
        let core = Core::find(self.core).context("no such core")?;
        let path = match FILES.contains(&scene) {
            true => root().join(format!("examples/scenes/{scene}.json")),
            false => PathBuf::from(scene),
        };
        let scene = Scene::open(&path, &Chosen::default())?;
        let task = Task::new(core, scene, SIZE, Quality::FAST);
        let tracing = Board::new(self.clock, self.cores).speed(&task)?.tracing;
        Ok(1.0 / (tracing + self.sending))
    }
}

/// Formats the table of README.md: a row for each board, a column for each scene.
pub fn readme_table(kept: &[Kept]) -> String {
    let head = SHOWN.map(|scene| format!("`{scene}`"));
    let head: Vec<_> = ["board".to_owned()].into_iter().chain(head).collect();
    let mut rows: Vec<_> = BOARDS
        .iter()
        .map(|board| {
            let cells = SHOWN.map(|scene| cell(kept, board.name, scene));
            [vec![board.name.to_owned()], cells.to_vec()].concat()
        })
        .collect();
    rows.push(
        ["ESP32-C3", "no published timings", "", ""]
            .map(str::to_owned)
            .to_vec(),
    );
    markdown(1, &head, &rows)
}

/// Formats the table of docs/boards.md: a row for each scene, a column for each board.
pub fn page_table(kept: &[Kept]) -> String {
    let boards = BOARDS.iter().map(|board| board.name.to_owned());
    let head: Vec<_> = ["scene".to_owned()].into_iter().chain(boards).collect();
    let rows = FILES.into_iter().chain(scenes::NAMES).map(|scene| {
        let cells = BOARDS.iter().map(|board| cell(kept, board.name, scene));
        [scene.to_owned()].into_iter().chain(cells).collect()
    });
    markdown(1, &head, &rows.collect::<Vec<_>>())
}

fn cell(kept: &[Kept], board: &str, scene: &str) -> String {
    let mut lines = kept.iter();
    let line = lines.find(|line| line.board == board && line.scene == scene);
    line.map_or_else(
        || "-".to_owned(),
        |line| format!("{:.2}", line.frames_per_second),
    )
}

/// Returns the text of README.md with another table of boards; `None` if it has no place for one.
pub fn with_table(text: &str, table: &str) -> Option<String> {
    const MARKS: [&str; 2] = ["<!-- boards -->\n", "<!-- /boards -->"];
    let (before, rest) = text.split_once(MARKS[0])?;
    let (_, after) = rest.split_once(MARKS[1])?;
    Some([before, MARKS[0], table, MARKS[1], after].concat())
}
