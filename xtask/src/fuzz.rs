//! `cargo xtask fuzz`: draws scenes made of any bytes, with libFuzzer, on the compiler in use.
//!
//! cargo-fuzz and a nightly compiler are not needed: the passes that tell the fuzzer what has been
//! reached are the compiler's own, and every release has them. `cargo fuzz run scene` works, too.

use std::fs;
use std::path::Path;
use std::time::Duration;

use anyhow::{Context, Result, bail};
use clap::Args;

use crate::command::Program;

/// What cargo-fuzz passes to the compiler, the sanitizers apart.
const FLAGS: [&str; 7] = [
    "--cfg",
    "fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
];

const KEPT: &str = "fuzz/corpus/scene";
const WORK: &str = "target/fuzz";

/// Draws scenes made of any bytes until the time is over, and fails where one panics, overflows or
/// takes more rays than a frame may. What it fails on lies in target/fuzz.
#[derive(Args, Debug)]
pub struct Arguments {
    /// For how long, in seconds
    #[arg(long, value_name = "N", default_value_t = 600)]
    seconds: u32,

    /// Adds what reaches new code to fuzz/corpus, as little of it as can be
    #[arg(long)]
    keep: bool,
}

/// Builds the target and runs it; the current folder is the repository's.
pub fn run(arguments: &Arguments) -> Result<()> {
    if !compiles_cpp() {
        bail!("libFuzzer is C++ and c++ does not run: as root, apt-get install g++");
    }
    let found = format!("{WORK}/found");
    fs::create_dir_all(&found).with_context(|| format!("cannot make {found}"))?;
    let target = build()?;
    let seconds = arguments.seconds;
    let limit = Duration::from_secs(u64::from(seconds) + 300);
    fuzzer(&target)
        .args([&format!("-max_total_time={seconds}"), "-max_len=1024"])
        // No scene of so many bytes takes a second, however it is drawn.
        .args(["-timeout=20", "-len_control=0", "-print_final_stats=1"])
        .args([&found, KEPT])
        .limit(limit)
        .stream()
        .with_context(|| format!("the fuzzer has found something: see {WORK}"))?;
    if arguments.keep {
        merge(&target, &found)?;
    }
    Ok(())
}

pub fn compiles_cpp() -> bool {
    Program::new("c++").args(["--version"]).succeeds()
}

fn build() -> Result<String> {
    let version = Program::new("rustc").args(["-vV"]).read()?;
    let host = version
        .lines()
        .find_map(|line| line.strip_prefix("host: "))
        .context("rustc -vV names no host")?;
    // With a target named, the flags are not for what is run while the target is built.
    Program::new("cargo")
        .args(["build", "--quiet", "--release", "--target", host])
        .args(["--manifest-path", "fuzz/Cargo.toml", "--target-dir", WORK])
        .env("CARGO_ENCODED_RUSTFLAGS", FLAGS.join("\x1f"))
        .limit(Duration::from_secs(600))
        .stream()?;
    Ok(format!("{WORK}/{host}/release/scene"))
}

fn fuzzer(target: &str) -> Program {
    Program::new(Path::new(target)).args([&format!("-artifact_prefix={WORK}/")])
}

/// One input for each piece of code that is reached.
fn merge(target: &str, found: &str) -> Result<()> {
    let kept = Path::new(WORK).join("kept");
    if kept.exists() {
        fs::remove_dir_all(&kept)?;
    }
    fs::create_dir_all(&kept)?;
    fuzzer(target)
        .args(["-use_counters=0", "-set_cover_merge=1"])
        .args([&kept, Path::new(KEPT), Path::new(found)])
        .limit(Duration::from_secs(600))
        .stream()?;
    fs::remove_dir_all(KEPT)?;
    fs::create_dir_all(KEPT)?;
    for entry in fs::read_dir(&kept)? {
        let entry = entry?;
        fs::copy(entry.path(), Path::new(KEPT).join(entry.file_name()))?;
    }
    Ok(())
}
