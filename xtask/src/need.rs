//! Programs and libraries outside the repository that the chores use. Setup installs those of the gate. A
//! chore installs those that it is about to use.

use std::sync::Mutex;

use anyhow::{Context, Result, ensure};

use crate::{apt, command::Program, toolchain, toolchain::rustup};

/// A program or library outside the repository.
#[derive(Debug)]
pub struct Need {
    pub name: &'static str,
    pub is_there: fn() -> bool,
    pub get: fn() -> Result<()>,
    pub by_hand: &'static str,
    /// Consequence for the gate if it cannot be installed; `None` if the gate cannot run without it.
    pub without: Option<&'static str>,
}

impl Need {
    /// Installs it if it is missing, and says so in one line on standard error: a chore may print data
    /// on standard output. Looks for it once in a process.
    ///
    /// # Errors
    /// Fails if it cannot be installed, and names the way by hand.
    pub fn get_if_missing(&self) -> Result<()> {
        /// Names of what was found. Locked while something is installed, so that nothing is twice.
        static FOUND: Mutex<Vec<&str>> = Mutex::new(Vec::new());
        let mut found = FOUND.lock().expect("no installation panics");
        if found.contains(&self.name) {
            return Ok(());
        }
        if !(self.is_there)() {
            eprintln!("{}: missing, getting it", self.name);
            let advice = || format!("{}: missing; by hand: {}", self.name, self.by_hand);
            self.install().with_context(advice)?;
        }
        found.push(self.name);
        Ok(())
    }

    /// Installs it, and tests whether it is there then.
    fn install(&self) -> Result<()> {
        (self.get)()?;
        ensure!(
            (self.is_there)(),
            "it was installed and still does not work"
        );
        Ok(())
    }
}

pub static RUSTFMT: Need = Need {
    name: "rustfmt",
    is_there: || runs("cargo fmt"),
    get: || rustup(&["component", "add", "rustfmt"]),
    by_hand: "rustup component add rustfmt",
    without: None,
};

pub static CLIPPY: Need = Need {
    name: "clippy",
    is_there: || runs("cargo clippy"),
    get: || rustup(&["component", "add", "clippy"]),
    by_hand: "rustup component add clippy",
    without: None,
};

pub static BARE_METAL: Need = Need {
    name: "bare-metal targets",
    is_there: || toolchain::BareMetal::find().is_some(),
    get: toolchain::get_bare_metal,
    by_hand: toolchain::BARE_METAL_BY_HAND,
    without: None,
};

pub static CPP_COMPILER: Need = Need {
    name: "C++ compiler, for the fuzzer",
    is_there: || runs("c++"),
    get: || apt::install(&["g++"]),
    by_hand: "as root: apt-get install g++",
    without: None,
};

pub static QEMU_ARM: Need = Need {
    name: "QEMU for Arm",
    is_there: || runs("qemu-system-arm"),
    get: || apt::install(&["qemu-system-arm"]),
    by_hand: "as root: apt-get install --no-install-recommends qemu-system-arm",
    without: None,
};

pub static QEMU_RISCV: Need = Need {
    name: "QEMU for RISC-V",
    is_there: || runs("qemu-system-riscv32"),
    get: || apt::install(&["qemu-system-misc"]),
    by_hand: "as root: apt-get install --no-install-recommends qemu-system-misc",
    without: None,
};

pub static WASM: Need = Need {
    name: "target for WebAssembly",
    is_there: toolchain::has_wasm,
    get: || rustup(&["target", "add", toolchain::WASM]),
    by_hand: "rustup target add wasm32-unknown-unknown",
    without: Some("the gate names the playground as untried"),
};

pub static CHROMIUM: Need = Need {
    name: "Chromium",
    is_there: || runs("chromium") && runs("chromedriver"),
    get: || apt::install(&["chromium", "chromium-driver"]),
    by_hand: "as root: apt-get install --no-install-recommends chromium chromium-driver",
    without: Some("the gate names the playground as untried"),
};

pub static OLDEST_RUST: Need = Need {
    name: "oldest supported Rust",
    is_there: toolchain::has_oldest_rust,
    get: toolchain::get_oldest_rust,
    by_hand: "rustup toolchain install 1.87 --profile minimal",
    without: Some("the gate names the oldest supported Rust as untried"),
};

/// Tests whether a command runs with `--version`.
fn runs(command: &str) -> bool {
    let mut words = command.split(' ').chain(["--version"]);
    let program = words.next().unwrap_or_default();
    Program::new(program).args(words).succeeds()
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering::Relaxed};

    use anyhow::bail;

    use super::*;

    static CUPS: AtomicU32 = AtomicU32::new(0);

    static TEA: Need = Need {
        name: "tea",
        is_there: || CUPS.load(Relaxed) > 0,
        get: || {
            CUPS.fetch_add(1, Relaxed);
            Ok(())
        },
        by_hand: "boil water",
        without: None,
    };

    #[test]
    fn what_is_missing_is_got_once() {
        for _ in 0..2 {
            TEA.get_if_missing().unwrap();
            assert_eq!(CUPS.load(Relaxed), 1);
        }
    }

    #[test]
    fn what_is_there_is_not_fetched_for_a_chore() {
        let water = Need {
            name: "water",
            is_there: || true,
            get: || panic!("nobody asked for it"),
            ..TEA
        };
        water.get_if_missing().unwrap();
    }

    #[test]
    fn what_cannot_be_got_is_named_with_the_way_by_hand() {
        let milk = Need {
            name: "milk",
            is_there: || false,
            get: || bail!("no cow"),
            by_hand: "milk a cow",
            without: None,
        };
        let refused = milk.get_if_missing().unwrap_err();
        let words = "milk: missing; by hand: milk a cow: no cow";
        assert_eq!(format!("{refused:#}"), words);
    }
}
