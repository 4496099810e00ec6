//! Parses the command line, and writes its errors in one line.

use std::fmt::Display;
use std::io::{self, Write};
use std::process::ExitCode;

use clap::error::ErrorKind;
use reflet::host::line::{escaped, one_line};

use crate::Failure;

/// Parses the command line. If it asks for help, prints the help and exits. An error is one line.
pub fn parse<A: clap::Parser>() -> Result<A, Failure> {
    A::try_parse().map_err(|error| {
        if !error.use_stderr() {
            error.exit();
        }
        in_one_line(&error).into()
    })
}

/// Returns the exit code of a command: 0, or 2 after an error, which becomes a line on standard error.
pub fn exit_code(done: Result<(), impl Display>) -> ExitCode {
    let Err(failure) = done else {
        return ExitCode::SUCCESS;
    };
    // If standard error cannot be written either, nothing is left to do.
    let _ = writeln!(io::stderr(), "error: {}", one_line(&format!("{failure:#}")));
    ExitCode::from(2)
}

/// Joins the lines of clap's error message into one line. Leaves out the advice to read the help.
pub fn in_one_line(error: &clap::Error) -> String {
    if error.kind() == ErrorKind::DisplayHelpOnMissingArgumentOrSubcommand {
        return "a command is missing: --help lists them".to_owned();
    }
    let text = error.render().to_string();
    let is_end = |line: &&str| line.starts_with("Usage:") || line.starts_with("For more info");
    let is_empty = |line: &&str| line.is_empty() || line.starts_with("tip: to pass");
    let lines = text.lines().map(str::trim).take_while(|line| !is_end(line));
    let lines: Vec<_> = lines.filter(|line| !is_empty(line)).collect();
    lines.join("; ").trim_start_matches("error: ").to_owned()
}

/// Returns a line of JSON in which every control character and line separator inside strings is
/// escaped, also those that JSON allows.
pub fn json_line(json: &str) -> String {
    escaped(json, |letter| format!("\\u{:04x}", u32::from(letter)))
}
