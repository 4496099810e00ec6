//! Sets up the Rust toolchain and builds for microcontrollers.
//!
//! The compiled core library of a target comes from rustup. Where rustup is out of reach, Debian has
//! a compiler with the source of the core library, and cargo compiles that with the program.

use std::env;
use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::time::Duration;

use anyhow::{Context, Result};
use serde_json::Value;

use crate::{apt, command::Program, need, root};

pub const M0: &str = "thumbv6m-none-eabi";
pub const M3: &str = "thumbv7m-none-eabi";
/// Cortex-M4F and M7.
pub const M4F: &str = "thumbv7em-none-eabihf";
pub const M33: &str = "thumbv8m.main-none-eabihf";
pub const RV32IMAC: &str = "riscv32imac-unknown-none-elf";
pub const RV32IMC: &str = "riscv32imc-unknown-none-elf";

/// The targets that reflet is built for.
pub const TARGETS: [&str; 6] = [M0, M3, M4F, M33, RV32IMAC, RV32IMC];

pub const WASM: &str = "wasm32-unknown-unknown";

/// The oldest Rust version that the library supports, from Cargo.toml.
pub const OLDEST_RUST: &str = env!("CARGO_PKG_RUST_VERSION");

/// Commands by which a person installs the bare-metal targets.
pub const BARE_METAL_BY_HAND: &str = "rustup target add thumbv6m-none-eabi thumbv7m-none-eabi \
     thumbv7em-none-eabihf thumbv8m.main-none-eabihf riscv32imac-unknown-none-elf riscv32imc-unknown-none-elf, \
     or as root: apt-get install --no-install-recommends rustc-web rust-web-src";

/// Time limit of rustup. It takes seconds if its server answers, and may wait for ever if not.
const RUSTUP_LIMIT: Duration = Duration::from_secs(5 * 60);

/// Time limit of a build. The first build compiles dozens of crates; later builds take seconds.
const BUILD_LIMIT: Duration = Duration::from_secs(10 * 60);

const DEBIAN_RUSTC: &str = "/usr/bin/rustc";

/// Installs the core library for the bare-metal targets: compiled ones from rustup, else the source
/// from Debian.
pub fn get_bare_metal() -> Result<()> {
    let Err(refusal) = rustup(&[&["target", "add"], &TARGETS[..]].concat()) else {
        return Ok(());
    };
    eprintln!("       {refusal:#}; Debian's compiler and library source instead");
    apt::install(&["rustc-web", "rust-web-src"]).context(refusal)
}

pub fn get_oldest_rust() -> Result<()> {
    rustup(&["toolchain", "install", OLDEST_RUST, "--profile", "minimal"])
}

pub fn has_wasm() -> bool {
    let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
    rust_library(&rustc).is_some_and(|library| library.join(WASM).is_dir())
}

pub fn has_oldest_rust() -> bool {
    let toolchain = format!("+{OLDEST_RUST}");
    Program::new("cargo")
        .args([&*toolchain, "--version"])
        .succeeds()
}

pub fn rustup(arguments: &[&str]) -> Result<()> {
    let rustup = Program::new("rustup")
        .args(arguments)
        .env("RUST_BACKTRACE", "0")
        .limit(RUSTUP_LIMIT);
    eprintln!("       {rustup}");
    Ok(rustup.stream_to_stderr()?)
}

/// How to build for every target of [`TARGETS`] on this machine.
#[derive(Debug)]
pub enum BareMetal {
    /// The toolchain in use has the compiled core library of every target.
    Prebuilt,
    /// `rustc` has the source of the core library, and `linker` can link for the targets.
    BuildStd {
        rustc: OsString,
        linker: Option<PathBuf>,
    },
}

impl BareMetal {
    /// Returns how this machine can build. Installs the targets first if they are missing.
    pub fn get() -> Result<Self> {
        need::BARE_METAL.get_if_missing()?;
        Self::find().context("the bare-metal targets are gone again")
    }

    /// Returns how this machine can build, or `None` if it cannot. Quick: it only looks for files.
    pub fn find() -> Option<Self> {
        let rustc = env::var_os("RUSTC").unwrap_or_else(|| "rustc".into());
        let library = rust_library(&rustc)?;
        if TARGETS.iter().all(|target| library.join(target).is_dir()) {
            return Some(Self::Prebuilt);
        }
        let source = |rustc: &OsString| {
            rust_library(rustc).is_some_and(|it| it.join("src/rust/library/core").is_dir())
        };
        Some(Self::BuildStd {
            rustc: [rustc, DEBIAN_RUSTC.into()].into_iter().find(source)?,
            linker: find_linker(&library),
        })
    }

    /// Returns the command `cargo SUBCOMMAND` for `targets`. Its environment variables are set for
    /// this command only, because no build for the host may see them.
    pub fn cargo(&self, subcommand: &str, targets: &[&str]) -> Program {
        let flags = targets.iter().flat_map(|target| ["--target", target]);
        let cargo = Program::new("cargo").args([subcommand]).args(flags);
        let Self::BuildStd { rustc, linker } = self else {
            return cargo;
        };
        let cargo = cargo
            .env("RUSTC", rustc)
            .env("RUSTC_BOOTSTRAP", "1")
            .env("CARGO_UNSTABLE_BUILD_STD", "core,compiler_builtins")
            .env("CARGO_TARGET_DIR", target_directory().join("build-std"));
        targets.iter().fold(cargo, |cargo, target| match linker {
            Some(linker) => cargo.env(linker_variable(target), linker),
            None => cargo,
        })
    }
}

/// Builds one program of a package outside of the workspace, in release mode. `package` is its folder.
pub fn build_alone(target: &str, package: &Path, more: &[&str]) -> Result<PathBuf> {
    let cargo = cargo_build("release", target)?.args(more);
    built(outside(cargo, package, &directory_for(target)))
}

/// Builds a package outside of the workspace for WebAssembly, in release mode. Installs the target first
/// if it is missing. Returns the path of the module.
pub fn build_wasm(package: &Path) -> Result<PathBuf> {
    need::WASM.get_if_missing()?;
    let cargo = Program::new("cargo").args(["build", "--release", "--locked", "--target", WASM]);
    let cargo = cargo.args(["--message-format=json-render-diagnostics"]);
    let messages = messages(alone(cargo.limit(BUILD_LIMIT), package))?;
    let files = messages.iter().filter_map(|it| it["filenames"].as_array());
    let modules = files.flatten().filter_map(Value::as_str).map(PathBuf::from);
    let mut modules = modules.filter(|it| it.extension().is_some_and(|it| it == "wasm"));
    modules.next_back().context("cargo built no WebAssembly")
}

/// Builds one program of a package that needs the crate of a chip, in release mode.
pub fn build_for_chip(target: &str, package: &Path, program: &str) -> Result<PathBuf> {
    build_alone(target, package, &["--bin", program])
}

/// Adds the arguments for a package outside of the workspace that is checked, or built for browsers, to a command of
/// cargo. All of them share one target folder and one set of flags, so what several need is checked once for each target.
pub fn alone(cargo: Program, package: &Path) -> Program {
    outside(cargo, package, &alone_directory())
}

/// Adds the arguments for a package outside of the workspace, with this target folder.
pub fn outside(cargo: Program, package: &Path, place: &Path) -> Program {
    let manifest = root().join(package).join("Cargo.toml");
    cargo
        .args(["--manifest-path".as_ref(), manifest.as_os_str()])
        .args(["--target-dir".as_ref(), place.as_os_str()])
        // Instead of the flags in the repository's configuration, which are for the default board.
        .env("CARGO_ENCODED_RUSTFLAGS", "")
}

/// Returns cargo's target folder for packages outside of the workspace.
pub fn alone_directory() -> PathBuf {
    target_directory().join("alone")
}

/// Returns cargo's target folder for firmware of a target. All firmware of one target shares a folder, so that what
/// several need is compiled once. The cores of the boards that people own have another folder than the rest, because
/// cargo builds in two folders at the same time.
pub fn directory_for(target: &str) -> PathBuf {
    match target {
        M0 | M4F | M33 => target_directory().join("chips"),
        _ => alone_directory(),
    }
}

/// Returns a call of cargo that builds for a target in a profile. The caller adds the arguments that name the program, and
/// runs it by [`built`]. It uses cargo's configuration of the folder in which it runs.
pub fn cargo_build(profile: &str, target: &str) -> Result<Program> {
    Ok(BareMetal::get()?
        .cargo("build", &[target])
        .args(["--profile", profile, "--locked"])
        .args(["--message-format=json-render-diagnostics"])
        .limit(BUILD_LIMIT))
}

/// Runs cargo and returns the path of the program, from cargo's messages.
pub fn built(cargo: Program) -> Result<PathBuf> {
    let messages = messages(cargo)?;
    let programs = messages.iter().filter_map(|it| it["executable"].as_str());
    let mut programs = programs.map(PathBuf::from);
    programs.next_back().context("cargo built no program")
}

/// Runs cargo and returns its messages.
fn messages(cargo: Program) -> Result<Vec<Value>> {
    let lines = cargo.read()?;
    let messages = lines.lines().map(serde_json::from_str);
    Ok(messages.flatten().collect())
}

/// Returns the folder with the libraries of `rustc`. It has one folder for each target.
fn rust_library(rustc: &OsString) -> Option<PathBuf> {
    let sysroot = Program::new(rustc)
        .args(["--print", "sysroot"])
        .read()
        .ok()?;
    Some(Path::new(&sysroot).join("lib/rustlib"))
}

/// Returns the linker of rustup's toolchain. Debian's toolchain has no linker for these targets.
fn find_linker(library: &Path) -> Option<PathBuf> {
    let tools = library.read_dir().ok()?.flatten();
    tools
        .map(|host| host.path().join("bin/rust-lld"))
        .find(|linker| linker.is_file())
}

pub fn target_directory() -> PathBuf {
    root().join(env::var_os("CARGO_TARGET_DIR").unwrap_or_else(|| "target".into()))
}

/// Returns the name of the environment variable that gives cargo a target's linker.
fn linker_variable(target: &str) -> String {
    let name = target.replace(['-', '.'], "_").to_uppercase();
    format!("CARGO_TARGET_{name}_LINKER")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn advice_by_hand_names_every_target() {
        let is_named = |target: &&str| BARE_METAL_BY_HAND.contains(target);
        assert!(TARGETS.iter().all(is_named));
    }

    #[test]
    fn linker_variable_is_spelt_as_cargo_reads_it() {
        let name = linker_variable("thumbv8m.main-none-eabihf");
        assert_eq!(name, "CARGO_TARGET_THUMBV8M_MAIN_NONE_EABIHF_LINKER");
    }
}
