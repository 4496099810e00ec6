//! Draws one orbit of the camera, and writes it as numbered pictures and as a GIF. Never chooses colours.

use std::fs;
use std::path::Path;
use std::time::Instant;

use command_line::{Failure, OutputFile, Source, exact, is_standard_output, shown};
use embedded_graphics::geometry::{OriginDimensions, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::{Camera, Error, Report};

use crate::arguments::Arguments;
use crate::output::{keep_the_scene_file, png, print};
use crate::picture::{Drawing, afford, draw};
use crate::{palette, progress, report};

/// Hundredths of a second that an orbit takes, if each frame is shown for [`SHORTEST`] to [`LONGEST`].
const ORBIT: u16 = 600;

/// Many programs show a frame for a tenth of a second if the file says less.
const SHORTEST: u16 = 2;

/// A frame that is shown for longer looks like a picture of its own.
const LONGEST: u16 = 10;

/// Bytes that a pixel of a frame takes: in the frame, for the choice of the palette, and in the file.
const BYTES_OF_PIXEL: u64 = 3 + 4 + 1;

/// Draws and writes the orbit of `count` frames that the command line asks for.
pub fn write(source: &Source, arguments: &Arguments, count: u16) -> Result<(), Failure> {
    afford(arguments.size, BYTES_OF_PIXEL * u64::from(count))?;
    let outputs = Outputs::new(arguments, count)?;
    let (frames, all) = drawn(source, arguments, &cameras(source, count)?);
    let written = outputs.write(frames)?;
    let text = report::text(source.name(), arguments.size, arguments.settings(), &all);
    print(arguments, &(text + &written))
}

/// The checked paths that the film goes to.
struct Outputs<'a> {
    folder: Option<&'a Path>,
    pictures: Vec<OutputFile>,
    gif: Option<OutputFile>,
}

impl<'a> Outputs<'a> {
    fn new(arguments: &'a Arguments, count: u16) -> Result<Self, Failure> {
        let folder = arguments.frames.as_deref();
        let picture = |folder: &Path, index| folder.join(format!("frame-{index:03}.png"));
        let paths = |folder| (0..count).map(move |index| picture(folder, index));
        let paths: Vec<_> = folder.into_iter().flat_map(paths).collect();
        keep_the_scene_file(arguments, paths.iter().chain(&arguments.gif))?;
        let gif = arguments.gif.as_deref().map(OutputFile::gif_at);
        let gif = gif.transpose()?;
        if let Some(folder) = folder {
            let failed = |error| format!("the folder {} cannot be made: {error}", shown(folder));
            fs::create_dir_all(folder).map_err(failed)?;
        }
        let pictures = paths.iter().map(|path| OutputFile::png_at(path));
        let pictures = pictures.collect::<Result<_, _>>()?;
        Ok(Self {
            folder,
            pictures,
            gif,
        })
    }

    /// Writes the files, and returns where they are, in lines of text.
    fn write(self, frames: Vec<SimulatorDisplay<Rgb888>>) -> Result<String, Failure> {
        let (count, mut text) = (frames.len(), String::new());
        for (file, frame) in self.pictures.into_iter().zip(&frames) {
            file.write(&png(frame)?)?;
        }
        if let Some(folder) = self.folder {
            text += &format!("\n{count} frames written to the folder {}", shown(folder));
        }
        if let Some(file) = self.gif {
            let path = file.write(&encoded(&frames)?)?;
            if !is_standard_output(&path) {
                text += &format!("\n{count} frames written to {}", shown(&path));
            }
        }
        Ok(text)
    }
}

/// Returns the cameras of one orbit to the right. The first is the scene's own.
fn cameras(source: &Source, count: u16) -> Result<Vec<Camera>, Error> {
    let first = exact(&source.reference().1)?;
    let others = (1..count).map(|index| {
        let degrees = 360.0 * f64::from(index) / f64::from(count);
        first.orbited(degrees, 0)
    });
    [Ok(first)].into_iter().chain(others).collect()
}

/// Draws a frame for each camera. Also returns the first frame with the time and the report of all.
fn drawn(
    source: &Source,
    arguments: &Arguments,
    cameras: &[Camera],
) -> (Vec<SimulatorDisplay<Rgb888>>, Drawing) {
    let started = Instant::now();
    let rows = u64::from(arguments.size.height) * cameras.len() as u64;
    let drawn = progress::watch(Some(rows), |rows| {
        let drawn = cameras.iter().map(|camera| {
            let mut display = SimulatorDisplay::new(arguments.size);
            let report = draw(source, camera, arguments.settings(), &mut display, rows);
            if let Some(levels) = arguments.dither {
                levels.dither(&mut display);
            }
            (display, report)
        });
        drawn.collect::<Vec<_>>()
    });
    let (frames, reports): (Vec<_>, Vec<_>) = drawn.into_iter().unzip();
    let all = Drawing {
        display: frames[0].clone(),
        seconds: started.elapsed().as_secs_f64(),
        report: Some(reports.into_iter().fold(Report::NONE, Report::merge)),
        difference: None,
    };
    (frames, all)
}

/// Returns the frames as a GIF with one palette, which repeats without end.
fn encoded(frames: &[SimulatorDisplay<Rgb888>]) -> Result<Vec<u8>, Failure> {
    let Size { width, height } = frames[0].size();
    let (width, height) = (u16::try_from(width)?, u16::try_from(height)?);
    let frames: Vec<_> = frames.iter().map(SimulatorDisplay::to_be_bytes).collect();
    let delay = (ORBIT / u16::try_from(frames.len())?).clamp(SHORTEST, LONGEST);
    Ok(palette::encoded(&frames, [width, height], delay)?)
}
