//! Renders a built-in scene or a scene file into the simulator's display, and prints how exact the
//! picture is.
//!
//! `cargo run --release --example render -- --help`

mod arguments;
mod dither;
#[cfg(feature = "film")]
mod film;
mod needs;
mod output;
#[cfg(feature = "film")]
mod palette;
mod picture;
mod progress;
mod report;
#[cfg(feature = "window")]
mod title;
#[cfg(feature = "window")]
mod watch;
#[cfg(feature = "window")]
mod window;

use std::process::ExitCode;

use command_line::{Failure, Source, exit_code, parse, print};

use self::arguments::Arguments;
use self::output::Outputs;
use self::picture::Drawing;

fn main() -> ExitCode {
    exit_code(parse().and_then(|arguments| run(&arguments)))
}

fn run(arguments: &Arguments) -> Result<(), Failure> {
    #[cfg(not(feature = "window"))]
    if arguments.window {
        let call = "cargo run --release --features window --example render -- --window";
        return Err(format!("--window needs the feature `window`: {call}").into());
    }
    #[cfg(not(feature = "film"))]
    if arguments.orbit.is_some() {
        let call = "cargo run --release --features film --example render -- --orbit 36 --gif F.gif";
        return Err(format!("--orbit needs the feature `film`: {call}").into());
    }
    let source = Source::open(&arguments.scene, &arguments.chosen)?;
    if arguments.needs {
        let (name, settings) = (source.name(), arguments.settings());
        let say = if arguments.json { needs::json } else { needs::text };
        return print(say(name, source.scene().needs(), settings) + "\n");
    }
    #[cfg(feature = "film")]
    if let Some(count) = arguments.orbit {
        return film::write(&source, arguments, count);
    }
    let outputs = Outputs::new(arguments, &source)?;
    if outputs.are_wanted() {
        let drawing = Drawing::new(&source, arguments)?.dithered(arguments.dither);
        outputs.write(&drawing)?;
    }
    #[cfg(feature = "window")]
    if arguments.window {
        window::show(source, arguments)?;
    }
    Ok(())
}
