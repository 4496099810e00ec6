//! Where the picture of a board's display goes: a file that is not written over.

use std::fs::File;
use std::path::{Path, PathBuf, absolute};
use std::{env, io};

use anyhow::{Context, Result};
use clap::{Args, builder::PossibleValuesParser};
use image::{ImageFormat, RgbImage};
use reflet::scenes::NAMES;

use crate::misuse::Misuse;

/// What is to be seen, and where it goes.
#[derive(Args, Debug)]
pub struct Arguments {
    /// The scene to go to
    #[arg(long, default_value = NAMES[0], value_parser = PossibleValuesParser::new(NAMES))]
    pub scene: String,

    /// Where the picture goes [default: BOARD-SCENE.png, with a number if that is taken]
    #[arg(long, value_name = "F.png")]
    pub screenshot: Option<PathBuf>,
}

impl Arguments {
    /// Where the picture goes; known to be free before the work begins.
    pub fn path(&self, board: &str) -> Result<PathBuf> {
        let Some(path) = &self.screenshot else {
            return Ok(free_path(&env::current_dir()?, board, &self.scene));
        };
        let path = absolute(path)?;
        if path.symlink_metadata().is_ok() {
            let words = format!("{} exists and is not written over", path.display());
            return Err(Misuse::new(words).into());
        }
        Ok(path)
    }
}

/// `BOARD-SCENE.png` in a folder, or the first of `BOARD-SCENE-2.png`, `-3.png` that is free.
fn free_path(folder: &Path, board: &str, scene: &str) -> PathBuf {
    let numbered = (2..).map(|number| format!("{board}-{scene}-{number}.png"));
    [format!("{board}-{scene}.png")]
        .into_iter()
        .chain(numbered)
        .map(|name| folder.join(name))
        .find(|path| path.symlink_metadata().is_err())
        .expect("the numbers do not end")
}

/// Writes a picture to a path where nothing is yet.
pub fn save(picture: &RgbImage, path: &Path) -> Result<()> {
    let written = || -> Result<()> {
        let mut file = io::BufWriter::new(File::create_new(path)?);
        Ok(picture.write_to(&mut file, ImageFormat::Png)?)
    };
    written().with_context(|| format!("{} cannot be written", path.display()))?;
    println!("written to {}", path.display());
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn path_without_a_number_comes_first() {
        let folder = tempfile::tempdir().unwrap();
        let free = || free_path(folder.path(), "board", "castle");
        assert_eq!(free(), folder.path().join("board-castle.png"));
        File::create_new(free()).unwrap();
        assert_eq!(free(), folder.path().join("board-castle-2.png"));
        File::create_new(free()).unwrap();
        assert_eq!(free(), folder.path().join("board-castle-3.png"));
    }
}
