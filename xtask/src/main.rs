//! The command line of the chores. `cargo xtask --help` lists them.

use std::{path::PathBuf, process::ExitCode};

use anyhow::Result;
use clap::Parser;
use command_line::{Chosen, in_one_line};
use xtask::{
    accuracy, board, copies, count, enter_root, fuzz, gate, measure, misuse::Misuse, owned,
    playground, profile, scene_source, screenshot, setup, size,
};

/// The chores of the reflet repository.
#[derive(Parser)]
#[command(name = "cargo xtask", bin_name = "cargo xtask")]
enum Chore {
    /// Gets what the tests need and is not on this machine; quick when nothing is missing.
    Setup,
    Test(gate::Arguments),
    /// Measures every built-in scene against the reference and writes docs/accuracy.md.
    Accuracy,
    /// Boots the default board unseen and saves what its display shows.
    Board(screenshot::Arguments),
    /// Emulates a Raspberry Pi Pico and saves or films what its display shows.
    Pico(owned::Asked),
    /// Emulates a Raspberry Pi Pico 2 and saves or films what its display shows.
    Pico2(owned::Asked),
    /// Emulates a Black Pill and saves or films what its display shows.
    Blackpill(owned::Asked),
    Copies(copies::Arguments),
    /// Boots a firmware on the default board, in a window if there is a screen: `cargo run` does.
    Show {
        /// The linked firmware
        #[arg(value_name = "ELF")]
        firmware: PathBuf,
    },
    Measure(measure::Arguments),
    Playground(playground::Arguments),
    Profile(profile::Arguments),
    Size(size::Arguments),
    Fuzz(fuzz::Arguments),
    /// Counts code, tools, words and packages, as the limits of the repository do.
    Count,
    /// Prints a scene file as the Rust source of a constant scene.
    Scene {
        /// JSON, one scene or an array of scenes
        #[arg(value_name = "FILE.json")]
        file: PathBuf,

        #[command(flatten)]
        chosen: Chosen,
    },
}

fn main() -> ExitCode {
    match read().and_then(|chore| run(&chore)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            if error.is::<Misuse>() { ExitCode::from(2) } else { ExitCode::FAILURE }
        }
    }
}

/// Parses the command line. If it asks for help, prints the help and exits.
fn read() -> Result<Chore> {
    Ok(Chore::try_parse().map_err(|error| {
        if !error.use_stderr() {
            error.exit();
        }
        Misuse::new(in_one_line(&error))
    })?)
}

fn run(chore: &Chore) -> Result<()> {
    // The other chores read or write files whose names are relative to the folder of the command.
    if let Chore::Setup | Chore::Accuracy | Chore::Fuzz(_) | Chore::Test(_) = chore {
        enter_root()?;
    }
    match chore {
        Chore::Board(arguments) => board::run(arguments),
        Chore::Pico(arguments) => owned::PICO.run(arguments),
        Chore::Pico2(arguments) => owned::PICO_2.run(arguments),
        Chore::Blackpill(arguments) => owned::BLACK_PILL.run(arguments),
        Chore::Copies(arguments) => copies::run(arguments),
        Chore::Show { firmware } => board::show(firmware),
        Chore::Measure(arguments) => measure::run(arguments),
        Chore::Playground(arguments) => playground::run(arguments),
        Chore::Profile(arguments) => profile::run(arguments),
        Chore::Size(arguments) => size::run(arguments),
        Chore::Scene { file, chosen } => scene_source::run(file, chosen),
        Chore::Setup => setup::run(),
        Chore::Accuracy => accuracy::run(),
        Chore::Count => count::run(),
        Chore::Fuzz(arguments) => fuzz::run(arguments),
        Chore::Test(arguments) => setup::run().and_then(|()| gate::run(*arguments)),
    }
}
