//! Boards that people own: their table, which [`crate::measure`] estimates frames a second from. Builds
//! the firmware of an example, emulates it from the reset, and captures its display.

use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, Result};
use boards::{Board, Key, Picture, SIDE, Script};
use clap::Args;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor, raw::RawU16};
use image::{Rgb, RgbImage};
use reflet::scenes::NAMES;

use crate::copies::Example;
use crate::misuse::Misuse;
use crate::screenshot::Arguments;
use crate::{film, screenshot, toolchain};

/// Command-line arguments of the chores that emulate a board.
#[derive(Args, Debug)]
pub struct Asked {
    #[command(flatten)]
    picture: Arguments,

    /// Film the demo `bounce` instead, while its ball bounces, over an older file
    #[arg(long, value_name = "F.gif", conflicts_with_all = ["scene", "screenshot"])]
    film: Option<PathBuf>,
}

/// A board with a display of 240 by 240 pixels, and the example for it.
#[derive(Debug)]
pub struct Owned {
    /// Name of the board, which is also that of the chore.
    pub name: &'static str,
    pub title: &'static str,
    /// Name of the processor core, as `measure --core` takes it.
    pub core: &'static str,
    /// Cores that trace rows by turns.
    pub cores: u8,
    /// Milliseconds in which the board sends a frame: the emulated board takes them for the scene `empty`, of
    /// which hardly anything is traced.
    pub sending: f64,
    /// Milliseconds of `sending` during which a DMA sends, so that the next rows can be traced.
    pub hidden: f64,
    /// Milliseconds of a frame of the demo while something moves, as its program says.
    pub frame: u32,
    /// The key that throws the demo's ball.
    pub throws: Key,
    pub board: Board,
    /// Whether a key shows the next built-in scene. Otherwise the example only draws the first one.
    shows_all_scenes: bool,
}

pub static PICO: Owned = Owned {
    name: "pico",
    title: "Raspberry Pi Pico",
    core: "m0",
    cores: 2,
    sending: 32.0,
    hidden: 32.0,
    frame: 35,
    throws: Key::Right,
    board: Board::PICO,
    shows_all_scenes: true,
};

pub static PICO_2: Owned = Owned {
    name: "pico2",
    title: "Raspberry Pi Pico 2",
    core: "m33",
    cores: 2,
    sending: 43.0,
    hidden: 43.0,
    frame: 27,
    throws: Key::Right,
    board: Board::PICO_2,
    shows_all_scenes: false,
};

pub static BLACK_PILL: Owned = Owned {
    name: "blackpill",
    title: "Black Pill (STM32F411)",
    core: "m4f",
    cores: 1,
    sending: 52.0,
    hidden: 33.0,
    frame: 65,
    throws: Key::Select,
    board: Board::BLACK_PILL,
    shows_all_scenes: false,
};

/// All of them, in the order of the tables.
pub static ALL: [&Owned; 3] = [&PICO, &PICO_2, &BLACK_PILL];

impl Owned {
    pub fn parser() -> impl TypedValueParser<Value = &'static Self> {
        let find = |name: String| ALL.into_iter().find(|board| board.name == name);
        PossibleValuesParser::new(ALL.map(|board| board.name))
            .map(move |name| find(name).expect("it is one of the possible values"))
    }

    /// Emulates the board until it shows a scene, prints what it took, and saves the picture; or films its demo.
    pub fn run(&self, asked: &Asked) -> Result<()> {
        if let Some(path) = &asked.film {
            return film::run(self, path);
        }
        let arguments = &asked.picture;
        let file = arguments.file(self.name)?;
        let presses = self.presses(&arguments.scene)?;
        println!("{}: building", self.name);
        let firmware = self.build()?;
        println!("{}: emulating", self.name);
        let start = Instant::now();
        let script = Script::default().picture(&presses);
        let run = self.board.run(&firmware, &script)?;
        run.said.iter().for_each(|line| println!("{line}"));
        println!(
            "{} cycles, {} instructions, {:.1} s of emulation",
            run.cycles,
            run.instructions,
            start.elapsed().as_secs_f64()
        );
        let picture = run.pictures.first().context("one was waited for")?;
        println!(
            "{:.1} % of the SPI's {} cycles hidden",
            100.0 * picture.bus.hidden(),
            picture.bus.sending
        );
        screenshot::save(&as_seen(picture), file)
    }

    /// Returns the keys that lead to a scene.
    fn presses(&self, scene: &str) -> Result<Vec<Key>> {
        let place = NAMES.iter().position(|name| *name == scene);
        let place = place.context("the names of the scenes are known")?;
        if place > 0 && !self.shows_all_scenes {
            let words = format!("the example for {} draws {} only", self.title, NAMES[0]);
            return Err(Misuse::new(words).into());
        }
        Ok(vec![Key::Select; place])
    }

    pub fn build(&self) -> Result<PathBuf> {
        self.build_program(Example::of(self.name)?.program)
    }

    /// Builds a program of the example in its place.
    pub fn build_program(&self, program: &str) -> Result<PathBuf> {
        let example = Example::of(self.name)?;
        toolchain::build_for_chip(example.target, &example.folder(), program)
    }
}

fn as_seen(picture: &Picture) -> RgbImage {
    RgbImage::from_fn(SIDE as u32, SIDE as u32, |x, y| {
        Rgb(rgb(picture.pixels[y as usize * SIDE + x as usize]))
    })
}

/// Returns a colour of the panel in RGB8.
pub fn rgb(pixel: u16) -> [u8; 3] {
    let color = Rgb888::from(Rgb565::from(RawU16::new(pixel)));
    [color.r(), color.g(), color.b()]
}
