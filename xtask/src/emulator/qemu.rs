//! QEMU: boots a firmware on an emulated board, hears what it says by semihosting, presses its
//! keys and looks at its display.
//!
//! Every run has a time limit, and nothing outlives it. A firmware that ends badly, or hangs in a
//! fault, is a [`Failure`] that repeats its words and names the fault. It knows no firmware.

use std::{env, ffi::OsStr, ops::ControlFlow, path::Path, process::ExitStatus, time::Duration};

use image::RgbImage;
use serde::Serialize;
use serde_json::{Value, json};
use tempfile::TempDir;

use super::qmp::{self, Monitor};
use crate::command::{self, Program, after};

/// An emulated board about to boot a firmware, and for how long it may run.
#[derive(Debug)]
pub struct Qemu {
    name: &'static str,
    program: Program,
}

impl Qemu {
    pub fn arm(machine: &str) -> Self {
        Self::new("qemu-system-arm").args(["-M", machine])
    }

    /// QEMU's 32-bit RISC-V board, with no firmware but ours.
    pub fn riscv32() -> Self {
        Self::new("qemu-system-riscv32").args(["-M", "virt", "-bios", "none"])
    }

    fn new(name: &'static str) -> Self {
        let program = Program::new(name);
        Self { name, program }
            .args(["-semihosting-config", "enable=on,target=native"])
            .args(["-serial", "null", "-monitor", "none"])
    }

    pub fn args<A: AsRef<OsStr>>(self, arguments: impl IntoIterator<Item = A>) -> Self {
        let program = self.program.args(arguments);
        Self { program, ..self }
    }

    /// Lets every instruction take 2^`shift` ns of the board's time, so that its timers count
    /// instructions.
    pub fn counting_instructions(self, shift: u8) -> Self {
        self.args(["-icount", &format!("shift={shift}")])
    }

    /// The time after which the firmware is ended; a minute unless it is named.
    pub fn limit(self, limit: Duration) -> Self {
        let program = self.program.limit(limit);
        Self { program, ..self }
    }

    /// Runs a firmware until it ends by itself and returns what it said.
    pub fn run(self, firmware: &Path) -> Result<String, Failure> {
        self.boot(firmware)?.end()
    }

    /// Runs a firmware one instruction at a time and shows `see` the address of each, until the
    /// firmware ends by itself or `see` has seen enough.
    pub fn trace(
        self,
        firmware: &Path,
        mut see: impl FnMut(u32) -> ControlFlow<()>,
    ) -> Result<(), Failure> {
        let stepping = one_by_one(self.name);
        let logged = self.args(["-d", "exec,nochain"]).args(stepping);
        let mut running = logged.boot(firmware)?;
        while let Some(line) = running.receive()? {
            match executed(&line).map(&mut see) {
                Some(ControlFlow::Break(())) => return Ok(()),
                Some(ControlFlow::Continue(())) => {}
                None => running.said.push(line),
            }
        }
        running.end().map(|_| ())
    }

    /// Boots a firmware and returns while it runs, its display unseen.
    pub fn boot(self, firmware: &Path) -> Result<Running, Failure> {
        let folder = TempDir::with_prefix("reflet-").map_err(|error| command::Failure::Start {
            program: self.name.to_owned(),
            error,
        })?;
        let socket = folder.path().join(MONITOR);
        let monitor = format!("unix:{},server=on,wait=off", socket.display());
        let program = self.kernel(firmware).args(["-display", "none"]);
        Ok(Running {
            program: program.args(["-qmp", &monitor]).start()?,
            said: Vec::new(),
            folder,
            monitor: None,
        })
    }

    /// Shows a firmware to a person until they or it end it: without a limit, its words where ours
    /// go, and its display in a window if this machine has a screen.
    pub fn show(self, firmware: &Path) -> Result<(), Failure> {
        let unseen = ["-display", "none"].into_iter().filter(|_| !has_screen());
        let program = self.kernel(firmware).args(unseen).limit(Duration::MAX);
        Ok(program.stream()?)
    }

    fn kernel(self, firmware: &Path) -> Program {
        self.program.args(["-kernel".as_ref(), firmware])
    }
}

const MONITOR: &str = "monitor";

/// Whether a window can be opened: elsewhere than on X and Wayland there is always a screen.
fn has_screen() -> bool {
    let is_named = |variable| env::var_os(variable).is_some_and(|value| !value.is_empty());
    cfg!(target_os = "macos") || ["DISPLAY", "WAYLAND_DISPLAY"].into_iter().any(is_named)
}

/// A key of the machine QEMU runs on; a board makes of it what it will.
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

/// A firmware that runs; dropping it ends it.
#[derive(Debug)]
pub struct Running {
    program: command::Running,
    said: Vec<String>,
    folder: TempDir,
    monitor: Option<Monitor>,
}

impl Running {
    /// Waits until the firmware says a line that is `wanted`, and returns it.
    ///
    /// That it ends before it does is a failure.
    pub fn line(&mut self, wanted: impl Fn(&str) -> bool) -> Result<String, Failure> {
        while let Some(line) = self.next_line()? {
            if wanted(&line) {
                return Ok(line);
            }
        }
        let said = self.judged()?;
        Err(Failure::Silence { said })
    }

    /// Waits until the firmware ends by itself, and returns all it has said.
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

    /// `None` once the firmware has ended.
    fn next_line(&mut self) -> Result<Option<String>, Failure> {
        let line = self.receive()?;
        self.said.extend(line.clone());
        Ok(line)
    }

    /// The next line, which is not taken for the firmware's words.
    fn receive(&mut self) -> Result<Option<String>, Failure> {
        let line = self.program.line();
        line.map_err(|failure| self.named(failure))
    }

    /// All that the firmware has said, if it has ended well.
    fn judged(&mut self) -> Result<String, Failure> {
        let status = self.program.status();
        let status = status.map_err(|failure| self.named(failure))?;
        match status.success() {
            true => Ok(self.said.join("\n")),
            false => Err(Failure::Fault {
                status,
                said: tail(&self.said),
            }),
        }
    }

    /// The failure of the program as one of the firmware: it did not end in time.
    fn named(&mut self, failure: command::Failure) -> Failure {
        let command::Failure::TimeOut { limit, .. } = failure else {
            return failure.into();
        };
        // A monitor that does not answer either leaves the rest of the message to say it.
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

/// The options by which QEMU executes one instruction at a time: they changed in version 8.1.
fn one_by_one(program: &str) -> &'static [&'static str] {
    let printed = Program::new(program).args(["--version"]).read();
    match printed.ok().as_deref().and_then(version) {
        Some(version) if version < (8, 1) => &["-singlestep"],
        _ => &["-accel", "tcg,one-insn-per-tb=on"],
    }
}

/// Reads `QEMU emulator version 7.2.22 (Debian ...)`.
fn version(printed: &str) -> Option<(u32, u32)> {
    let (_, numbers) = printed.split_once(" version ")?;
    let mut numbers = numbers.split(|letter: char| !letter.is_ascii_digit());
    Some((numbers.next()?.parse().ok()?, numbers.next()?.parse().ok()?))
}

/// The address in a line of QEMU's log of what it executes:
/// `Trace 0: 0x7f65b0004940 [00800400/00002f44/00000110/ff000201] function`.
fn executed(line: &str) -> Option<u32> {
    let (_, state) = line.strip_prefix("Trace ")?.split_once('[')?;
    u32::from_str_radix(state.split('/').nth(1)?, 16).ok()
}

/// Where a Cortex-M is, from QEMU's list of its registers: the exception it handles, and the
/// program counter.
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

/// ARMv7-M Architecture Reference Manual, B1.5.2.
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

/// The last words, with room for a panic's message or QEMU's list of registers.
fn tail(said: &[String]) -> String {
    said[said.len().saturating_sub(20)..].join("\n")
}

#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error("{failure}{}", advice(failure))]
    Start { failure: command::Failure },
    /// The firmware ended, and not well: by a panic, a fault, or its own exit status.
    #[error("the firmware failed ({status}){}", quote(said))]
    Fault { status: ExitStatus, said: String },
    /// The firmware did not end, or did not say what was waited for, in time.
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

fn advice(failure: &command::Failure) -> &'static str {
    match failure {
        command::Failure::Missing { .. } => ": `cargo xtask setup` gets it",
        _ => "",
    }
}

/// Repeats the firmware's words, if it had any.
pub(super) fn quote(said: &str) -> String {
    after("; it said:\n", said)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn core_in_a_fault_is_told_from_one_that_runs() {
        let registers = |state| format!("R14=fffffff9 R15=000004d2\nXPSR={state:08x} -ZC- A\n");
        assert_eq!(
            whereabouts(&registers(0x6100_0003)).unwrap(),
            "it is in HardFault at 0x000004d2"
        );
        assert_eq!(
            whereabouts(&registers(0x6100_0000)).unwrap(),
            "it is at 0x000004d2"
        );
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

    #[test]
    fn missing_emulator_is_named_with_the_way_to_get_it() {
        let missing = Qemu::new("qemu-system-abacus").run(Path::new("firmware"));
        assert_eq!(
            missing.unwrap_err().to_string(),
            "there is no program `qemu-system-abacus`: `cargo xtask setup` gets it"
        );
    }
}
