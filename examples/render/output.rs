//! Writes the picture and the text about it. Never renders.

use std::io::{self, Cursor, Write};
use std::path::PathBuf;

use command_line::{Failure, Named, OutputFile, Source, are_same_file, is_standard_output, shown};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use image::ImageFormat;

use crate::arguments::Arguments;
use crate::picture::Drawing;
use crate::report;

/// The outputs that the command line asks for. Their paths have been checked.
pub struct Outputs<'a> {
    arguments: &'a Arguments,
    scene: &'a str,
    png: Option<OutputFile>,
    raw: Option<OutputFile>,
}

impl<'a> Outputs<'a> {
    /// Checks the paths of the outputs. If the command line asks for nothing, the picture goes to
    /// the current folder.
    pub fn new(arguments: &'a Arguments, source: &'a Source) -> Result<Self, Failure> {
        let Arguments { out, raw, .. } = arguments;
        let both = out.as_ref().zip(raw.as_ref());
        if both.is_some_and(|(out, raw)| are_same_file(out, raw)) {
            return Err("--out and --raw name the same file".into());
        }
        keep_the_scene_file(arguments, out.iter().chain(raw))?;
        let scene = source.name();
        let is_asked = out.is_some() || raw.is_some();
        let asked = is_asked || arguments.check || arguments.json || arguments.window;
        let png = match out {
            None if !asked => Some(OutputFile::free_png(&picture_of(scene))?),
            path => path.as_deref().map(OutputFile::png_at).transpose()?,
        };
        let raw = raw.as_deref().map(OutputFile::at).transpose()?;
        Ok(Self {
            arguments,
            scene,
            png,
            raw,
        })
    }

    /// Tests whether there is anything to write or to print.
    pub fn are_wanted(&self) -> bool {
        let is_written = self.png.is_some() || self.raw.is_some();
        is_written || self.arguments.check || self.arguments.json
    }

    /// Writes the files, then prints.
    pub fn write(self, drawing: &Drawing) -> Result<(), Failure> {
        let mut written = Vec::new();
        if let Some(file) = self.png {
            written.push(file.write(&png(&drawing.display)?)?);
        }
        if let Some(file) = self.raw {
            written.push(file.write(&drawing.display.to_be_bytes())?);
        }
        let arguments = self.arguments;
        let (size, settings) = (arguments.size, arguments.settings());
        if arguments.json {
            let line = report::json(self.scene, size, settings, drawing);
            return print(arguments, &line);
        }
        let written = written.iter().filter(|path| !is_standard_output(path));
        let written = written.map(|path| format!("\nwritten to {}", shown(path)));
        let text = report::text(self.scene, size, settings, drawing);
        print(arguments, &(text + &written.collect::<String>()))
    }
}

/// Refuses paths of outputs that lead to the scene file.
pub fn keep_the_scene_file<'p>(
    arguments: &Arguments,
    mut paths: impl Iterator<Item = &'p PathBuf>,
) -> Result<(), Failure> {
    let read = &arguments.scene;
    let is_read = matches!(Named::of(read, &arguments.chosen), Ok(Named::File));
    if is_read && paths.any(|path| are_same_file(path, read)) {
        Err(format!("{} is the scene file: it is not written over", shown(read)).into())
    } else {
        Ok(())
    }
}

/// Returns the path `NAME.png` in the current folder. Characters of the name that could lead to
/// another folder are replaced, and an empty name becomes `scene`.
fn picture_of(scene: &str) -> PathBuf {
    let safe = |letter: char| {
        if letter.is_alphanumeric() || "-_ ".contains(letter) { letter } else { '_' }
    };
    let name: String = scene.trim().chars().map(safe).take(50).collect();
    let name = if name.is_empty() { "scene" } else { &name };
    PathBuf::from(format!("{name}.png"))
}

/// Returns the bytes of a PNG file.
pub fn png(display: &SimulatorDisplay<Rgb888>) -> Result<Vec<u8>, Failure> {
    let mut bytes = Cursor::new(Vec::new());
    let image = display.to_rgb_output_image(&OutputSettings::default());
    image
        .as_image_buffer()
        .write_to(&mut bytes, ImageFormat::Png)?;
    Ok(bytes.into_inner())
}

/// Prints a line: on standard error if standard output carries a picture, else on standard output. A
/// closed pipe is no error.
pub fn print(arguments: &Arguments, text: &str) -> Result<(), Failure> {
    if arguments.picture_is_printed() {
        // If a message cannot be printed, nothing is left to do.
        let _ = writeln!(io::stderr(), "{text}");
        return Ok(());
    }
    command_line::print(format!("{text}\n"))
}
