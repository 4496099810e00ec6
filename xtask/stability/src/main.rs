//! Tries the catalogue of hard cases and writes `docs/internals/stability.md`.
//!
//! `cargo run --release --package stability -- --help`

mod long;

use std::fs;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process::ExitCode;

use clap::Parser;
use command_line::{Failure, exit_code, parse};
use stability::{page, report};

/// Tries every case of the catalogue and writes docs/internals/stability.md.
///
/// The exit code is 0; 1 if a case misses its bar, is worse than f32 without a reason, or too many
/// cases are worse; and 2 after an error, which is one line.
#[derive(Parser)]
#[command(name = "stability", max_term_width = 100)]
struct Arguments {
    /// Where the page is written
    #[arg(
        long,
        value_name = "F.md",
        default_value = "docs/internals/stability.md"
    )]
    page: PathBuf,

    /// Draw random scenes instead, until N rays have been followed, with every overflow checked:
    /// needs `--profile checked` instead of `--release`
    #[arg(long, value_name = "N")]
    rays: Option<u64>,

    /// Seed of the random scenes
    #[arg(long, value_name = "N", default_value_t = 1)]
    seed: u64,
}

fn main() -> ExitCode {
    match parse().and_then(|arguments| run(&arguments)) {
        Ok(false) => ExitCode::FAILURE,
        done => exit_code(done.map(drop)),
    }
}

/// Tries all cases. Returns whether every case met its bar or has a reason, and whether the aim is
/// met.
fn run(arguments: &Arguments) -> Result<bool, Failure> {
    if let Some(rays) = arguments.rays {
        return long::run(rays, arguments.seed);
    }
    let tried = report::try_all().inspect(|tried| print(&tried.line()));
    let tried: Vec<_> = tried.collect();
    let failures = report::failures(&tried);
    for failure in &failures {
        writeln!(io::stderr(), "{failure}")?;
    }
    let path = &arguments.page;
    fs::write(path, page::page(&tried)).map_err(|error| format!("{}: {error}", path.display()))?;
    print(&path.display().to_string());
    Ok(failures.is_empty() && report::Compared::of(&tried).is_aim_met())
}

/// Prints a line on standard output. A closed pipe is no error.
fn print(text: &str) {
    let _ = writeln!(io::stdout(), "{text}");
}
