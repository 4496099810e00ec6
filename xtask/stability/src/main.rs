//! Tries the catalogue of hard cases and writes `docs/stability.md`.
//!
//! `cargo run --release --package stability -- --help`

mod arguments;
mod long;

use std::fs;
use std::io::{self, Write};
use std::process::ExitCode;

use self::arguments::Arguments;
use command_line::Failure;
use stability::report::Tried;
use stability::{catalogue, page, report};

fn main() -> ExitCode {
    match Arguments::read().and_then(|arguments| run(&arguments)) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(failure) => {
            // If standard error cannot be written either, nothing is left to do.
            let _ = writeln!(io::stderr(), "error: {failure}");
            ExitCode::from(2)
        }
    }
}

/// Tries all cases. Returns whether every case met its bar or has a reason, and whether the aim is
/// met.
fn run(arguments: &Arguments) -> Result<bool, Failure> {
    if let Some(rays) = arguments.rays {
        return long::run(rays, arguments.seed);
    }
    let tried: Vec<Tried> = catalogue::chapters()
        .iter()
        .flat_map(|(chapter, cases)| cases.iter().map(|case| Tried::new(chapter, case)))
        .inspect(|tried| print(&tried.line(arguments.json)))
        .collect();
    let failures = report::failures(&tried);
    for failure in &failures {
        writeln!(io::stderr(), "{failure}")?;
    }
    if !arguments.json {
        let path = &arguments.page;
        fs::write(path, page::page(&tried))
            .map_err(|error| format!("{}: {error}", path.display()))?;
        print(&format!(
            "{}, {}",
            report::summary(&tried),
            arguments.page.display()
        ));
    }
    Ok(failures.is_empty() && report::Compared::of(&tried).is_aim_met())
}

/// Prints a line on standard output. A closed pipe is no error.
fn print(text: &str) {
    let _ = writeln!(io::stdout(), "{text}");
}
