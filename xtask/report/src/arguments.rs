//! The command line; it never opens a file.

use std::path::{Path, PathBuf};

use clap::{Parser, ValueEnum, value_parser};
use embedded_graphics::geometry::Size;
use reflet::scenes;

use command_line::Failure;
use command_line::{in_one_line, size};

/// Measures what scenes cost and lose under many settings, and writes a report of it.
#[derive(Parser)]
#[command(name = "report", max_term_width = 100, after_long_help = after_help())]
pub struct Arguments {
    /// Built-in scenes or scene files [default: all built-in scenes]
    #[arg(value_name = "SCENE|FILE.json")]
    pub scenes: Vec<PathBuf>,

    /// The scene to take from a file that holds several
    #[arg(long = "scene", value_name = "NAME")]
    pub chosen: Option<String>,

    /// Where it runs
    #[arg(long, default_value = "m3", hide_possible_values = true)]
    #[arg(value_name = "m0|m3|m4f|rv32|host")]
    pub core: Core,

    /// The folder of the report; made if there is none, files of an earlier report are replaced
    #[arg(long, value_name = "DIR", default_value = "error-time")]
    pub out: PathBuf,

    /// The folder of what was counted before [default: report in cargo's target folder]
    #[arg(long, value_name = "DIR")]
    pub counts: Option<PathBuf>,

    /// Width and height in pixels, each from 1 to 1024
    #[arg(long, value_name = "WxH", default_value = "128x128", value_parser = small_size)]
    pub size: Size,

    /// Try no more reflections than this, from 0 to 255
    #[arg(
        long,
        value_name = "N",
        default_value_t = 255,
        allow_negative_numbers = true
    )]
    #[arg(value_parser = value_parser!(u8))]
    pub reflections: u8,
}

/// Where it runs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Core {
    M0,
    M3,
    M4f,
    Rv32,
    Host,
}

impl Core {
    /// The word on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::M0 => "m0",
            Self::M3 => "m3",
            Self::M4f => "m4f",
            Self::Rv32 => "rv32",
            Self::Host => "host",
        }
    }

    /// Its name in prose.
    pub fn title(self) -> &'static str {
        match self {
            Self::M0 => "Cortex-M0",
            Self::M3 => "Cortex-M3",
            Self::M4f => "Cortex-M4F",
            Self::Rv32 => "RV32IMAC",
            Self::Host => "this machine",
        }
    }

    /// What is counted on it.
    pub fn unit(self) -> &'static str {
        match self {
            Self::Host => "% of the reference's time",
            _ => "instructions a pixel",
        }
    }
}

impl Arguments {
    /// What the command line says, or the line that says what is wrong with it.
    ///
    /// Prints the help and ends the program where that is what was asked for.
    pub fn read() -> Result<Self, Failure> {
        let mut arguments = Self::try_parse().map_err(|error| {
            if !error.use_stderr() {
                error.exit();
            }
            Failure::from(in_one_line(&error))
        })?;
        if arguments.scenes.is_empty() {
            arguments.scenes = scenes::NAMES.map(PathBuf::from).into();
        }
        Ok(arguments)
    }
}

impl Arguments {
    /// The command that makes the same report, wherever it was written to.
    pub fn command(&self) -> String {
        let Size { width, height } = self.size;
        let mut command = "cargo run --release --package report --".to_owned();
        if !self
            .scenes
            .iter()
            .map(PathBuf::as_path)
            .eq(scenes::NAMES.map(Path::new))
        {
            command.extend(self.scenes.iter().map(|it| format!(" {}", it.display())));
        }
        if let Some(name) = &self.chosen {
            command += &format!(" --scene {name}");
        }
        command += &format!(" --core {} --size {width}x{height}", self.core.name());
        if self.reflections < u8::MAX {
            command += &format!(" --reflections {}", self.reflections);
        }
        command.replace(char::is_control, " ")
    }
}

fn small_size(text: &str) -> Result<Size, &'static str> {
    let found = size(text).ok();
    let is_small = |size: &Size| size.width <= 1024 && size.height <= 1024;
    found
        .filter(is_small)
        .ok_or("not a width and a height from 1 to 1024, such as 128x128")
}

fn after_help() -> String {
    format!(
        "\
Built-in scenes: {}.

A name with a dot or a slash in it is a file: JSON, one scene or an array of scenes.

The error is that of the 8-bit picture against double precision that follows every reflection. The
run time is counted: executed instructions of the whole frame on an emulated core, over its pixels;
on `host` it is measured, all settings in turn, as a share of the time of the double-precision
reference, on one thread, and given with its quartiles.

What was counted is kept in the folder --counts, a file for each scene, core and size, written after every setting: what is interrupted goes on where it was, and a second report counts only what has
changed since.

Written are points.csv with all settings, front.rs with the best ones as Rust source, index.md and
index.html, which holds its pictures, and plots and pictures for each scene.

The exit code is 0, or 2 after an error, which is one line.",
        scenes::NAMES.join(", ")
    )
}
