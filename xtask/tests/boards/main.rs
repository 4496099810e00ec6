//! Tests the boards that people own: copies of the examples' folders, built as a person builds them, and
//! run from the reset on emulated boards.

mod castle;
#[path = "../common/mod.rs"]
mod common;
mod refill;
mod wiring;

use std::path::PathBuf;
use std::sync::OnceLock;

use boards::Board;
use xtask::copies;
use xtask::owned::Owned;

/// A board, and the firmware that a copy of its example builds.
pub struct Copied {
    pub owned: &'static Owned,
    built: OnceLock<PathBuf>,
}

pub static PICO: Copied = Copied::of(&xtask::owned::PICO);
pub static PICO_2: Copied = Copied::of(&xtask::owned::PICO_2);
pub static BLACK_PILL: Copied = Copied::of(&xtask::owned::BLACK_PILL);

impl Copied {
    const fn of(owned: &'static Owned) -> Self {
        let built = OnceLock::new();
        Self { owned, built }
    }

    fn board(&self) -> &Board {
        &self.owned.board
    }

    /// Builds the copy once.
    fn firmware(&self) -> &PathBuf {
        self.built
            .get_or_init(|| copies::firmware(self.owned.name).unwrap())
    }
}
