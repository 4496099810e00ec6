//! `cargo xtask measure --moving`: what a scene takes of which one shape moves, beside the same scene as
//! a constant. The pictures of both must be the same, to the bit.

use anyhow::{Context, Result, ensure};
use command_line::json_line;
use serde::{Deserialize, Serialize};

use super::figures::{self, Figures};
use super::firmware::{self, RUN_LIMIT};
use super::task::{Quality, Task};
use crate::misuse::Misuse;
use crate::print;

/// One row. In JSON the keys are the names of the fields, after those of [`Figures`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct MovingFigures {
    /// Figures of a frame that is drawn after the move. The scene is on the stack.
    #[serde(flatten)]
    pub frame: Figures,
    /// Executed instructions of one move, such as `set_sphere`.
    pub move_instructions: u64,
    pub constant_flash: u64,
    /// Executed instructions a pixel of the constant scene, preparation included.
    pub constant_instructions_per_pixel: f64,
}

/// Measures a task with a shape that moves and prints the figures.
pub fn run(task: &Task, is_json: bool) -> Result<()> {
    let figures = measure(task)?;
    let text = if is_json {
        json_line(&serde_json::to_string(&figures).context("figures are plain")?)
    } else {
        table(&figures)
    };
    print(text + "\n")
}

/// Measures a task with a shape that moves, and as a constant with the same motion box: the box can
/// change the grid of the scene.
///
/// # Errors
/// [`Misuse`] if nothing can move; or the pictures differ.
pub fn measure(task: &Task) -> Result<MovingFigures> {
    if task.settings.quality == Quality::Float {
        return Err(Misuse::new("nothing moves in the float port").into());
    }
    let with = |moves| -> Result<Task> {
        let mut task = task.clone();
        task.scene = task.scene.with_motion(moves)?;
        Ok(task)
    };
    let moving = with(true)?;
    let (frame, still) = (super::measure(&moving)?, super::count(&with(false)?)?);
    ensure!(
        frame.hash == still.hash,
        "the moving scene draws another picture: {} instead of {}",
        frame.hash,
        still.hash
    );
    Ok(MovingFigures {
        frame,
        move_instructions: move_instructions(&moving)?,
        constant_flash: still.flash,
        constant_instructions_per_pixel: still.instructions_per_pixel,
    })
}

fn move_instructions(task: &Task) -> Result<u64> {
    let emulator = task.core.counting_emulator().limit(RUN_LIMIT);
    let said = firmware::with_program(task, |program| Ok(emulator.run(program)?))?;
    moved(&said).with_context(|| format!("the firmware reports no move, but: {said}"))
}

/// Finds the instructions of the move in what the firmware says.
pub(super) fn moved(said: &str) -> Option<u64> {
    let mut lines = said.lines();
    let digits = lines.find_map(|line| line.strip_prefix("moved instructions="))?;
    u64::from_str_radix(digits, 16).ok()
}

fn table(figures: &MovingFigures) -> String {
    let (flash, constant) = (figures.frame.flash, figures.constant_flash);
    let percent = 100.0 * flash as f64 / constant as f64;
    format!(
        "{}\n\n\
         flash of the constant scene: {constant}; with a shape that moves: {percent:.1} % of it\n\
         instructions a pixel of the constant scene: {:.1}\n\
         instructions of a move: {}",
        figures::table(std::slice::from_ref(&figures.frame)),
        figures.constant_instructions_per_pixel,
        figures.move_instructions,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn move_is_found_in_what_the_firmware_says() {
        let said = "noise\nmoved instructions=00000000000000ff\nmeasured a=1";
        assert_eq!(moved(said), Some(255));
        assert_eq!(moved("measured instructions=00ff"), None);
    }
}
