//! Installs what a machine needs before the gate can run.
//!
//! Each row of [`NEEDS`] is one need. Setup goes through the rows and installs what is missing. At
//! the end it names what it could not install, and how to install that by hand.

use std::time::Instant;

use anyhow::{Result, bail, ensure};

use crate::{apt, command::Program, emulator::rp2040, fuzz, toolchain};

/// A program or library outside the repository that the gate uses.
struct Need {
    name: &'static str,
    is_there: fn() -> bool,
    get: fn() -> Result<()>,
    by_hand: &'static str,
    /// Consequence if it cannot be installed; `None` if the gate cannot run without it.
    without: Option<&'static str>,
}

const NEEDS: &[Need] = &[
    Need {
        name: "rustfmt",
        is_there: || are_there(&["cargo fmt"]),
        get: || toolchain::add_component("rustfmt"),
        by_hand: "rustup component add rustfmt",
        without: None,
    },
    Need {
        name: "clippy",
        is_there: || are_there(&["cargo clippy"]),
        get: || toolchain::add_component("clippy"),
        by_hand: "rustup component add clippy",
        without: None,
    },
    Need {
        name: "bare-metal targets",
        is_there: || toolchain::BareMetal::find().is_some(),
        get: toolchain::get_bare_metal,
        by_hand: toolchain::BARE_METAL_BY_HAND,
        without: None,
    },
    Need {
        name: "C++ compiler, for the fuzzer",
        is_there: fuzz::compiles_cpp,
        get: || apt::install(&["g++"]),
        by_hand: "as root: apt-get install g++",
        without: None,
    },
    Need {
        name: "QEMU",
        is_there: || are_there(&["qemu-system-arm", "qemu-system-riscv32"]),
        get: || apt::install(&["qemu-system-arm", "qemu-system-misc"]),
        by_hand: "as root: apt-get install --no-install-recommends qemu-system-arm qemu-system-misc",
        without: None,
    },
    Need {
        name: "node and npm",
        is_there: || are_there(&["node", "npm"]),
        get: || apt::install(&["nodejs", "npm"]),
        by_hand: "as root: apt-get install --no-install-recommends nodejs npm",
        without: None,
    },
    Need {
        name: "RP2040 emulator",
        is_there: rp2040::is_installed,
        get: || Ok(rp2040::install()?),
        by_hand: "npm ci --prefix xtask/emulator/rp2040, with npm's registry in reach",
        without: None,
    },
    Need {
        name: "oldest supported Rust",
        is_there: toolchain::has_oldest_rust,
        get: toolchain::get_oldest_rust,
        by_hand: "rustup toolchain install 1.87 --profile minimal",
        without: Some("the gate names the oldest supported Rust as untried"),
    },
];

/// Tests whether each of these commands runs with `--version`.
fn are_there(commands: &[&str]) -> bool {
    commands.iter().all(|command| {
        let mut words = command.split(' ').chain(["--version"]);
        let program = words.next().unwrap_or_default();
        Program::new(program).args(words).succeeds()
    })
}

pub fn run() -> Result<()> {
    meet_all(NEEDS)
}

/// Installs all needs that are missing. Tries every one, so that one run names everything that
/// cannot be installed.
fn meet_all(needs: &[Need]) -> Result<()> {
    let mut missing = Vec::new();
    for need in needs {
        if let Err(error) = meet(need) {
            println!("setup: {}: not got: {error:#}", need.name);
            if let Some(without) = need.without {
                println!("setup: {}: going on, {without}", need.name);
                continue;
            }
            missing.push(format!("\n  {}: {}", need.name, need.by_hand));
        }
    }
    if missing.is_empty() {
        return Ok(());
    }
    bail!(
        "setup could not get all the tests need. By hand:{}",
        missing.concat()
    )
}

fn meet(need: &Need) -> Result<()> {
    if (need.is_there)() {
        println!("setup: {}: there", need.name);
        return Ok(());
    }
    println!("setup: {}: not there, getting", need.name);
    let start = Instant::now();
    (need.get)()?;
    ensure!(
        (need.is_there)(),
        "it was installed and still does not work"
    );
    let seconds = start.elapsed().as_secs_f64();
    println!("setup: {}: got in {seconds:.0} s", need.name);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: Need = Need {
        name: "tea",
        is_there: || true,
        get: || panic!("nobody asked for it"),
        by_hand: "boil water",
        without: None,
    };

    #[test]
    fn what_is_there_is_not_fetched() {
        meet_all(&[HERE]).unwrap();
    }

    #[test]
    fn everything_that_cannot_be_got_is_named_with_the_way_by_hand() {
        let refused = Need {
            name: "milk",
            is_there: || false,
            get: || bail!("no cow"),
            by_hand: "milk a cow",
            without: None,
        };
        let useless = Need {
            name: "sugar",
            is_there: || false,
            get: || Ok(()),
            by_hand: "grow a beet",
            without: None,
        };
        let welcome = Need {
            name: "biscuits",
            is_there: || false,
            get: || bail!("eaten"),
            by_hand: "bake some",
            without: Some("tea is drunk without"),
        };
        let error = meet_all(&[refused, welcome, HERE, useless]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "setup could not get all the tests need. By hand:\n  \
             milk: milk a cow\n  sugar: grow a beet"
        );
    }
}
