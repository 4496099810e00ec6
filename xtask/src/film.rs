//! Films what the display of a board shows while the demo of its example moves.

use std::path::Path;

use anyhow::{Context, Error, Result};
use boards::{SIDE, Script};
use command_line::{OutputFile, shown};

use crate::misuse::Misuse;
use crate::owned::{Owned, rgb};

#[path = "../../examples/render/palette.rs"]
mod palette;

/// Milliseconds that are filmed. The ball bounces for 4000 after it is thrown, and the key is held for some of them.
const FILMED: u32 = 3600;

/// Milliseconds for which a frame of the film is shown, at least.
const SHOWN: u32 = 130;

/// Width and height in pixels of the panel that one pixel of the film shows: what moves is drawn in pixels of that
/// size.
const SCALE: usize = 2;

/// Emulates the demo of a board, whose key throws the ball, almost until the ball rests. Writes a film to a
/// file.
pub fn run(board: &Owned, path: &Path) -> Result<()> {
    let file = OutputFile::gif_at(path).map_err(Misuse::new)?;
    println!("{}: building", board.name);
    let firmware = board.build_program("bounce")?;
    println!("{}: emulating", board.name);
    // The key is pressed when the board has started, and held during some frames.
    let started = Script::default().frames().picture(&[]);
    let mut script = started.picture(&[board.throws]);
    for _ in 0..FILMED / board.frame {
        script = script.picture(&[]);
    }
    let run = board.board.run(&firmware, &script)?;
    let step = SHOWN.div_ceil(board.frame);
    let pictures = run.pictures.iter().step_by(step as usize);
    let frames: Vec<_> = pictures.map(|it| small(&it.pixels)).collect();
    let delay = u16::try_from(step * board.frame / 10)?;
    let side = u16::try_from(SIDE / SCALE).context("a panel is small")?;
    let bytes = palette::encoded(&frames, [side; 2], delay)?;
    let path = file.write(&bytes).map_err(Error::from_boxed)?;
    println!("{} frames written to {}", frames.len(), shown(&path));
    Ok(())
}

/// Returns every other pixel of every other row of a picture, in RGB8.
fn small(pixels: &[u16]) -> Vec<u8> {
    let rows = pixels.chunks_exact(SIDE).step_by(SCALE);
    rows.flat_map(|row| row.iter().step_by(SCALE))
        .flat_map(|pixel| rgb(*pixel))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn picture_of_a_film_has_every_other_pixel() {
        let mut pixels = vec![0; SIDE * SIDE];
        pixels[2 * SIDE + 4] = 31;
        let small = small(&pixels);
        assert_eq!(small.len(), 3 * (SIDE / SCALE) * (SIDE / SCALE));
        assert_eq!(small[3 * (SIDE / SCALE + 2)..][..3], [0, 0, 255]);
    }
}
