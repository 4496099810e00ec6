//! `cargo xtask profile`: counts the instructions of a frame, by stage and by function.
//!
//! [`record`] counts every executed instruction with the [`calls`] that led to it, from the trace
//! that [`crate::cycles`] estimates cycles from. [`names`] finds the functions at an address,
//! inlined ones too. [`stages`] gives each function its stage. [`sums`] adds up, and [`print`]
//! prints. No instruction is left out or estimated from samples, so the stages add up to the total.

mod calls;
pub mod names;
mod print;
mod record;
mod stages;
mod sums;

use anyhow::{Result, bail};
use clap::Args;

pub use self::stages::{STAGES, Stage};
pub use self::sums::{Sums, Table};
use self::{names::Names, record::Record};
use crate::measure::{Quality, Task, arguments::Choice, pixels, with_program};
use crate::misuse::Misuse;

/// Counts the instructions that a frame takes, by stage and by function.
#[derive(Args, Debug)]
#[command(after_long_help = include_str!("help.txt").trim_end())]
pub struct Arguments {
    #[command(flatten)]
    choice: Choice,

    /// Print the hottest functions, too
    #[arg(long)]
    functions: bool,

    /// How many rows each table of functions has at most
    #[arg(long, value_name = "N", default_value_t = 40, requires = "functions")]
    top: usize,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let task = arguments.choice.task()?;
    let sums = profile(&task)?;
    let rows = arguments.functions.then_some(arguments.top);
    let pixels = pixels(task.settings.size);
    crate::print(print::tables(&sums, pixels, rows))
}

/// Counts the instructions of one frame, by stage and by function.
///
/// # Errors
/// [`Misuse`] for a core or a quality that cannot be profiled.
pub fn profile(task: &Task) -> Result<Sums> {
    if task.core.name == "rv32" {
        bail!(Misuse::new(
            "rv32 cannot be profiled: calls are followed in Arm's instructions only"
        ));
    }
    if task.settings.quality == Quality::Float {
        bail!(Misuse::new(
            "the float port cannot be profiled: the stages are the library's"
        ));
    }
    with_program(task, |program| {
        let names = Names::read(program)?;
        let record = Record::of(task.core.emulator(), program, &names)?;
        Ok(Sums::of(&record, &names))
    })
}
