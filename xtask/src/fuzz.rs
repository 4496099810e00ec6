//! `cargo xtask fuzz`: draws scenes that are made from arbitrary bytes, with libFuzzer and the compiler
//! in use.
//!
//! It needs neither cargo-fuzz nor a nightly compiler: the compiler passes that report coverage to
//! the fuzzer are in every release. `cargo fuzz run scene` works, too, and `cargo fuzz cmin scene` keeps few
//! inputs of those that it found.

use std::fs;
use std::path::Path;
use std::time::Duration;

use anyhow::{Context, Result};
use clap::Args;

use crate::{command::Program, need};

/// The compiler flags that cargo-fuzz uses, without those of the sanitizers.
const FLAGS: [&str; 7] = [
    "--cfg",
    "fuzzing",
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
];

/// Folder of the inputs that the repository keeps.
const KEPT: &str = "fuzz/corpus/scene";
/// Folder of the fuzzer's build, its new inputs and its failures.
const WORK: &str = "target/fuzz";

/// Draws scenes made from arbitrary bytes until the time is over. Fails if one panics, overflows or
/// takes more rays than a frame may. The input that fails is in target/fuzz.
#[derive(Args, Debug)]
pub struct Arguments {
    /// For how long, in seconds
    #[arg(long, value_name = "N", default_value_t = 600)]
    seconds: u32,
}

/// Builds the fuzz target and runs it. The current folder must be the repository's.
pub fn run(arguments: &Arguments) -> Result<()> {
    need::CPP_COMPILER.get_if_missing()?;
    let found = format!("{WORK}/found");
    fs::create_dir_all(&found).with_context(|| format!("cannot make {found}"))?;
    let target = build()?;
    let seconds = arguments.seconds;
    let limit = Duration::from_secs(u64::from(seconds) + 300);
    Program::new(Path::new(&target))
        .args([&format!("-artifact_prefix={WORK}/")])
        .args([&format!("-max_total_time={seconds}"), "-max_len=1024"])
        // Drawing a scene of at most 1024 bytes takes less than a second, whatever its settings.
        .args(["-timeout=20", "-len_control=0", "-print_final_stats=1"])
        .args([&found, KEPT])
        .limit(limit)
        .stream()
        .with_context(|| format!("the fuzzer has found something: see {WORK}"))
}

fn build() -> Result<String> {
    let version = Program::new("rustc").args(["-vV"]).read()?;
    let host = version
        .lines()
        .find_map(|line| line.strip_prefix("host: "))
        .context("rustc -vV names no host")?;
    // With `--target`, cargo does not pass the flags to build scripts and macros, which run on the
    // host.
    Program::new("cargo")
        .args(["build", "--quiet", "--release", "--target", host])
        .args(["--manifest-path", "fuzz/Cargo.toml", "--target-dir", WORK])
        .env("CARGO_ENCODED_RUSTFLAGS", FLAGS.join("\x1f"))
        .limit(Duration::from_secs(600))
        .stream()?;
    Ok(format!("{WORK}/{host}/release/scene"))
}
