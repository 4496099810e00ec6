//! The RP2040: runs a firmware of `examples/pico` on both cores, presses its keys and looks at its
//! display; or runs the measurement firmware for thumbv6m and counts its cycles.
//!
//! The emulator is rp2040js, driven by the script in `xtask/emulator/rp2040`. A run is the same
//! every time, and ends after a number of cycles if not before. A firmware that ends badly is a
//! [`Failure`] that repeats its words and names the fault.

use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fmt, fs, io};

use serde::Deserialize;
use serde_json::Value;
use tempfile::TempDir;

use super::qemu::quote;
use crate::command::{Program, after};
use crate::{command, root};

/// The pixels of a side of the display.
pub const SIDE: u32 = 240;

/// Longer than any run takes that ends by itself, on a machine that has other work to do.
const LIMIT: Duration = Duration::from_secs(20 * 60);

/// A minute of the chip's time.
const CYCLES: u64 = 60 * 125_000_000;

pub fn folder() -> PathBuf {
    root().join("xtask/emulator/rp2040")
}

pub fn is_installed() -> bool {
    let packages = |file: &str| {
        let lock: Value = serde_json::from_slice(&fs::read(folder().join(file)).ok()?).ok()?;
        let mut packages = lock["packages"].as_object()?.clone();
        packages.remove("");
        Some(packages)
    };
    let wanted = packages("package-lock.json");
    wanted.is_some() && wanted == packages("node_modules/.package-lock.json")
}

pub fn install() -> Result<(), command::Failure> {
    let npm = Program::new("npm").args(["ci", "--no-audit", "--no-fund", "--prefix"]);
    npm.args([folder()]).limit(LIMIT).stream()
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    Up,
    Down,
    Left,
    Right,
    Select,
}

/// An RP2040 about to be switched on, and what is to be done with it.
#[derive(Clone, Debug, Default)]
pub struct Rp2040 {
    /// The script's; of two with one name, the later counts.
    options: Vec<String>,
    frames: Vec<String>,
}

impl Rp2040 {
    /// With a second core that does not answer, as most emulators have it.
    pub fn with_one_core(self) -> Self {
        self.option("cores", 1)
    }

    /// The cycles after which the firmware is ended, and has failed; a minute's worth
    /// unless they are named.
    pub fn limit(self, cycles: u64) -> Self {
        self.option("limit", cycles)
    }

    /// Waits for one more picture after these keys have been pressed, one after the other; those of
    /// the first picture are pressed while it is being drawn. The last picture ends the run.
    pub fn picture(mut self, keys: &[Key]) -> Self {
        // The script's names for them.
        let names = keys.iter().map(|key| format!("{key:?}").to_lowercase());
        let names: Vec<_> = names.collect();
        self.frames.push(match names[..] {
            [] => "-".into(),
            _ => names.join("+"),
        });
        self
    }

    /// Takes a picture as soon as so many rows of it are drawn, counted from the top.
    pub fn rows(self, rows: u32) -> Self {
        self.option("rows", rows)
    }

    /// Lets the timer of the measurement firmware count instructions as QEMU's does, not cycles.
    pub fn counting_instructions(self) -> Self {
        self.option("counts", "instructions")
    }

    fn option(mut self, name: &str, value: impl fmt::Display) -> Self {
        self.options.push(format!("--{name}={value}"));
        self
    }

    /// Runs a firmware until its last picture is drawn, or else until it ends itself.
    pub fn run(&self, firmware: &Path) -> Result<Run, Failure> {
        if !is_installed() {
            return Err(Failure::NotInstalled);
        }
        let pictures = TempDir::with_prefix("reflet-")?;
        let prefix = pictures.path().join("picture");
        let report = Program::new("node")
            .args([folder().join("run.js"), firmware.to_owned()])
            .args([format!("--limit={CYCLES}")])
            .args(&self.options)
            // A list that begins with a hyphen is not an option.
            .args([format!("--frames={}", self.frames.join(","))])
            .args(["--pictures".as_ref(), prefix.as_os_str()])
            .limit(LIMIT)
            .read()?;
        let report: Report = serde_json::from_str(&report).map_err(Failure::Report)?;
        report.judge(&prefix)
    }
}

#[derive(Deserialize)]
struct Report {
    fault: Option<Fault>,
    #[serde(flatten)]
    counts: Counts,
    frames: Vec<Counts>,
    said: Words,
    display: Display,
}

#[derive(Deserialize)]
struct Fault {
    reason: String,
    function: Option<String>,
}

#[derive(Deserialize)]
struct Words {
    rtt: Vec<String>,
    semihosting: Vec<Line>,
}

#[derive(Deserialize)]
struct Line {
    text: String,
}

/// How far a run had come.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
pub struct Counts {
    pub cycles: u64,
    /// Instructions since the reset, of both cores together.
    pub instructions: u64,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "camelCase")]
pub struct Display {
    /// Whether it inverts the colours, as in-plane switching panels want it.
    pub inverted: bool,
    /// Which way it fills its memory: MADCTL in the data sheet.
    pub address_mode: u8,
}

#[derive(Debug)]
pub struct Run {
    pub pictures: Vec<Picture>,
    /// What the firmware said, by RTT and then by semihosting.
    pub said: Vec<String>,
    pub display: Display,
    pub counts: Counts,
}

#[derive(Debug)]
pub struct Picture {
    pub counts: Counts,
    /// Row by row from the top, as RGB565.
    pub pixels: Vec<u16>,
}

impl Report {
    /// Reads the pictures from `PREFIX-0.rgb565` and so on, if all went well.
    fn judge(self, prefix: &Path) -> Result<Run, Failure> {
        let mut said = self.said.rtt;
        said.extend(self.said.semihosting.into_iter().map(|line| line.text));
        if let Some(Fault { reason, function }) = self.fault {
            let function = function.map(|name| format!("{:#}", rustc_demangle::demangle(&name)));
            return Err(Failure::Fault {
                reason,
                function,
                said: said.join("\n"),
            });
        }
        let picture = |(index, counts)| {
            let bytes = fs::read(format!("{}-{index}.rgb565", prefix.display()))?;
            let pixels = bytes.chunks_exact(2);
            let pixels = pixels.map(|it| u16::from_be_bytes([it[0], it[1]]));
            Ok(Picture {
                counts,
                pixels: pixels.collect(),
            })
        };
        let pictures = self.frames.into_iter().enumerate().map(picture);
        Ok(Run {
            pictures: pictures.collect::<io::Result<_>>()?,
            said,
            display: self.display,
            counts: self.counts,
        })
    }
}

#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error("the packages of {} are missing: `cargo xtask setup` gets them", folder().display())]
    NotInstalled,
    #[error(transparent)]
    Emulator(#[from] command::Failure),
    #[error("the emulator's report is unreadable: {0}")]
    Report(serde_json::Error),
    #[error("a picture cannot be handed over: {0}")]
    Picture(#[from] io::Error),
    #[error(
        "the firmware failed: {reason}{}{}",
        after(" in ", function.as_deref().unwrap_or_default()),
        quote(said)
    )]
    Fault {
        reason: String,
        function: Option<String>,
        said: String,
    },
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lock_file_names_no_server() {
        let lock = fs::read_to_string(folder().join("package-lock.json")).unwrap();
        assert!(lock.contains("\"integrity\"") && !lock.contains("://"));
    }

    #[test]
    fn fault_is_named_with_where_it_was_and_the_last_words() {
        let report = r#"{
            "fault": { "reason": "no such memory", "function": "_ZN4pico5cores4main17h0123456789abcdefE" },
            "cycles": 2, "instructions": 1, "frames": [],
            "said": { "rtt": ["cores: 2"], "semihosting": [] },
            "display": { "inverted": false, "addressMode": 0 }
        }"#;
        let report: Report = serde_json::from_str(report).unwrap();
        assert_eq!(
            report.judge(Path::new("")).unwrap_err().to_string(),
            "the firmware failed: no such memory in pico::cores::main; it said:\n\
             cores: 2"
        );
    }
}
