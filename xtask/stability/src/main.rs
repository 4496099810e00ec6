//! Tries the catalogue of cases that are hard, and writes `docs/stability.md`.
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
            // Nothing is left to be done if even this cannot be said.
            let _ = writeln!(io::stderr(), "error: {failure}");
            ExitCode::from(2)
        }
    }
}

/// Whether everything has met its bar, and the aim of all is met.
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

/// That nobody reads any more is no error.
fn print(text: &str) {
    let _ = writeln!(io::stdout(), "{text}");
}
