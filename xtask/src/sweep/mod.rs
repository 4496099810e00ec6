//! `cargo xtask sweep`: what many settings of one scene take on a core, by one firmware that goes
//! through them. For programs: `cargo run --release --example report` asks it.
//!
//! [`job`] is what is asked for and the firmware's source made of it.

mod job;

use std::{
    fs,
    io::{self, Write},
    path::PathBuf,
    time::Duration,
};

use anyhow::{Context, Result, ensure};
use clap::{Args, builder::PossibleValuesParser};
use serde_json::json;

use crate::{
    measure::{
        cores::{CORES, Core},
        firmware::{self, Report},
        scene::Scene,
        task::Size,
    },
    misuse::Misuse,
};

/// Measures many settings of one scene with one firmware; prints a line of JSON for each.
#[derive(Args, Debug)]
#[command(after_long_help = AFTER_HELP)]
pub struct Arguments {
    /// The core
    #[arg(long, default_value = "m3", value_parser = PossibleValuesParser::new(CORES.map(|core| core.name)))]
    core: String,

    /// A built-in scene, or a scene file
    #[arg(long, value_name = "NAME|FILE.json", default_value = "castle")]
    scene: PathBuf,

    /// The scene to take from a file that holds several
    #[arg(long, value_name = "SCENE")]
    name: Option<String>,

    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "64x64")]
    size: Size,

    /// The settings: a JSON array, see below
    #[arg(long, value_name = "FILE.json")]
    runs: PathBuf,

    /// End after the first line if the program is this one
    #[arg(long, value_name = "PROGRAM")]
    known: Option<String>,
}

const AFTER_HELP: &str = r#"
Each of the settings is {"contestant": C, "reflections": 0 to 255, "scale": 1 or more}, and may have
"skip": true, by which it is built in and not drawn, so that the program is that of all. C is "float", or {"fixed": {"quality": Q, "shadows": true}}, and Q is "fast", "fine", "exact", or
{"stride": 1, 2 or 4, "tolerance": 0 to 2^30, "smallest_weight": 1 to 2^30}, in steps of 2^-30.
With a scale a picture that much smaller is drawn, and its pixels are repeated.

The first line is {"program": HASH}, a hash of what is in flash. The others have the keys run (the
place of the setting in the array, from 0), instructions (of the whole frame), prepare (those of its
preparation) and hash (FNV-1a, 64 bits, of the frame's RGB8 bytes)."#;

/// Soft floating point takes minutes for a frame.
const LIMIT: Duration = Duration::from_secs(60 * 60);

/// Does what the command line asks for.
pub fn run(arguments: &Arguments) -> Result<()> {
    let core = Core::find(&arguments.core).expect("the parser knows the cores");
    let scene = Scene::open(&arguments.scene, arguments.name.as_deref())?;
    let path = &arguments.runs;
    let text = fs::read_to_string(path)
        .map_err(|error| Misuse::new(format!("{} cannot be read: {error}", path.display())))?;
    let runs =
        job::read(&text).map_err(|error| Misuse::new(format!("{}: {error}", path.display())))?;
    let ticket = job::ticket(core, &runs);
    let program = firmware::build_sweep(core, &scene, |file| {
        job::source(&scene, file, arguments.size, ticket, &runs)
    })?;
    let fingerprint = format!("{:016x}", firmware::fingerprint(&program)?);
    say(&json!({ "program": fingerprint }))?;
    if arguments.known.as_ref() == Some(&fingerprint) {
        return Ok(());
    }
    let emulator = core.counting_emulator().limit(LIMIT);
    let mut running = emulator.boot(&program)?;
    for (index, _) in (0..).zip(&runs).filter(|(_, run)| !run.skip) {
        let line = running.line(|line| line.starts_with("measured "))?;
        let report = Report::find(&line)?;
        ensure!(
            report.number("ticket")? == ticket && report.number("run")? == index,
            "the firmware reports another task"
        );
        say(&json!({
            "run": index,
            "instructions": report.number("instructions")?,
            "prepare": report.number("prepare")?,
            "hash": format!("{:016x}", report.number("hash")?),
        }))?;
    }
    running.end()?;
    Ok(())
}

/// A line at once, whoever listens.
fn say(value: &serde_json::Value) -> Result<()> {
    let mut out = io::stdout().lock();
    writeln!(out, "{value}")
        .and_then(|()| out.flush())
        .context("nobody listens")
}
