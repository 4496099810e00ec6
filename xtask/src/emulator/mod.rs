//! Emulated boards: [`qemu`] boots a firmware under a time limit and hears what it says, [`qmp`]
//! presses its keys and looks at its display; [`rp2040`] does all of it for the RP2040.

pub mod qemu;
pub mod qmp;
pub mod rp2040;
