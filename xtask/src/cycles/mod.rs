//! Estimates the cycles that a program takes, from the instructions it executes and the timings that
//! Arm publishes.
//!
//! [`trace`] selects the executed instructions that are counted, [`decode`] decodes them, and
//! [`timing`] gives their cycles. The estimate assumes memory without wait states. Where Arm gives a
//! range, it takes the middle. A real chip also waits for its flash.

mod decode;
mod timing;
mod trace;

use std::{fs, path::Path};

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

/// Runs a program and estimates the cycles of the functions whose symbols are `wanted`, with all
/// functions that they call.
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

/// Addresses of an executed instruction, of the counted one before it, and of the next one. `before`
/// is `None` for the first instruction of a counted function that uncounted code called.
#[derive(Clone, Copy, Debug)]
pub struct Executed {
    pub before: Option<u32>,
    pub now: u32,
    pub next: u32,
}

/// Runs a program and calls `see` for every executed instruction of the functions whose symbols are
/// `wanted`, and of all functions that they call.
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
    let mut is_seen = false;
    // The last two executed addresses, while the watched functions run.
    let mut past: [Option<u32>; 2] = [None; 2];
    emulator.trace(program, |next| {
        if let [before, Some(now)] = past {
            is_seen = true;
            see(&mut code, Executed { before, now, next })?;
        }
        past = if watch.sees(next, &code) { [past[1], Some(next)] } else { [None; 2] };
        Ok(())
    })?;
    ensure!(is_seen, "none of what is wanted was executed");
    Ok(())
}
