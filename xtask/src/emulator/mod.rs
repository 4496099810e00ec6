//! Emulators of boards that nobody has to own: QEMU runs a firmware under a time limit and reports what
//! it says; [`qmp`] controls QEMU's keys and display.

pub mod qemu;
mod qmp;
