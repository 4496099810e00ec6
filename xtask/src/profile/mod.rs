//! `cargo xtask profile`: where the instructions of a frame go, by stage and by function.
//!
//! [`record`] counts every executed instruction with the [`calls`] it was reached by, on the trace
//! that [`crate::cycles`] estimates cycles from; [`names`] finds the functions that stand at an
//! address, inlined ones too; [`stages`] says which stage a function belongs to; [`sums`] adds up
//! and [`print`] prints. Nothing is sampled and nothing left out, so the stages add up to the
//! total.

pub mod arguments;
mod calls;
pub mod names;
mod print;
mod record;
mod stages;
mod sums;

use std::io::{self, Write};

use anyhow::{Result, bail};

use self::{arguments::Arguments, names::Names, record::Record};
pub use self::{
    stages::{STAGES, Stage},
    sums::Sums,
};
use crate::{
    measure::{
        task::{Quality, Task},
        with_program,
    },
    misuse::Misuse,
};

/// Does what the command line asks for.
pub fn run(arguments: &Arguments) -> Result<()> {
    let task = arguments.choice.task()?;
    let sums = profile(&task)?;
    let rows = arguments.functions.then_some(arguments.top);
    let pixels = task.settings.size.pixels();
    let text = match arguments.json {
        true => print::json(&sums, pixels, rows),
        false => print::tables(&sums, pixels, rows),
    };
    write!(io::stdout(), "{text}")?;
    Ok(())
}

/// Counts the instructions of one frame.
///
/// # Errors
/// [`Misuse`] for a core or a quality whose stages are not known.
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
