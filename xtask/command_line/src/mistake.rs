//! Reading the command line, and lines about what is wrong with it.

use reflet::host::line::escaped;

use crate::Failure;

/// Reads the command line. Prints the help and ends the program where that is what was asked for.
///
/// # Errors
///
/// What is wrong with the command line, in one line.
pub fn parse<A: clap::Parser>() -> Result<A, Failure> {
    A::try_parse().map_err(|error| {
        if !error.use_stderr() {
            error.exit();
        }
        in_one_line(&error).into()
    })
}

/// The message of the command line's parser, which spans several lines, in one line. Its advice to
/// read the help is left out.
pub fn in_one_line(error: &clap::Error) -> String {
    let text = error.render().to_string();
    let is_end = |line: &&str| line.starts_with("Usage:") || line.starts_with("For more info");
    let is_empty = |line: &&str| line.is_empty() || line.starts_with("tip: to pass");
    let lines = text.lines().map(str::trim).take_while(|line| !is_end(line));
    let lines: Vec<_> = lines.filter(|line| !is_empty(line)).collect();
    lines.join("; ").trim_start_matches("error: ").to_owned()
}

/// A line of JSON with every control character and line separator in its strings escaped, also those
/// that JSON allows.
pub fn json_line(json: &str) -> String {
    escaped(json, |letter| format!("\\u{:04x}", u32::from(letter)))
}
