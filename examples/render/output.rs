//! Where the picture and what is known about it go; it never renders.

use std::io::{self, Cursor, ErrorKind, Write};

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use image::ImageFormat;

use crate::arguments::Arguments;
use crate::file::NewFile;
use crate::picture::Drawing;
use command_line::Failure;

use crate::report;

/// What is asked for, its paths checked.
pub struct Outputs<'a> {
    arguments: &'a Arguments,
    scene: &'a str,
    png: Option<NewFile>,
    raw: Option<NewFile>,
}

impl<'a> Outputs<'a> {
    /// What the command line asks for; a picture in the current folder if it asks for nothing.
    pub fn new(arguments: &'a Arguments, scene: &'a str) -> Result<Self, Failure> {
        let Arguments {
            out,
            raw,
            check,
            json,
            window,
            ..
        } = arguments;
        if out.is_some() && out == raw {
            return Err("--out and --raw name the same file".into());
        }
        let asked = out.is_some() || raw.is_some() || *check || *json || *window;
        let png = match out {
            None if !asked => Some(NewFile::picture_of(scene)),
            path => path.as_deref().map(NewFile::at).transpose()?,
        };
        let raw = raw.as_deref().map(NewFile::at).transpose()?;
        Ok(Self {
            arguments,
            scene,
            png,
            raw,
        })
    }

    /// Whether there is anything to write or to print.
    pub fn are_wanted(&self) -> bool {
        let Arguments { check, json, .. } = *self.arguments;
        self.png.is_some() || self.raw.is_some() || check || json
    }

    /// Writes the files, then prints.
    pub fn write(&self, drawing: &Drawing) -> Result<(), Failure> {
        if let Some(file) = &self.png {
            file.write(&png(&drawing.display)?)?;
        }
        if let Some(file) = &self.raw {
            file.write(&drawing.display.to_be_bytes())?;
        }
        let (size, settings) = (self.arguments.size, self.arguments.settings());
        if self.arguments.json {
            return print(&report::json(self.scene, size, settings, drawing));
        }
        let files = [&self.png, &self.raw].into_iter().flatten();
        let files = files.map(|file| format!("\nwritten to {}", file.path().display()));
        let text = report::text(self.scene, size, settings, drawing);
        print(&(text + &files.collect::<String>()))
    }
}

fn png(display: &SimulatorDisplay<Rgb888>) -> Result<Vec<u8>, Failure> {
    let mut bytes = Cursor::new(Vec::new());
    let image = display.to_rgb_output_image(&OutputSettings::default());
    image
        .as_image_buffer()
        .write_to(&mut bytes, ImageFormat::Png)?;
    Ok(bytes.into_inner())
}

/// Prints and ends the line; that nobody reads any more is no error.
pub fn print(text: &str) -> Result<(), Failure> {
    match writeln!(io::stdout(), "{text}") {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("standard output cannot be written: {error}").into())
        }
        _ => Ok(()),
    }
}
