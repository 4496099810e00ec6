//! Saves the picture of a board's display: over the file that the user named, or in a new one.

use std::io::Cursor;
use std::path::{PathBuf, absolute};

use anyhow::{Error, Result};
use clap::{Args, builder::PossibleValuesParser};
use command_line::{OutputFile, shown};
use image::{ImageFormat, RgbImage};
use reflet::scenes::NAMES;

use crate::misuse::Misuse;

/// Command-line arguments of the chores that save a picture: the scene and the file.
#[derive(Args, Debug)]
pub struct Arguments {
    /// The built-in scene to go to
    #[arg(value_name = "SCENE", default_value = NAMES[0])]
    #[arg(value_parser = PossibleValuesParser::new(NAMES))]
    pub scene: String,

    /// Where the picture goes, over an older one [default: BOARD-SCENE.png, with a number if that is taken]
    #[arg(long, value_name = "F.png")]
    pub screenshot: Option<PathBuf>,
}

impl Arguments {
    /// Returns the file of the picture. Fails before the work begins if it cannot be written.
    pub fn file(&self, board: &str) -> Result<OutputFile> {
        let file = match &self.screenshot {
            None => OutputFile::free_png(&absolute(format!("{board}-{}.png", self.scene))?),
            Some(path) => OutputFile::png_at(&absolute(path)?),
        };
        Ok(file.map_err(Misuse::new)?)
    }
}

/// Writes a picture as PNG and prints the path of the file.
pub fn save(picture: &RgbImage, file: OutputFile) -> Result<()> {
    let mut bytes = Cursor::new(Vec::new());
    picture.write_to(&mut bytes, ImageFormat::Png)?;
    let path = file.write(bytes.get_ref()).map_err(Error::from_boxed)?;
    println!("written to {}", shown(&path));
    Ok(())
}
