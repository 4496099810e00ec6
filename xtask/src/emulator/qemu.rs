//! QEMU: boots a firmware on an emulated board, collects its semihosting output, presses its keys
//! and captures its display.
//!
//! Every run has a time limit, and no process is left behind. A firmware that ends with an error, or
//! hangs in a fault, is a [`Failure`] that repeats the firmware's last output and names the fault.
//! This module knows no particular firmware.

use std::{env, ffi::OsStr, path::Path, process::ExitStatus, time::Duration};

use image::RgbImage;
use serde::Serialize;
use serde_json::{Value, json};
use tempfile::TempDir;

use super::qmp::{self, Monitor};
use crate::command::{self, Program, after};
use crate::need::{self, Need};

/// An emulated board before it boots: the emulator's command line and the time limit. It is installed
/// if it is missing.
#[derive(Debug)]
pub struct Qemu {
    name: &'static str,
    need: &'static Need,
    program: Program,
}

impl Qemu {
    pub fn arm(machine: &str) -> Self {
        Self::new("qemu-system-arm", &need::QEMU_ARM).args(["-M", machine])
    }

    /// Emulates QEMU's 32-bit RISC-V board (`virt`) without a BIOS: only our firmware runs.
    pub fn riscv32() -> Self {
        Self::new("qemu-system-riscv32", &need::QEMU_RISCV).args(["-M", "virt", "-bios", "none"])
    }

    fn new(name: &'static str, need: &'static Need) -> Self {
        let program = Program::new(name);
        let qemu = Self {
            name,
            need,
            program,
        };
        qemu.args(["-semihosting-config", "enable=on,target=native"])
            .args(["-serial", "null", "-monitor", "none"])
    }

    pub fn args<A: AsRef<OsStr>>(self, arguments: impl IntoIterator<Item = A>) -> Self {
        let program = self.program.args(arguments);
        Self { program, ..self }
    }

    /// Makes every instruction take 2^`shift` ns of emulated time. So the board's timers count
    /// instructions.
    pub fn counting_instructions(self, shift: u8) -> Self {
        self.args(["-icount", &format!("shift={shift}")])
    }

    /// Sets the time limit. After it, the firmware is ended. Default: one minute.
    pub fn limit(self, limit: Duration) -> Self {
        let program = self.program.limit(limit);
        Self { program, ..self }
    }

    /// Runs a firmware until it ends by itself, and returns its output.
    pub fn run(self, firmware: &Path) -> Result<String, Failure> {
        self.boot(firmware)?.end()
    }

    /// Runs a firmware one instruction at a time and calls `see` with the address of each. Stops
    /// when the firmware ends by itself or `see` fails.
    pub fn trace(
        self,
        firmware: &Path,
        mut see: impl FnMut(u32) -> anyhow::Result<()>,
    ) -> anyhow::Result<()> {
        let stepping = self.one_by_one()?;
        let logged = self.args(["-d", "exec,nochain"]).args(stepping);
        let mut running = logged.boot(firmware)?;
        while let Some(line) = running.receive()? {
            match executed(&line) {
                Some(address) => see(address)?,
                None => running.said.push(line),
            }
        }
        running.end()?;
        Ok(())
    }

    /// Boots a firmware without a window, and returns while it runs.
    pub fn boot(self, firmware: &Path) -> Result<Running, Failure> {
        let folder = TempDir::with_prefix("reflet-").map_err(|error| command::Failure::Start {
            program: self.name.to_owned(),
            error,
        })?;
        let socket = folder.path().join(MONITOR);
        let monitor = format!("unix:{},server=on,wait=off", socket.display());
        let program = self.kernel(firmware)?.args(["-display", "none"]);
        Ok(Running {
            program: program.args(["-qmp", &monitor]).start()?,
            said: Vec::new(),
            folder,
            monitor: None,
        })
    }

    /// Runs a firmware for a person until they or the firmware end it. There is no time limit, the
    /// output goes to our standard output, and the display opens in a window if this machine has a
    /// screen.
    pub fn show(self, firmware: &Path) -> Result<(), Failure> {
        let unseen = ["-display", "none"].into_iter().filter(|_| !has_screen());
        let program = self.kernel(firmware)?.args(unseen).limit(Duration::MAX);
        Ok(program.stream()?)
    }

    fn kernel(self, firmware: &Path) -> Result<Program, Failure> {
        self.get_if_missing()?;
        Ok(self.program.args(["-kernel".as_ref(), firmware]))
    }

    /// Returns the options that make QEMU execute one instruction at a time. They changed in version
    /// 8.1, so QEMU is installed first if it is missing.
    fn one_by_one(&self) -> Result<&'static [&'static str], Failure> {
        self.get_if_missing()?;
        let printed = Program::new(self.name).args(["--version"]).read();
        Ok(match printed.ok().as_deref().and_then(version) {
            Some(version) if version < (8, 1) => &["-singlestep"],
            _ => &["-accel", "tcg,one-insn-per-tb=on"],
        })
    }

    fn get_if_missing(&self) -> Result<(), Failure> {
        self.need.get_if_missing().map_err(Failure::Missing)
    }
}

/// Name of the monitor's socket, in the folder of the run.
const MONITOR: &str = "monitor";

/// Tests whether a window can be opened: on macOS always, elsewhere if X or Wayland is running.
fn has_screen() -> bool {
    let is_named = |variable| env::var_os(variable).is_some_and(|value| !value.is_empty());
    cfg!(target_os = "macos") || ["DISPLAY", "WAYLAND_DISPLAY"].into_iter().any(is_named)
}

/// A key of the keyboard that QEMU emulates. Each board's firmware gives the keys their meaning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "lowercase")]
pub enum Key {
    Left,
    Right,
    Up,
    Down,
    #[serde(rename = "ctrl")]
    Control,
}

/// A running firmware. Dropping it ends the firmware.
#[derive(Debug)]
pub struct Running {
    program: command::Running,
    said: Vec<String>,
    folder: TempDir,
    monitor: Option<Monitor>,
}

impl Running {
    /// Waits until the firmware prints a line that is `wanted`, and returns this line.
    ///
    /// Fails if the firmware ends before it prints such a line.
    pub fn line(&mut self, wanted: impl Fn(&str) -> bool) -> Result<String, Failure> {
        while let Some(line) = self.next_line()? {
            if wanted(&line) {
                return Ok(line);
            }
        }
        let said = self.judged()?;
        Err(Failure::Silence { said })
    }

    /// Waits until the firmware ends by itself, and returns its output.
    pub fn end(mut self) -> Result<String, Failure> {
        while self.next_line()?.is_some() {}
        self.judged()
    }

    pub fn press(&mut self, key: Key) -> Result<(), Failure> {
        let key = json!({ "type": "qcode", "data": key });
        for down in [true, false] {
            let event = json!({ "type": "key", "data": { "down": down, "key": key } });
            self.ask("input-send-event", json!({ "events": [event] }))?;
        }
        Ok(())
    }

    pub fn screen(&mut self) -> Result<RgbImage, Failure> {
        let file = self.folder.path().join("screen.ppm");
        self.ask("screendump", json!({ "filename": file }))?;
        Ok(image::open(file).map_err(Failure::Screen)?.to_rgb8())
    }

    /// Reads the next line and adds it to the firmware's output. Returns `None` after the firmware
    /// ended.
    fn next_line(&mut self) -> Result<Option<String>, Failure> {
        let line = self.receive()?;
        self.said.extend(line.clone());
        Ok(line)
    }

    /// Reads the next line without adding it to the firmware's output. Returns `None` after the end.
    fn receive(&mut self) -> Result<Option<String>, Failure> {
        let line = self.program.line();
        line.map_err(|failure| self.named(failure))
    }

    /// Returns the firmware's output if it ended with success.
    fn judged(&mut self) -> Result<String, Failure> {
        let status = self.program.status();
        let status = status.map_err(|failure| self.named(failure))?;
        if status.success() {
            Ok(self.said.join("\n"))
        } else {
            Err(Failure::Fault {
                status,
                said: tail(&self.said),
            })
        }
    }

    /// Converts a failure of the emulator into a failure of the firmware. A timeout also gets the
    /// place where the core is.
    fn named(&mut self, failure: command::Failure) -> Failure {
        let command::Failure::TimeOut { limit, .. } = failure else {
            return failure.into();
        };
        // If the monitor does not answer either, the message just has no place.
        let arguments = json!({ "command-line": "info registers" });
        let registers = self.ask("human-monitor-command", arguments);
        let registers = registers.unwrap_or_default();
        Failure::TimeOut {
            limit,
            whereabouts: registers.as_str().and_then(whereabouts),
            said: tail(&self.said),
        }
    }

    fn ask(&mut self, command: &str, arguments: Value) -> Result<Value, Failure> {
        let monitor = match &mut self.monitor {
            Some(monitor) => monitor,
            none => none.insert(Monitor::connect(&self.folder.path().join(MONITOR))?),
        };
        Ok(monitor.execute(command, arguments)?)
    }
}

/// Parses the version from `QEMU emulator version 7.2.22 (Debian ...)`: here (7, 2).
fn version(printed: &str) -> Option<(u32, u32)> {
    let (_, numbers) = printed.split_once(" version ")?;
    let mut numbers = numbers.split(|letter: char| !letter.is_ascii_digit());
    Some((numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?))
}

/// Parses the address of an executed instruction from a line of QEMU's log:
/// `Trace 0: 0x7f65b0004940 [00800400/00002f44/00000110/ff000201] function`.
fn executed(line: &str) -> Option<u32> {
    let (_, state) = line.strip_prefix("Trace ")?.split_once('[')?;
    u32::from_str_radix(state.split('/').nth(1)?, 16).ok()
}

/// Describes where a Cortex-M is, from QEMU's list of its registers: the exception that it handles,
/// if any, and the program counter.
fn whereabouts(registers: &str) -> Option<String> {
    let register = |name: &str| {
        let start = registers.find(name)? + name.len();
        let digits = registers.get(start..start + 8)?;
        u32::from_str_radix(digits, 16).ok()
    };
    let (state, counter) = (register("XPSR=")?, register("R15=")?);
    Some(match state & 0x1ff {
        0 => format!("it is at {counter:#010x}"),
        exception => format!("it is in {} at {counter:#010x}", exception_name(exception)),
    })
}

/// Returns the name of an exception. ARMv7-M Architecture Reference Manual, B1.5.2.
fn exception_name(number: u32) -> String {
    match number {
        2 => "NMI".into(),
        3 => "HardFault".into(),
        4 => "MemManage".into(),
        5 => "BusFault".into(),
        6 => "UsageFault".into(),
        11 => "SVCall".into(),
        14 => "PendSV".into(),
        15 => "SysTick".into(),
        number => format!("exception {number}"),
    }
}

/// Returns the last 20 lines of the output: enough for a panic's message or QEMU's list of
/// registers.
fn tail(said: &[String]) -> String {
    said[said.len().saturating_sub(20)..].join("\n")
}

#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error("{0:#}")]
    Missing(anyhow::Error),
    #[error("{failure}")]
    Start { failure: command::Failure },
    /// The firmware ended with an error: a panic, a fault, or its own exit status.
    #[error("the firmware failed ({status}){}", quote(said))]
    Fault { status: ExitStatus, said: String },
    /// The firmware did not end, or did not print the line that was waited for, within the time
    /// limit.
    #[error(
        "the firmware was ended after {} s{}{}",
        .limit.as_secs_f64(),
        after(": ", whereabouts.as_deref().unwrap_or_default()),
        quote(said)
    )]
    TimeOut {
        limit: Duration,
        whereabouts: Option<String>,
        said: String,
    },
    #[error("the firmware ended before it said what was waited for{}", quote(said))]
    Silence { said: String },
    #[error(transparent)]
    Monitor(#[from] qmp::Error),
    #[error("the picture of the display is unreadable: {0}")]
    Screen(image::ImageError),
}

impl From<command::Failure> for Failure {
    fn from(failure: command::Failure) -> Self {
        match failure {
            command::Failure::Status { status, .. } => Self::Fault {
                status,
                said: String::new(),
            },
            failure => Self::Start { failure },
        }
    }
}

/// Returns the firmware's output as the end of an error message; empty if there was no output.
pub(super) fn quote(said: &str) -> String {
    after("; it said:\n", said)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn core_in_a_fault_is_told_from_one_that_runs() {
        let registers = |state| format!("R14=fffffff9 R15=000004d2\nXPSR={state:08x} -ZC- A\n");
        let place = |state| whereabouts(&registers(state)).unwrap();
        assert_eq!(place(0x6100_0003), "it is in HardFault at 0x000004d2");
        assert_eq!(place(0x6100_0000), "it is at 0x000004d2");
        assert_eq!(whereabouts(" pc       80000000\n"), None);
    }

    #[test]
    fn address_is_the_second_number_of_the_state() {
        let line = "Trace 0: 0x7f65b0004940 [00800400/00002f44/00000110/ff000201] _ZN8firmware";
        assert_eq!(executed(line), Some(0x2f44));
        assert_eq!(executed("fault: HardFault"), None);
    }

    #[test]
    fn version_is_read_from_the_first_line() {
        let printed = "QEMU emulator version 7.2.22 (Debian 1:7.2+dfsg)\nCopyright (c) 2003";
        assert_eq!(version(printed), Some((7, 2)));
        assert_eq!(version("QEMU emulator version 10.0.2"), Some((10, 0)));
        assert_eq!(version("nothing"), None);
    }

    #[cfg(unix)]
    #[test]
    fn version_is_asked_after_a_missing_emulator_was_got() {
        use std::{fs, process, sync::LazyLock};

        static LATE: LazyLock<String> = LazyLock::new(|| {
            let name = format!("reflet-late-qemu-{}", process::id());
            env::temp_dir().join(name).display().to_string()
        });
        static NEED: Need = Need {
            name: "late emulator",
            is_there: || Path::new(&*LATE).exists(),
            get: || {
                // Another process writes it: a file that is open here cannot be executed.
                let lines = r"#!/bin/sh\necho QEMU emulator version 7.2.22\n";
                let script = format!("printf '{lines}' > $0 && chmod +x $0");
                Ok(Program::new("sh").args(["-c", &script, &LATE]).stream()?)
            },
            by_hand: "wait",
            without: None,
        };
        let options = Qemu::new(&LATE, &NEED).one_by_one();
        let removed = fs::remove_file(&*LATE);
        assert_eq!(options.unwrap(), ["-singlestep"]);
        removed.unwrap();
    }

    #[test]
    fn missing_emulator_is_named_with_the_way_to_get_it() {
        static ABACUS: Need = Need {
            name: "abacus",
            is_there: || false,
            get: || anyhow::bail!("out of reach"),
            by_hand: "thread beads",
            without: None,
        };
        let missing = Qemu::new("qemu-system-abacus", &ABACUS).run(Path::new("firmware"));
        let words = "abacus: missing; by hand: thread beads: out of reach";
        assert_eq!(missing.unwrap_err().to_string(), words);
    }
}
