//! Installs what a machine needs before the gate can run.
//!
//! Setup goes through [`NEEDS`] and installs what is missing. At the end it names what it could not install, and how to install that by hand.

use std::time::Instant;

use anyhow::{Result, bail};

use crate::need::{self, Need};

/// All needs of the gate.
static NEEDS: [&Need; 7] = [
    &need::RUSTFMT,
    &need::CLIPPY,
    &need::BARE_METAL,
    &need::CPP_COMPILER,
    &need::QEMU_ARM,
    &need::QEMU_RISCV,
    &need::OLDEST_RUST,
];

pub fn run() -> Result<()> {
    meet_all(&NEEDS)
}

/// Installs all needs that are missing. Tries every one, so that one run names everything that
/// cannot be installed.
fn meet_all(needs: &[&Need]) -> Result<()> {
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
    need.install()?;
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
        meet_all(&[&HERE]).unwrap();
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
        let error = meet_all(&[&refused, &welcome, &HERE, &useless]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "setup could not get all the tests need. By hand:\n  \
             milk: milk a cow\n  sugar: grow a beet"
        );
    }
}
