//! Tests the boards that people own: copies of the examples' folders, built as a person builds them, and
//! run from the reset on emulated boards.

mod bounce;
mod castle;
#[path = "../common/mod.rs"]
mod common;
mod estimate;
mod wiring;

use std::path::PathBuf;
use std::sync::OnceLock;

use boards::{Board, Key, Run, Script};
use xtask::copies;
use xtask::measure::ledger::Emulated;
use xtask::owned::Owned;

/// A board, the firmware that a copy of its example builds, and what it does.
pub struct Copied {
    pub owned: &'static Owned,
    /// The keys before each picture.
    keys: &'static [&'static [Key]],
    built: OnceLock<PathBuf>,
    ran: OnceLock<(Run, Emulated)>,
}

pub static PICO: Copied = Copied::of(
    &xtask::owned::PICO,
    &[&[], &[Key::Select, Key::Right, Key::Right, Key::Up]],
);
pub static PICO_2: Copied = Copied::of(&xtask::owned::PICO_2, &[&[], &[Key::Right]]);
pub static BLACK_PILL: Copied = Copied::of(&xtask::owned::BLACK_PILL, &[&[], &[Key::Select]]);

impl Copied {
    const fn of(owned: &'static Owned, keys: &'static [&'static [Key]]) -> Self {
        Self {
            owned,
            keys,
            built: OnceLock::new(),
            ran: OnceLock::new(),
        }
    }

    fn board(&self) -> &Board {
        &self.owned.board
    }

    fn firmware(&self) -> &PathBuf {
        self.built
            .get_or_init(|| copies::firmware(self.owned.name).unwrap())
    }

    /// Runs the firmware once, from the reset to the last picture. Also returns how long that took.
    fn ran(&self) -> &(Run, Emulated) {
        self.ran.get_or_init(|| {
            let script = Script::default();
            let script = self.keys.iter().fold(script, |all, keys| all.picture(keys));
            let firmware = self.firmware();
            Emulated::timed(|| self.board().run(firmware, &script).unwrap())
        })
    }

    fn run(&self) -> &Run {
        &self.ran().0
    }
}
