//! An estimate of the cycles that a program takes, from the instructions it executes and the
//! timings that Arm publishes.
//!
//! [`trace`] finds out which instructions are executed, [`decode`] what they are, and [`timing`]
//! what they take. Memory is taken to be as fast as the core; where Arm gives a range, its middle
//! is taken. A real chip waits for its flash, too.

mod decode;
mod timing;
mod trace;

use std::{fs, ops::ControlFlow, path::Path};

use anyhow::{Context, Result, ensure};

use self::trace::Watch;
pub use self::{decode::Code, timing::Timing};
use crate::emulator::qemu::Qemu;

#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    pub instructions: u64,
    pub cycles: f64,
}

impl Estimate {
    pub fn per_instruction(self) -> f64 {
        self.cycles / self.instructions as f64
    }
}

/// Runs a program and adds up the instructions of the functions whose symbols are `wanted`, with
/// all that they call.
pub fn estimate(
    emulator: Qemu,
    program: &Path,
    timing: Timing,
    wanted: impl Fn(&str) -> bool,
) -> Result<Estimate> {
    let mut sum = Estimate::default();
    watch(emulator, program, wanted, |code, executed| {
        let Executed { before, now, next } = executed;
        sum.instructions += 1;
        sum.cycles += timing.cycles(&code.step(before, now, next)?);
        Ok(())
    })?;
    Ok(sum)
}

/// An executed instruction: the addresses of what came before it in what is watched, of itself,
/// and of what comes next.
#[derive(Clone, Copy, Debug)]
pub struct Executed {
    pub before: Option<u32>,
    pub now: u32,
    pub next: u32,
}

/// Runs a program and shows `see` every instruction of the functions whose symbols are `wanted`,
/// and of all that they call.
pub fn watch(
    emulator: Qemu,
    program: &Path,
    wanted: impl Fn(&str) -> bool,
    mut see: impl FnMut(&mut Code, Executed) -> Result<()>,
) -> Result<()> {
    let unreadable = || format!("cannot read {}", program.display());
    let bytes = fs::read(program).with_context(unreadable)?;
    let file = object::File::parse(&*bytes).with_context(unreadable)?;
    let mut code = Code::of(&file)?;
    let mut watch = Watch::over(trace::functions(&file, wanted));
    let (mut is_seen, mut broken) = (false, None);
    // The last two addresses of the part that is watched.
    let mut past: [Option<u32>; 2] = [None; 2];
    emulator.trace(program, |next| {
        if let [before, Some(now)] = past {
            is_seen = true;
            if let Err(error) = see(&mut code, Executed { before, now, next }) {
                broken = Some(error);
                return ControlFlow::Break(());
            }
        }
        past = match watch.sees(next, &code) {
            true => [past[1], Some(next)],
            false => [None; 2],
        };
        ControlFlow::Continue(())
    })?;
    match broken {
        Some(error) => Err(error),
        None => {
            ensure!(is_seen, "none of what is wanted was executed");
            Ok(())
        }
    }
}
