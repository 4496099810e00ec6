//! Parses the command line of `render`. Never opens a file.

use std::path::PathBuf;

use clap::{ArgGroup, Parser, value_parser};
use command_line::{Chosen, Quality, Settings, Shading, is_standard_output, size};
use embedded_graphics::geometry::Size;
use reflet::scenes;

use crate::dither::Levels;

/// Renders a scene of mirrors in fixed point, as a microcontroller does.
#[derive(Parser)]
#[command(name = "render", version, max_term_width = 100, after_long_help = after_help())]
#[command(group = ArgGroup::new("film").multiple(true))]
#[command(group = ArgGroup::new("truth").multiple(true))]
pub struct Arguments {
    /// A built-in scene or a scene file
    #[arg(value_name = "SCENE|FILE.json", default_value = "castle")]
    pub scene: PathBuf,

    #[command(flatten)]
    pub chosen: Chosen,

    /// Width and height in pixels, each from 1 to 65535
    #[arg(long, value_name = "WxH", default_value = "320x320", value_parser = size)]
    pub size: Size,

    /// How often a ray is reflected, from 0 to 255
    #[arg(long, value_name = "N", default_value_t = 4)]
    #[arg(allow_negative_numbers = true, value_parser = value_parser!(u8))]
    pub reflections: u8,

    /// How light shines on a surface
    #[arg(long, default_value = "blinn-phong", hide_possible_values = true)]
    #[arg(value_name = "blinn-phong|phong|normals")]
    pub shading: Shading,

    /// How exactly fixed point computes
    #[arg(long, default_value = "fast", hide_possible_values = true)]
    #[arg(value_name = "fast|small|exact")]
    quality: Quality,

    /// Draw smooth edges in the quality fast: K is 2, or 4 for finer ones
    #[arg(long, value_name = "K", num_args = 0..=1, default_missing_value = "4")]
    #[arg(value_parser = smooth, conflicts_with_all = ["quality", "reference"])]
    smooth: Option<Quality>,

    /// Take N x N samples of the reference for each pixel, from 1 to 32 [default: 1, or 9 with --smooth]
    #[arg(long, value_name = "N", requires = "truth")]
    #[arg(allow_negative_numbers = true, value_parser = value_parser!(u32).range(1..=32))]
    samples: Option<u32>,

    /// Dither the picture for a display with such colours, after any comparison
    #[arg(long, hide_possible_values = true)]
    #[arg(value_name = "rgb565|gray4|gray2|binary")]
    pub dither: Option<Levels>,

    /// Write the picture to a PNG file, over an older one, or to standard output if F.png is -
    #[arg(short, long, value_name = "F.png")]
    pub out: Option<PathBuf>,

    /// Write the picture to a file of width * height * 3 bytes, RGB8 from the top left, over an older
    /// one, or to standard output if F.rgb is -
    #[arg(long, value_name = "F.rgb")]
    pub raw: Option<PathBuf>,

    /// Render the double-precision reference instead
    #[arg(long, group = "truth")]
    pub reference: bool,

    /// Print the error of fixed point against the reference
    #[arg(long, group = "truth")]
    pub check: bool,

    /// Print what the scene needs of the library, what is left out and why; draw nothing
    #[arg(long, conflicts_with_all = ["out", "raw", "reference", "check", "window", "size", "dither"])]
    pub needs: bool,

    /// Draw N frames while the camera orbits its target once, from 2 to 360 (feature `film`)
    #[arg(long, value_name = "N", requires = "film")]
    #[arg(allow_negative_numbers = true, value_parser = value_parser!(u16).range(2..=360))]
    #[arg(conflicts_with_all = ["out", "raw", "reference", "check", "needs", "json", "window"])]
    pub orbit: Option<u16>,

    /// Write the frames to a GIF file that repeats without end, over an older one, or to standard output
    /// if F.gif is -
    #[arg(long, value_name = "F.gif", group = "film", requires = "orbit")]
    pub gif: Option<PathBuf>,

    /// Write the frames to a folder as frame-000.png and so on, over older ones; the folder is made if it
    /// is missing
    #[arg(long, value_name = "DIR", group = "film", requires = "orbit")]
    pub frames: Option<PathBuf>,

    /// Print one line of JSON and nothing else
    #[arg(long)]
    pub json: bool,

    /// Show the scene in a window (feature `window`)
    #[arg(long)]
    pub window: bool,

    /// Read the scene file again when it changes, with --window
    #[arg(long, requires = "window")]
    pub watch: bool,
}

impl Arguments {
    /// Tests whether a picture goes to standard output. Then all messages go to standard error.
    pub fn picture_is_printed(&self) -> bool {
        let mut paths = [&self.out, &self.raw, &self.gif].into_iter().flatten();
        paths.any(|path| is_standard_output(path))
    }

    /// Returns how many samples of the reference are taken along each side of a pixel.
    pub fn samples(&self) -> u32 {
        self.samples
            .unwrap_or(if self.smooth.is_some() { 9 } else { 1 })
    }

    /// Returns the settings with which the picture is drawn: reflections, shading and quality.
    pub fn settings(&self) -> Settings {
        Settings {
            reflections: self.reflections,
            shading: self.shading,
            quality: self.smooth.unwrap_or(self.quality),
        }
    }
}

/// Parses how smooth edges are.
fn smooth(rows: &str) -> Result<Quality, &'static str> {
    match rows {
        "2" => Ok(Quality::Smooth2),
        "4" => Ok(Quality::Smooth4),
        _ => Err("not 2 or 4"),
    }
}

fn after_help() -> String {
    format!(
        "\
Built-in scenes: {}.

A name with a dot or a slash in it is a file: JSON, one scene or an array of scenes.

With none of --out, --raw, --check, --json, --needs and --window the picture is written to NAME.png in the
current folder, or to NAME-2.png and so on where that exists. --out and --raw write over a file that
exists. Where one of them is -, standard output is the picture and all words go to standard error.

--json prints the keys scene, size, reflections, shading, quality (`reference` where fixed point
is not rendered) and seconds (for the picture alone), and with --check same, within1, within8
(shares of the pixels, from 0 to 1), psnr (in dB, null where the pictures are the same) and max;
with --needs it prints scene, quality and needs, a list of name, is_needed and why.

A frame of a film is shown for 600/N hundredths of a second, but for 2 at least and 10 at most. All frames
of a GIF share 256 colours.

In the window the arrow keys move the camera around its target, + and - change the number of
reflections, S changes between jagged and smooth edges, Tab shows the next scene and Escape leaves.

The exit code is 0, or 2 after an error, which is one line.",
        scenes::NAMES.join(", ")
    )
}
