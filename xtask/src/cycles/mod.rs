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

pub use self::timing::Timing;
use self::{decode::Code, trace::Watch};
use crate::emulator::qemu::Qemu;

/// What was seen of a program.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Estimate {
    /// Instructions that were executed.
    pub instructions: u64,
    /// Cycles they take, by the timings.
    pub cycles: f64,
}

impl Estimate {
    /// Cycles an instruction.
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
    let unreadable = || format!("cannot read {}", program.display());
    let bytes = fs::read(program).with_context(unreadable)?;
    let file = object::File::parse(&*bytes).with_context(unreadable)?;
    let mut code = Code::of(&file)?;
    let mut watch = Watch::over(trace::functions(&file, wanted));
    let mut sum = Estimate::default();
    let mut broken = None;
    // The last two addresses of the part that is watched.
    let mut past: [Option<u32>; 2] = [None; 2];
    emulator.trace(program, |address| {
        if let [before, Some(now)] = past {
            match code.step(before, now, address) {
                Ok(step) => {
                    sum.instructions += 1;
                    sum.cycles += timing.cycles(&step);
                }
                Err(error) => {
                    broken = Some(error);
                    return ControlFlow::Break(());
                }
            }
        }
        past = match watch.sees(address, &code) {
            true => [past[1], Some(address)],
            false => [None; 2],
        };
        ControlFlow::Continue(())
    })?;
    match broken {
        Some(error) => Err(error),
        None => {
            ensure!(sum.instructions > 0, "none of what is wanted was executed");
            Ok(sum)
        }
    }
}
