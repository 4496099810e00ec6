//! Runs `cargo xtask` as a user would.

#![allow(dead_code, reason = "no test needs all of it")]

use std::{path::Path, process::Command};

use command_line::{Quality, Settings, Source};
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::Camera;
use reflet::scenes::BuiltIn;

pub struct Done {
    pub code: i32,
    pub out: String,
    pub err: String,
}

pub fn xtask(folder: &Path, arguments: &str) -> Done {
    let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()
        .unwrap();
    Done {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs the command with each of the mistakes, one a line: `arguments => words`. Checks that it ends
/// with exit code 2 and prints one line that contains the words.
pub fn assert_mistakes(folder: &Path, mistakes: &str) {
    for mistake in mistakes.trim().lines() {
        let (arguments, words) = mistake.split_once(" => ").unwrap();
        let Done { code, out, err } = xtask(folder, arguments);
        let lines = err.lines().count();
        assert_eq!((code, lines, &*out), (2, 1, ""), "{arguments}: {err}");
        assert!(err.starts_with("error: "), "{arguments}: {err}");
        assert!(err.contains(words), "{arguments}: {err}");
    }
}

/// Draws a built-in scene into a display in the default quality, with four reflections.
pub fn draw<S: BuiltIn, C>(camera: &Camera, display: &mut SimulatorDisplay<C>)
where
    C: PixelColor + From<Rgb888>,
{
    draw_source(&Source::built_in(S::NAME).unwrap(), camera, display);
}

/// Draws any scene in the same way.
pub fn draw_source<C>(source: &Source, camera: &Camera, display: &mut SimulatorDisplay<C>)
where
    C: PixelColor + From<Rgb888>,
{
    let settings = Settings::blinn_phong(Quality::Fast, 4);
    let size = display.size();
    source.draw_rows(camera, size, settings, &mut |y, row| {
        let area = Rectangle::new(Point::new(0, y as i32), Size::new(size.width, 1));
        let Ok(()) = display.fill_contiguous(&area, row.iter().map(|&pixel| C::from(pixel)));
    });
}
