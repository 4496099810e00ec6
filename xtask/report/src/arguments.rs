//! Parses the command line of the report. Never opens a file.

use std::path::{Path, PathBuf};

use anyhow::{Result, anyhow};
use clap::{Parser, value_parser};
use command_line::{Chosen, parse, size};
use embedded_graphics::geometry::Size;
use reflet::scenes;
use xtask::measure::{Core, words};
use xtask::table::filled;

/// Measures what scenes cost and lose under many settings, and writes a report of it.
#[derive(Parser)]
#[command(name = "report", max_term_width = 100, after_long_help = after_help())]
pub struct Arguments {
    /// Built-in scenes or scene files [default: all built-in scenes]
    #[arg(value_name = "SCENE|FILE.json")]
    pub scenes: Vec<PathBuf>,

    #[command(flatten)]
    pub chosen: Chosen,

    /// The core on which it runs
    #[arg(long, default_value = "m3", value_parser = Core::parser())]
    pub core: &'static Core,

    /// The folder of the report; made if there is none, files of an earlier report are replaced
    #[arg(short, long, value_name = "DIR", default_value = "error-time")]
    pub out: PathBuf,

    /// Width and height in pixels, each from 1 to 1024
    #[arg(long, value_name = "WxH", default_value = "128x128", value_parser = small_size)]
    pub size: Size,

    /// Try no more reflections than this, from 0 to 255
    #[arg(long, value_name = "N", default_value_t = 255, value_parser = value_parser!(u8))]
    #[arg(allow_negative_numbers = true)]
    pub reflections: u8,
}

impl Arguments {
    /// Parses the command line. Without scenes, takes all built-in ones.
    ///
    /// If the command line asks for help, prints the help and exits. An error is one line.
    pub fn read() -> Result<Self> {
        let mut arguments: Self = parse().map_err(|failure| anyhow!(failure))?;
        if arguments.scenes.is_empty() {
            arguments.scenes = scenes::NAMES.map(PathBuf::from).into();
        }
        Ok(arguments)
    }

    /// Returns the command that makes the same report. Leaves out the output folder.
    pub fn command(&self) -> String {
        let mut command = "cargo run --release --package report --".to_owned();
        let all = scenes::NAMES.map(Path::new);
        if !self.scenes.iter().map(PathBuf::as_path).eq(all) {
            command.extend(self.scenes.iter().map(|it| format!(" {}", it.display())));
        }
        if let Some(name) = &self.chosen.name {
            command += &format!(" --scene {name}");
        }
        command += &format!(" --core {} --size {}", self.core.name, words(self.size));
        if self.reflections < u8::MAX {
            command += &format!(" --reflections {}", self.reflections);
        }
        command.replace(char::is_control, " ")
    }
}

fn small_size(text: &str) -> Result<Size, &'static str> {
    match size(text) {
        Ok(size) if size.width.max(size.height) <= 1024 => Ok(size),
        _ => Err("not a width and a height from 1 to 1024, such as 128x128"),
    }
}

fn after_help() -> String {
    let scenes = [("scenes", scenes::NAMES.join(", "))];
    filled(include_str!("help.txt").trim_end(), &scenes)
}
