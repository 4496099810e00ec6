//! Installs what a machine needs before the gate can run.
//!
//! Setup goes through [`NEEDS`] and installs what is missing. At the end it names what it could not install, and how to install that by hand.

use anyhow::{Result, bail};

use crate::need::{self, Need};

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
        let Err(error) = need.get_if_missing() else {
            println!("setup: {}: there", need.name);
            continue;
        };
        println!("setup: {error:#}");
        match need.without {
            Some(without) => println!("setup: {}: going on, {without}", need.name),
            None => missing.push(format!("\n  {}: {}", need.name, need.by_hand)),
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

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: Need = Need {
        name: "cup",
        is_there: || true,
        get: || panic!("nobody asked for it"),
        by_hand: "boil water",
        without: None,
    };

    #[test]
    fn everything_that_cannot_be_got_is_named_with_the_way_by_hand() {
        let refused = Need {
            name: "milk",
            by_hand: "milk a cow",
            is_there: || false,
            get: || bail!("no cow"),
            ..HERE
        };
        let useless = Need {
            name: "sugar",
            by_hand: "grow a beet",
            get: || Ok(()),
            ..refused
        };
        let welcome = Need {
            name: "biscuits",
            by_hand: "bake some",
            without: Some("tea is drunk without"),
            ..refused
        };
        let error = meet_all(&[&refused, &welcome, &HERE, &useless]).unwrap_err();
        let words = "setup could not get all the tests need. By hand:\n  \
                     milk: milk a cow\n  sugar: grow a beet";
        assert_eq!(error.to_string(), words);
    }
}
