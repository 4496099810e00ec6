//! Measures cost and error of a scene under many settings, and writes a report.
//!
//! `cargo run --release --package report -- --help`

mod arguments;
mod front;
mod page;
mod plot;
mod point;
mod scene;
mod table;
mod write;

use std::io::{self, Write};
use std::process::ExitCode;

use command_line::one_line;

use self::arguments::Arguments;

fn main() -> ExitCode {
    match Arguments::read().and_then(|arguments| scene::report(&arguments)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            // If standard error cannot be written either, nothing is left to do.
            let _ = writeln!(io::stderr(), "error: {}", one_line(&format!("{failure:#}")));
            ExitCode::from(2)
        }
    }
}
