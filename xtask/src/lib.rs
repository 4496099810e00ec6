//! The chores of the repository. Each module is one chore or one part that several share.

pub mod accuracy;
pub mod apt;
pub mod board;
pub mod command;
pub mod copies;
pub mod count;
pub mod cycles;
pub mod emulator;
mod film;
pub mod fuzz;
pub mod gate;
pub mod kept;
pub mod measure;
pub mod misuse;
pub mod need;
pub mod owned;
pub mod playground;
pub mod profile;
pub mod scene_source;
pub mod screenshot;
pub mod setup;
pub mod size;
pub mod sweep;
pub mod table;
pub mod toolchain;

use std::env;
use std::path::{Path, PathBuf};

use anyhow::{Context, Error, Result};

/// Prints on standard output. A closed pipe is no error.
fn print(text: impl AsRef<[u8]>) -> Result<()> {
    command_line::print(text).map_err(Error::from_boxed)
}

pub fn root() -> PathBuf {
    let package = Path::new(env!("CARGO_MANIFEST_DIR"));
    package
        .parent()
        .expect("xtask lies in the repository")
        .to_owned()
}

/// Makes the repository's folder the current one, so that cargo finds the repository's
/// configuration.
pub fn enter_root() -> Result<()> {
    let root = root();
    env::set_current_dir(&root).with_context(|| format!("cannot enter {}", root.display()))
}
