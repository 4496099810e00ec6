//! What can go wrong: a fault is one line about the firmware or the wiring, a failure is what a run
//! returns.

use std::io;

/// Error of the firmware or of the wiring, in one line.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Fault(pub String);

/// Returns a fault with a formatted line.
macro_rules! fault {
    ($($line:tt)*) => { crate::fault::Fault(format!($($line)*)) };
}

/// Returns from a function with a fault if a condition does not hold.
macro_rules! require {
    ($condition:expr, $($line:tt)*) => {
        if !$condition {
            return Err(crate::fault::fault!($($line)*));
        }
    };
}

pub(crate) use {fault, require};

/// Why a run gave no pictures.
#[derive(Debug, thiserror::Error)]
pub enum Failure {
    /// The file of the firmware cannot be read.
    #[error("the firmware cannot be read: {0}")]
    File(#[from] io::Error),
    /// The file of the firmware is no ELF file for this board.
    #[error("the firmware is no program for this board: {0}")]
    Program(String),
    /// The firmware or the wiring is wrong.
    #[error("{fault}, at {pc:#010x} of core {core}{}", quoted(said))]
    Firmware {
        fault: Fault,
        /// Address of the instruction.
        pc: u32,
        core: usize,
        /// Lines that the firmware printed before.
        said: Vec<String>,
    },
}

fn quoted(said: &[String]) -> String {
    match said {
        [] => String::new(),
        _ => format!("; it said:\n{}", said.join("\n")),
    }
}
