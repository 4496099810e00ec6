//! The chores of the repository, one module a concern: [`accuracy`] measures pictures, [`setup`]
//! knows what a machine needs, [`gate`] what a change must pass, [`toolchain`] how to build for a
//! bare-metal target, [`emulator`] how to run what was built, [`board`] the default board, [`pico`]
//! the Raspberry Pi Pico, [`screenshot`] where their pictures go, [`measure`] what a scene takes,
//! [`profile`] which part of a frame takes it, [`scale`] how that grows with the number of shapes,
//! [`sweep`] what many settings of a scene take, for the report, [`size`] what is in flash, [`fuzz`]
//! draws what any bytes describe, [`cycles`] how instructions become cycles, [`scene_source`] makes
//! Rust of scene files, [`kept`] reads and writes what they keep, [`apt`] knows Debian's packages, [`command`] how to run another program and
//! [`table`] how a page shows figures.

pub mod accuracy;
pub mod apt;
pub mod board;
pub mod command;
pub mod cycles;
pub mod emulator;
pub mod fuzz;
pub mod gate;
pub mod kept;
pub mod measure;
pub mod misuse;
pub mod pico;
pub mod profile;
pub mod scale;
pub mod scene_source;
pub mod screenshot;
pub mod setup;
pub mod size;
pub mod sweep;
pub mod table;
pub mod toolchain;

use std::env;
use std::path::{Path, PathBuf};

use anyhow::{Context, Result};

pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package
        .parent()
        .expect("xtask lies in the repository")
        .to_owned()
}

/// Makes the folder of the repository the current one: its configuration is found from there.
pub fn enter_root() -> Result<()> {
    let root = root();
    env::set_current_dir(&root).with_context(|| format!("cannot enter {}", root.display()))
}
