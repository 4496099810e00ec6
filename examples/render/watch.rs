//! Reads a scene file again when it has changed, and draws an error of the file into the picture.

use std::path::Path;
use std::time::SystemTime;

use command_line::{Chosen, Failure, Source, one_line};
use embedded_graphics::geometry::{OriginDimensions, Point};
use embedded_graphics::mono_font::{MonoTextStyleBuilder, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::Drawable;
use embedded_graphics::text::{Baseline, Text};
use embedded_graphics_simulator::SimulatorDisplay;

/// A scene file and the time of its last change that was read.
pub struct Watch<'a> {
    file: &'a Path,
    chosen: &'a Chosen,
    seen: Option<SystemTime>,
}

impl<'a> Watch<'a> {
    /// The first call of [`Watch::change`] reads the file in any case.
    pub fn new(file: &'a Path, chosen: &'a Chosen) -> Self {
        Self {
            file,
            chosen,
            seen: None,
        }
    }

    /// Returns the new scene or its error if the file has changed since the last call.
    pub fn change(&mut self) -> Option<Result<Source, Failure>> {
        let modified = self.file.metadata().and_then(|file| file.modified()).ok();
        (modified != self.seen).then(|| {
            self.seen = modified;
            Source::open(self.file, self.chosen)
        })
    }
}

/// Draws an error at the top of a picture, in as many lines as its width needs.
pub fn draw_error(error: &str, display: &mut SimulatorDisplay<Rgb888>) {
    let columns = display.size().width / FONT_6X10.character_size.width;
    let letters: Vec<_> = one_line(error).chars().collect();
    let lines = letters.chunks(columns.max(1) as usize);
    let lines: Vec<_> = lines.map(|line| line.iter().collect::<String>()).collect();
    let style = MonoTextStyleBuilder::new()
        .font(&FONT_6X10)
        .text_color(Rgb888::WHITE)
        .background_color(Rgb888::RED)
        .build();
    let text = lines.join("\n");
    let Ok(_) = Text::with_baseline(&text, Point::zero(), style, Baseline::Top).draw(display);
}
