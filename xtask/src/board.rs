//! The default board, examples/board in QEMU: builds and boots its firmware, presses its keys and
//! captures its display.

use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::Result;
use image::RgbImage;
use reflet::scenes::NAMES;

use crate::emulator::qemu::{Failure, Key, Qemu, Running};
use crate::screenshot::Arguments;
use crate::{enter_root, screenshot, toolchain};

const TARGET: &str = toolchain::M3;

/// Time limit of one run. A picture takes a fraction of a second, and there are eleven scenes.
const LIMIT: Duration = Duration::from_secs(60);

pub fn run(arguments: &Arguments) -> Result<()> {
    let file = arguments.file("board")?;
    println!("board: building");
    let firmware = build()?;
    println!("board: booting");
    let mut board = Board::boot(&firmware)?;
    let line = board.go_to(&arguments.scene)?;
    println!("{line}");
    screenshot::save(&board.screen()?, file)
}

/// Runs a firmware for a person (`cargo xtask show`), until they close the window or stop it.
pub fn show(firmware: &Path) -> Result<()> {
    Ok(machine().show(firmware)?)
}

pub fn build() -> Result<PathBuf> {
    build_example("board")
}

pub fn build_example(name: &str) -> Result<PathBuf> {
    enter_root()?;
    let example = ["--package", "reflet", "--example", name];
    toolchain::built(toolchain::cargo_build("firmware", TARGET)?.args(example))
}

fn machine() -> Qemu {
    Qemu::arm("lm3s6965evb").limit(LIMIT)
}

#[derive(Debug)]
pub struct Board {
    running: Running,
    /// Report line of the picture that is on the display.
    line: String,
}

impl Board {
    pub fn boot(firmware: &Path) -> Result<Self, Failure> {
        let mut running = machine().boot(firmware)?;
        let line = running.line(is_report)?;
        Ok(Self { running, line })
    }

    /// Presses a key, waits for the next picture, and returns the report line of that picture.
    pub fn press(&mut self, key: Key) -> Result<&str, Failure> {
        self.running.press(key)?;
        self.line = self.running.line(is_report)?;
        Ok(&self.line)
    }

    /// Presses the select key until a scene is shown, and returns the report line of its picture.
    pub fn go_to(&mut self, scene: &str) -> Result<&str, Failure> {
        while !self.line.starts_with(&format!("{scene}: ")) {
            self.press(Key::Control)?;
        }
        Ok(&self.line)
    }

    /// Captures the display. Each of its pixels is a square of 4 x 4 pixels in the image.
    pub fn screen(&mut self) -> Result<RgbImage, Failure> {
        self.running.screen()
    }
}

/// Tests whether a line reports a finished picture: `castle: 13509 rays, ...`.
fn is_report(line: &str) -> bool {
    line.split_once(": ")
        .is_some_and(|(name, _)| NAMES.contains(&name))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_report_is_taken_for_one() {
        assert!(is_report("castle: 13509 rays, weight cut off 0.0000"));
        assert!(!is_report("qemu-system-arm: warning"));
        assert!(!is_report("castle"));
    }
}
