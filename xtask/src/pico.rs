//! The Raspberry Pi Pico, examples/pico in rp2040js: builds its firmware, emulates it, and captures
//! its display.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result};
use image::{Rgb, RgbImage};
use reflet::scenes::NAMES;

use crate::emulator::rp2040::{Key, Picture, Rp2040, SIDE};
use crate::screenshot::Arguments;
use crate::{screenshot, toolchain};

const TARGET: &str = "thumbv6m-none-eabi";

pub fn run(arguments: &Arguments) -> Result<()> {
    let file = arguments.file("pico")?;
    println!("pico: building");
    let firmware = build()?;
    println!("pico: emulating, which may take some minutes");
    let place = NAMES.iter().position(|name| *name == arguments.scene);
    let presses = vec![Key::Select; place.context("the names of the scenes are known")?];
    let run = Rp2040::default().picture(&presses).run(&firmware)?;
    run.said.iter().for_each(|line| println!("{line}"));
    let picture = run.pictures.first().context("one was waited for")?;
    screenshot::save(&as_seen(picture), file)
}

pub fn build() -> Result<PathBuf> {
    toolchain::build_alone(TARGET, Path::new("examples/pico"), &[])
}

fn as_seen(picture: &Picture) -> RgbImage {
    let scaled = |value: u16, most: u16| ((value * 255 + most / 2) / most) as u8;
    RgbImage::from_fn(SIDE, SIDE, |x, y| {
        let pixel = picture.pixels[(y * SIDE + x) as usize];
        Rgb([
            scaled(pixel >> 11, 31),
            scaled(pixel >> 5 & 63, 63),
            scaled(pixel & 31, 31),
        ])
    })
}
