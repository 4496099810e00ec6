//! Boards that people own, emulated: runs the very ELF file that is flashed, from the reset to the
//! picture on an ST7789 of 240 by 240 pixels.
//!
//! The cores are those of the crates `rp2040-emu` and `rp2350-emu`; memory, peripherals, wires and
//! panel are written here and strict: an address that no table names, a pin without its function, or
//! a command that the panel does not know ends the run with a [`Failure`]. A run gives the same
//! pictures and counts every time.
//!
//! Not emulated: interrupts of peripherals, boot ROMs, and times of a real flash. Private registers
//! of a Cortex-M33 are those of its crate, which are not strict.

#![forbid(unsafe_code)]

mod board;
mod chip;
mod core;
mod elf;
mod execute;
mod fault;
mod keys;
mod machine;
mod memory;
mod panel;
mod registers;
mod rtt;
mod run;
mod serial;
mod system;
mod wires;

pub use board::{Board, ChipKind};
pub use chip::bus_time::BusTime;
pub use execute::{Registers, execute};
pub use fault::{Failure, Fault};
pub use keys::Key;
pub use panel::SIDE;
pub use run::{Display, Picture, Run, Script};
pub use wires::{GROUND, Pin, Wiring};
