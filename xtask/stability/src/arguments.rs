//! Parses the command line of `stability`. Never opens a file.

use std::path::PathBuf;

use clap::Parser;
use command_line::{Failure, parse};

/// Tries every case of the catalogue and writes docs/stability.md.
///
/// The exit code is 0; 1 if a case misses its bar, is worse than f32 without a reason, or too many
/// cases are worse; and 2 after an error, which is one line.
#[derive(Parser)]
#[command(name = "stability", max_term_width = 100)]
pub struct Arguments {
    /// Print one line of JSON a case, and write no page
    #[arg(long)]
    pub json: bool,

    /// Where the page is written
    #[arg(long, value_name = "F.md", default_value = "docs/stability.md")]
    pub page: PathBuf,

    /// Draw random scenes instead, until N rays have been followed, with every overflow checked:
    /// needs `--profile checked` instead of `--release`
    #[arg(long, value_name = "N")]
    pub rays: Option<u64>,

    /// Seed of the random scenes
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
}

impl Arguments {
    /// Parses the command line. An error is one line.
    pub fn read() -> Result<Self, Failure> {
        parse()
    }
}
