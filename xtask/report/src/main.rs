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

use std::process::ExitCode;

use command_line::exit_code;

use self::arguments::Arguments;

fn main() -> ExitCode {
    exit_code(Arguments::read().and_then(|arguments| scene::report(&arguments)))
}
