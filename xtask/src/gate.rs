//! The gate: the checks every change passes, in the order of what fails fastest.

use std::time::{Duration, Instant};

use anyhow::{Context, Result};

use crate::{
    command::Program,
    toolchain::{BareMetal, TARGETS},
};

/// All features but `window`, which links to SDL: it is checked, but need not be on the machine.
const FEATURES: &str = "reflet/host,reflet/scenes,reflet/micromath";

/// The features a firmware may use.
const FIRMWARE_FEATURES: &str = "scenes,micromath";

/// No step takes a tenth of this on a machine that is well.
const LIMIT: Duration = Duration::from_secs(30 * 60);

/// One check with the name it is reported under.
struct Step {
    name: &'static str,
    program: Program,
}

/// Runs the whole gate.
pub fn run() -> Result<()> {
    let bare_metal = BareMetal::find().context("the bare-metal targets are gone since setup")?;
    pass(steps(&bare_metal))
}

/// Runs every step until one fails, and names it.
fn pass(steps: Vec<Step>) -> Result<()> {
    let mut times = Vec::new();
    for (index, Step { name, program }) in steps.into_iter().enumerate() {
        println!("\n== {}: {name}\n   {program}", index + 1);
        let start = Instant::now();
        // What only helps the next build fills the disk of a machine that is used once.
        program
            .env("CARGO_INCREMENTAL", "0")
            .limit(LIMIT)
            .stream()
            .with_context(|| format!("the step `{name}` failed"))?;
        times.push((name, start.elapsed()));
        println!("== {name}: {:.1} s", start.elapsed().as_secs_f64());
    }
    println!("\n== all steps");
    for (name, time) in &times {
        println!("{:>8.1} s  {name}", time.as_secs_f64());
    }
    println!("gate: {} passed, 0 failed", times.len());
    Ok(())
}

fn steps(bare_metal: &BareMetal) -> Vec<Step> {
    let step = |name, program| Step { name, program };
    let deny = ["--", "-D", "warnings"];
    let library = ["--package", "reflet", "--lib", "--no-default-features"];
    // Built for every target and run on none: the sooner the better.
    let unused = |of| {
        let build = bare_metal.cargo("build", &TARGETS).args(of);
        build
            .args(["--config", "profile.dev.package.'*'.opt-level=0"])
            .env("CARGO_PROFILE_DEV_DEBUG", "0")
    };
    let mut steps = vec![
        step("format", cargo("fmt").args(["--all", "--check"])),
        step("format, examples/pico", format_of("examples/pico")),
        step("format, fuzz", format_of("fuzz")),
        step("format, xtask/faulty", format_of("xtask/faulty")),
        step("format, xtask/no_panic", format_of("xtask/no_panic")),
        step("format, xtask/firmware", format_of("xtask/firmware")),
        step("format, xtask/stack_peak", format_of("xtask/stack_peak")),
        step("format, examples/microbit", format_of("examples/microbit")),
        step("format, examples/riscv", format_of("examples/riscv")),
        step(
            "clippy, everything, all features",
            cargo("clippy")
                .args(["--workspace", "--all-targets", "--all-features"])
                .args(deny),
        ),
        step(
            "clippy, the library without features",
            cargo("clippy").args(library).args(deny),
        ),
        step(
            "tests",
            cargo("test").args(["--workspace", "--features", FEATURES]),
        ),
        step(
            "tests, ten million rays from every kind of surface",
            cargo("test")
                .args(["--workspace", "--features", FEATURES, "--lib"])
                .args(["--", "--ignored"]),
        ),
        step(
            "fuzz, 30 seconds",
            cargo("xtask").args(["fuzz", "--seconds", "30"]),
        ),
        step(
            "documentation",
            cargo("doc")
                .args(["--package", "reflet", "--no-deps", "--features", FEATURES])
                .env("RUSTDOCFLAGS", "-D warnings"),
        ),
        step("bare metal, no features", unused(library)),
        step(
            "bare metal, scenes and micromath",
            unused(library).args(["--features", FIRMWARE_FEATURES]),
        ),
    ];
    // Clippy belongs to the toolchain in use, which may have no core library for a board.
    if let BareMetal::Prebuilt = bare_metal {
        let board = cargo("clippy")
            .args(["--release", "--package", "reflet", "--example", "board"])
            .args(["--target", "thumbv7m-none-eabi"]);
        steps.push(step("clippy, the default board", board.args(deny)));
        for (name, package, target) in [
            ("clippy, xtask/firmware", "xtask/firmware", TARGETS[0]),
            (
                "clippy, xtask/firmware, RISC-V",
                "xtask/firmware",
                TARGETS[4],
            ),
            ("clippy, examples/microbit", "examples/microbit", TARGETS[0]),
            ("clippy, examples/riscv", "examples/riscv", TARGETS[4]),
        ] {
            steps.push(step(name, clippy_of(package, target).args(deny)));
        }
        let pico = cargo("clippy")
            .args(["--release", "--manifest-path", "examples/pico/Cargo.toml"])
            .args(["--target", "thumbv6m-none-eabi"]);
        steps.push(step("clippy, examples/pico", pico.args(deny)));
    }
    steps
}

/// The format of a package that stands alone.
fn format_of(package: &str) -> Program {
    let manifest = format!("{package}/Cargo.toml");
    cargo("fmt").args(["--check", "--manifest-path", &manifest])
}

/// Clippy for a package that stands alone. What is measured by the firmware is generated, so only
/// its library is looked at.
fn clippy_of(package: &str, target: &str) -> Program {
    let manifest = format!("{package}/Cargo.toml");
    let parts = if package == "xtask/firmware" {
        "--lib"
    } else {
        "--bins"
    };
    cargo("clippy").args([
        "--release",
        "--target",
        target,
        parts,
        "--manifest-path",
        &manifest,
    ])
}

fn cargo(subcommand: &str) -> Program {
    Program::new("cargo").args([subcommand])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_step_that_fails_is_named_and_the_last() {
        let step = |name, program| Step {
            name,
            program: Program::new(program),
        };
        let steps = vec![
            step("well", "true"),
            step("ill", "false"),
            step("unmet", "no-such-program"),
        ];
        assert_eq!(
            format!("{:#}", pass(steps).unwrap_err()),
            "the step `ill` failed: `false` failed (exit status: 1)"
        );
    }
}
