//! The RP2040: runs a firmware of `examples/pico` on both cores, presses its keys and captures its
//! display. Or runs the measurement firmware for thumbv6m and counts its cycles.
//!
//! The emulator is rp2040js, controlled by the script in `xtask/emulator/rp2040`. A run gives the
//! same result every time, and ends after a limited number of cycles at the latest. A firmware that
//! ends with an error is a [`Failure`] that repeats the firmware's output and names the fault.

use std::path::{Path, PathBuf};
use std::time::Duration;
use std::{fmt, fs, io};

use serde::Deserialize;
use serde_json::Value;
use tempfile::TempDir;

use super::qemu::quote;
use crate::command::{Program, after};
use crate::need::{self, Need};
use crate::{command, root};

/// Width and height of the display in pixels.
pub const SIDE: u32 = 240;

/// Time limit of the emulator: longer than any run that ends by itself takes on a busy machine.
const LIMIT: Duration = Duration::from_secs(20 * 60);

/// Default limit of a run in cycles: one minute at 125 MHz.
const CYCLES: u64 = 60 * 125_000_000;

pub fn folder() -> PathBuf {
    root().join("xtask/emulator/rp2040")
}

pub fn is_installed() -> bool {
    is_installed_in(&folder())
}

/// Tests whether the packages of a lock file are installed in its folder.
fn is_installed_in(folder: &Path) -> bool {
    let packages = |file: &str| {
        let lock: Value = serde_json::from_slice(&fs::read(folder.join(file)).ok()?).ok()?;
        let mut packages = lock["packages"].as_object()?.clone();
        packages.remove("");
        Some(packages)
    };
    let wanted = packages("package-lock.json");
    wanted.is_some() && wanted == packages("node_modules/.package-lock.json")
}

pub fn install() -> Result<(), command::Failure> {
    let npm = Program::new("npm").args(["ci", "--no-audit", "--no-fund", "--prefix"]);
    npm.args([folder()]).limit(LIMIT).stream_to_stderr()
}

/// Returns what a run needs, in the order of installation. npm only installs the packages.
fn needs(is_installed: bool) -> Vec<&'static Need> {
    match is_installed {
        true => vec![&need::NODE],
        false => vec![&need::NODE, &need::NPM, &need::RP2040_EMULATOR],
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    Up,
    Down,
    Left,
    Right,
    Select,
}

/// An RP2040 before it is switched on: the options of the run and the pictures to wait for.
#[derive(Clone, Debug, Default)]
pub struct Rp2040 {
    /// Options of the script. If a name occurs twice, the script takes the later one.
    options: Vec<String>,
    frames: Vec<String>,
}

impl Rp2040 {
    /// Emulates a chip whose second core does not answer, as most emulators do.
    pub fn with_one_core(self) -> Self {
        self.option("cores", 1)
    }

    /// Sets the limit of the run in cycles. A firmware that reaches it has failed. Default: one
    /// minute at 125 MHz.
    pub fn limit(self, cycles: u64) -> Self {
        self.option("limit", cycles)
    }

    /// Waits for one more picture after these keys have been pressed one after another. The keys of
    /// the first picture are pressed while that picture is drawn. The run ends with the last
    /// picture.
    pub fn picture(mut self, keys: &[Key]) -> Self {
        // The script expects the names in lower case.
        let names = keys.iter().map(|key| format!("{key:?}").to_lowercase());
        let names: Vec<_> = names.collect();
        self.frames.push(match names[..] {
            [] => "-".into(),
            _ => names.join("+"),
        });
        self
    }

    /// Captures each picture as soon as this many of its rows are drawn, counted from the top.
    pub fn rows(self, rows: u32) -> Self {
        self.option("rows", rows)
    }

    /// Makes the timer of the measurement firmware count instructions, as QEMU's does, instead of
    /// cycles.
    pub fn counting_instructions(self) -> Self {
        self.option("counts", "instructions")
    }

    fn option(mut self, name: &str, value: impl fmt::Display) -> Self {
        self.options.push(format!("--{name}={value}"));
        self
    }

    /// Runs a firmware until its last picture is drawn, or until the firmware ends itself. Installs the
    /// emulator if it is missing.
    pub fn run(&self, firmware: &Path) -> Result<Run, Failure> {
        let mut needs = needs(is_installed()).into_iter();
        needs
            .try_for_each(Need::get_if_missing)
            .map_err(Failure::Missing)?;
        let pictures = TempDir::with_prefix("reflet-")?;
        let prefix = pictures.path().join("picture");
        let report = Program::new("node")
            .args([folder().join("run.js"), firmware.to_owned()])
            .args([format!("--limit={CYCLES}")])
            .args(&self.options)
            // With `=`, a list that begins with a hyphen is not taken for an option.
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

/// Cycles and instructions from the reset to a point of a run.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
pub struct Counts {
    pub cycles: u64,
    /// Instructions since the reset; the sum of both cores.
    pub instructions: u64,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "camelCase")]
pub struct Display {
    /// Whether the firmware made the display invert its colours, as in-plane switching panels need.
    pub inverted: bool,
    /// Direction in which the display fills its memory: MADCTL in the data sheet.
    pub address_mode: u8,
}

#[derive(Debug)]
pub struct Run {
    pub pictures: Vec<Picture>,
    /// Lines that the firmware printed: first those by RTT, then those by semihosting.
    pub said: Vec<String>,
    pub display: Display,
    pub counts: Counts,
}

#[derive(Debug)]
pub struct Picture {
    pub counts: Counts,
    /// Pixels in RGB565, row by row from the top.
    pub pixels: Vec<u16>,
}

impl Report {
    /// Returns the run with its pictures, or the fault. Reads the pictures from `PREFIX-0.rgb565`
    /// and so on.
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
    #[error("{0:#}")]
    Missing(anyhow::Error),
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
    fn packages_are_installed_if_their_folder_is_missing_or_old() {
        let folder = TempDir::new().unwrap();
        let write = |file: &str, version: u32| {
            let lock = format!(r#"{{ "packages": {{ "": {{}}, "node_modules/a": {version} }} }}"#);
            fs::write(folder.path().join(file), lock).unwrap();
        };
        let names = || {
            let needs = needs(is_installed_in(folder.path()));
            needs.iter().map(|need| need.name).collect::<Vec<_>>()
        };
        let all = ["node", "npm", "RP2040 emulator"];
        write("package-lock.json", 2);
        assert_eq!(names(), all);
        fs::create_dir(folder.path().join("node_modules")).unwrap();
        write("node_modules/.package-lock.json", 1);
        assert_eq!(names(), all);
        write("node_modules/.package-lock.json", 2);
        assert_eq!(names(), ["node"]);
    }

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
