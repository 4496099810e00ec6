//! Emulated boards. [`qemu`] boots a firmware under a time limit and collects its output, [`qmp`]
//! controls QEMU's keys and display, and [`rp2040`] does all of this for the RP2040.

pub mod qemu;
pub mod qmp;
pub mod rp2040;
