//! The gate: the checks that every change has to pass, and the long ones that `--all` adds.
//!
//! Formats are checked first, then all tests are built. The other steps do not depend on each other.
//! They run side by side, because linking a firmware uses one core only.

use std::{
    collections::VecDeque,
    fs,
    path::Path,
    sync::Mutex,
    thread,
    time::{Duration, Instant},
};

use anyhow::{Context, Result};
use clap::Args;

use crate::{
    command::Program,
    measure::ledger,
    need,
    toolchain::{
        self, BareMetal, M0, M3, M4F, M33, OLDEST_RUST, RV32IMAC, RV32IMC, TARGETS,
        has_oldest_rust, target_directory,
    },
};

/// Sets up, then runs the gate and stops after the first step that fails.
#[derive(Args, Clone, Copy, Debug)]
pub struct Arguments {
    /// Adds what takes long: every ignored test, lints for boards, the schema of scene files, the playground in a
    /// browser, 10 minutes of fuzzing, 10^8 random rays
    #[arg(long)]
    all: bool,
}

/// Time limit of a step. On a working machine no step takes a tenth of it.
const LIMIT: Duration = Duration::from_secs(60 * 60);

/// Number of steps that run at the same time: one more than there are cores, as builds of firmware wait for each other.
const LANES: usize = 3;

/// Packages outside of the workspace. Each is built with its own flags or for its own target.
const ALONE: [&str; 12] = [
    "examples/blackpill",
    "examples/esp32c3",
    "examples/pico",
    "examples/small",
    "fuzz",
    "tests/schema",
    "xtask/faulty",
    "xtask/firmware",
    "xtask/no_panic",
    "xtask/playground",
    "xtask/playground/drawing",
    "xtask/playground/tests/browser",
];

/// The test programs that run the firmware of the examples.
const BOARDS: [&str; 3] = ["board", "boards", "small_boards"];

/// The test program that takes the longest of those that measure firmware.
const LONGEST: &str = "measure";

/// All tests have the films of the example `render`. The same in each step: nothing is built twice.
const FEATURES: &str = "--features=reflet/film";

struct Step {
    name: String,
    program: Program,
}

/// Runs the whole gate: formats and the build first, then all other steps side by side.
pub fn run(arguments: Arguments) -> Result<()> {
    let bare_metal = BareMetal::find().context("the bare-metal targets are gone since setup")?;
    let start = Instant::now();
    ledger::clear()?;
    let mut times = Vec::new();
    for step in first() {
        times.push(take(step)?);
    }
    let mut steps = VecDeque::from(tests(arguments.all)?);
    steps.extend(library(&bare_metal, arguments.all));
    if arguments.all {
        // Clippy belongs to the toolchain in use, which can lint for boards only if it is `Prebuilt`.
        if let BareMetal::Prebuilt = bare_metal {
            steps.extend(boards());
        }
        steps.extend(long());
    }
    let mut untried = Vec::new();
    if arguments.all {
        match playground() {
            Ok(all) => steps.extend(all),
            Err(reason) => {
                eprintln!("{reason:#}");
                untried.push("the playground: what it needs cannot be installed here");
            }
        }
    }
    match oldest_rust(arguments.all) {
        Some(step) => steps.push_back(step),
        None => untried.push("the oldest supported Rust: that toolchain cannot be installed here"),
    }
    times.extend(side_by_side(steps)?);
    println!("\n== all steps: seconds on the clock, and of the processor");
    let processor = times.iter().map(|taken| taken.seconds[1]).sum();
    let all = Taken {
        name: "all".to_owned(),
        seconds: [start.elapsed().as_secs_f64(), processor],
    };
    for Taken { name, seconds } in times.iter().chain([&all]) {
        let [clock, processor] = seconds;
        println!("{clock:>8.1} {processor:>8.1}  {name}");
    }
    println!(
        "\n== firmware and boards: seconds on the clock\n{}",
        ledger::summary()
    );
    for name in &untried {
        println!("untried: {name}");
    }
    println!("gate: {} passed, 0 failed", times.len());
    Ok(())
}

/// A step that has passed, with its seconds on the clock and those of the processor.
#[derive(Debug)]
struct Taken {
    name: String,
    seconds: [f64; 2],
}

/// Runs the steps, [`LANES`] at a time, until all are done or one fails. Returns the times of each
/// step.
fn side_by_side(steps: VecDeque<Step>) -> Result<Vec<Taken>> {
    let (steps, done) = (Mutex::new(steps), Mutex::new(Ok(Vec::new())));
    let next = || match *done.lock().expect("no lane panics") {
        Ok(_) => steps.lock().expect("no lane panics").pop_front(),
        Err(_) => None,
    };
    let lane = || {
        while let Some(step) = next() {
            let taken = take(step);
            let mut done = done.lock().expect("no lane panics");
            match (&mut *done, taken) {
                (Ok(all), Ok(taken)) => all.push(taken),
                (Ok(_), Err(error)) => *done = Err(error),
                // Only the first failure is reported.
                (Err(_), _) => {}
            }
        }
    };
    thread::scope(|scope| {
        for _ in 0..LANES {
            scope.spawn(lane);
        }
    });
    done.into_inner().expect("no lane panics")
}

/// Runs one step, prints its output when it is done, and returns its times.
fn take(Step { name, program }: Step) -> Result<Taken> {
    println!("== begin: {name}\n   {program}");
    let start = Instant::now();
    let watched = program.limit(LIMIT).watch();
    let seconds = [start.elapsed(), watched.processor].map(|it| it.as_secs_f64());
    let ([clock, processor], said) = (seconds, watched.said);
    println!("\n== {name}: {clock:.1} s, processor {processor:.1} s\n{said}");
    let failed = || format!("the step `{name}` failed");
    watched.outcome.with_context(failed)?;
    Ok(Taken { name, seconds })
}

fn step(name: &str, program: Program) -> Step {
    let name = name.to_owned();
    Step { name, program }
}

fn cargo(subcommand: &str) -> Program {
    Program::new("cargo").args([subcommand])
}

/// Returns the program that the tests built. `cargo xtask` would build it again, with the features of
/// its own package only.
fn xtask() -> Program {
    Program::new(target_directory().join("debug/xtask"))
}

/// Returns the steps that run first: format checks, which take no time, and the build of all test
/// programs, which uses every core.
fn first() -> Vec<Step> {
    let alone = ALONE.map(|package| {
        let manifest = format!("{package}/Cargo.toml");
        let format = cargo("fmt").args(["--check", "--manifest-path", &manifest]);
        step(&format!("format, {package}"), format)
    });
    let mut steps = vec![step("format", cargo("fmt").args(["--all", "--check"]))];
    steps.extend(alone);
    let build = cargo("test").args(["--workspace", FEATURES, "--no-run"]);
    steps.push(step("build of all tests", build));
    steps
}

/// Returns the test steps. Tests that build firmware and all others are separate steps. `all` adds
/// the ignored tests.
///
/// Each step selects test programs by name in the whole workspace: for single packages, cargo would
/// compile their dependencies again with fewer features.
fn tests(all: bool) -> Result<Vec<Step>> {
    let test = |targets: &[String]| {
        let test = cargo("test").args(["--workspace", FEATURES]).args(targets);
        let test = test.env("EXAMPLES_ARE_BUILT", "1");
        if all { test.args(["--", "--include-ignored"]) } else { test }
    };
    let firmware = test_programs(&["xtask/tests", "xtask/report/tests"])?;
    let all_others = [
        "tests",
        "tests/random/tests",
        "xtask/boards/tests",
        "xtask/command_line/tests",
        "xtask/lost/tests",
        "xtask/stability/tests",
    ];
    let mut others = test_programs(&all_others)?;
    others.retain(|name| !firmware.contains(name));
    others.extend(["--lib", "--bins"].map(str::to_owned));
    // Three steps, so that one builds while the others emulate.
    let is_board = |name: &String| BOARDS.iter().any(|it| name == &format!("--test={it}"));
    let (boards, measured): (Vec<_>, Vec<_>) = firmware.into_iter().partition(is_board);
    let is_longest = |name: &String| name == &format!("--test={LONGEST}");
    let (longest, measured): (Vec<_>, Vec<_>) = measured.into_iter().partition(is_longest);
    // Documentation tests of these two packages would repeat the reference's: they compile its
    // files again.
    let excluded = ["--exclude=float_picture", "--exclude=float_port"];
    let documentation = cargo("test").args(["--workspace", FEATURES, "--doc"]);
    // Steps that use one core come first, so that none is idle at the end.
    Ok(vec![
        step("tests of firmware's size and speed", test(&measured)),
        step("tests on emulated boards", test(&boards)),
        step("tests of measured firmware", test(&longest)),
        step("tests on this machine", test(&others)),
        step("tests in the documentation", documentation.args(excluded)),
    ])
}

/// Returns the cargo arguments that select the test programs in some folders: `--test=NAME`.
fn test_programs(folders: &[&str]) -> Result<Vec<String>> {
    let mut names = Vec::new();
    for folder in folders {
        let entries = fs::read_dir(folder).with_context(|| format!("cannot read {folder}"))?;
        for path in entries.map(|entry| entry.map(|it| it.path())) {
            let path = path?;
            let is_program = path.extension().is_some_and(|it| it == "rs");
            if is_program || path.join("main.rs").is_file() {
                let name = path.file_stem().unwrap_or_default().to_string_lossy();
                names.push(format!("--test={name}"));
            }
        }
    }
    Ok(names)
}

/// Returns the other steps for the library: lints, package, documentation and bare-metal targets.
fn library(bare_metal: &BareMetal, all: bool) -> Vec<Step> {
    let library = ["--package", "reflet", "--lib", "--no-default-features"];
    // The built-in scenes are compiled with the firmware that the tests build.
    let features = ["--features", "micromath"];
    // Clippy checks what the board's needs. The tests build firmware for each of the others.
    let targets = if all { &TARGETS[..] } else { &TARGETS[1..2] };
    // In release mode, as clippy for boards and the firmware: macros are compiled once for all.
    let on_bare_metal = |subcommand: &str| {
        let check = bare_metal.cargo(subcommand, targets).args(["--release"]);
        toolchain::alone(check, Path::new("")).args(library)
    };
    let warnings = ["--", "-D", "warnings"];
    let without_features = match bare_metal {
        BareMetal::Prebuilt => on_bare_metal("clippy").args(warnings),
        BareMetal::BuildStd { .. } => on_bare_metal("check"),
    };
    let rest = cargo("clippy").args(["--workspace", "--all-targets", "--all-features"]);
    // `all` also compiles the package from nothing but its own files.
    let unverified: &[&str] = if all { &[] } else { &["--no-verify"] };
    let documentation = cargo("doc")
        .args(["--package", "reflet", "--no-deps", "--no-default-features"])
        .args(["--features", "host,micromath,scenes"])
        .env("RUSTDOCFLAGS", "-D warnings --cfg docsrs");
    let package = cargo("package").args(["--package", "reflet", "--allow-dirty"]);
    vec![
        step("clippy, everything", rest.args(warnings)),
        step("package", package.args(unverified)),
        step("documentation, as docs.rs builds it", documentation),
        step("bare metal", on_bare_metal("check").args(features)),
        step("bare metal, no features", without_features),
    ]
}

/// Returns the steps that lint the code for boards. They share what is compiled. Of the measurement firmware
/// only the library is linted, because the rest is generated. The crates of chips take minutes to check, and the
/// tests build all of these in any case, so only `--all` lints them.
fn boards() -> Vec<Step> {
    let warnings = ["--", "-D", "warnings"];
    let alone = |package: &str, part: &str, target: &str| {
        let program = cargo("clippy").args(["--release", "--target", target]);
        let program = toolchain::alone(program, Path::new(package)).args([part]);
        let name = format!("clippy, {package}, {target}");
        step(&name, program.args(warnings))
    };
    let board = ["--package", "reflet", "--example", "board"];
    let clippy = cargo("clippy").args(["--release", "--target", M3]);
    let board = toolchain::alone(clippy, Path::new("")).args(board);
    let name = format!("clippy, examples/board, {M3}");
    vec![
        step(&name, board.args(warnings)),
        alone("xtask/firmware", "--lib", M3),
        alone("examples/small", "--bins", M0),
        alone("xtask/firmware", "--lib", M0),
        alone("examples/small", "--bins", RV32IMAC),
        alone("xtask/firmware", "--lib", RV32IMAC),
        alone("examples/blackpill", "--bins", M4F),
        alone("examples/esp32c3", "--bins", RV32IMC),
        alone("examples/pico", "--bins", M0),
        alone("examples/pico", "--bins", M33),
    ]
}

/// Returns the steps that only `--all` runs.
fn long() -> Vec<Step> {
    let rays = cargo("run").args(["--profile", "checked", "--package", "stability", "--"]);
    let rays = rays.args(["--rays", "100000000"]);
    let copies = xtask().args(["copies"]);
    let schema = cargo("test").args(["--manifest-path", "tests/schema/Cargo.toml"]);
    let schema = schema.args(["--target-dir".as_ref(), target_directory().as_os_str()]);
    vec![
        step("schema of scene files", schema),
        step("fuzz", xtask().args(["fuzz", "--seconds", "600"])),
        step("10^8 random rays with overflow checks", rays),
        step("copies of examples are the same firmware", copies),
    ]
}

/// Returns the steps of the playground, which only `--all` runs. Installs what they need.
fn playground() -> Result<Vec<Step>> {
    need::WASM.get_if_missing()?;
    need::CHROMIUM.get_if_missing()?;
    let (library, browser) = ("xtask/playground", "xtask/playground/tests/browser");
    let alone = |subcommand: &str, package: &str| {
        let cargo = cargo(subcommand).args(["--workspace", "--locked", "--manifest-path"]);
        let cargo = cargo.args([format!("{package}/Cargo.toml")]);
        cargo.args(["--target-dir".as_ref(), target_directory().as_os_str()])
    };
    let clippy = |package: &str| {
        let clippy = alone("clippy", package).args(["--all-targets", "--", "-D", "warnings"]);
        step(&format!("clippy, {package}"), clippy)
    };
    let in_browser = alone("test", browser).args(["--", "--nocapture"]);
    let in_browser = in_browser.env("XTASK", target_directory().join("debug/xtask"));
    Ok(vec![
        clippy(library),
        clippy(browser),
        step("tests of the playground's library", alone("test", library)),
        step("playground in a browser", in_browser),
    ])
}

/// Returns the step that checks the library with the oldest Rust it supports, if that toolchain is
/// installed. `all` adds the features that take long to compile.
fn oldest_rust(all: bool) -> Option<Step> {
    let features = if all { "host,micromath,scenes" } else { "micromath" };
    let check = cargo(&format!("+{OLDEST_RUST}"))
        .args(["check", "--package", "reflet", "--lib"])
        .args(["--features", features])
        .env("CARGO_TARGET_DIR", target_directory().join("oldest"));
    has_oldest_rust().then(|| step("oldest supported Rust", check))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn step_that_fails_is_named() {
        let steps = [("well", "true"), ("ill", "false")];
        let steps = steps.map(|(name, program)| step(name, Program::new(program)));
        let error = side_by_side(steps.into()).unwrap_err();
        let words = "the step `ill` failed: `false` failed (exit status: 1)";
        assert_eq!(format!("{error:#}"), words);
    }

    #[test]
    fn nothing_is_begun_after_a_failure() {
        let missing = || step("unmet", Program::new("no-such-program"));
        let steps = (0..8).map(|_| missing()).collect();
        let error = side_by_side(steps).unwrap_err();
        let words = "the step `unmet` failed: there is no program `no-such-program`";
        assert_eq!(format!("{error:#}"), words);
    }
}
