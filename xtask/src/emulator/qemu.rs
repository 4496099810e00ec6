//! QEMU: boots a firmware on an emulated board, hears what it says by semihosting, presses its
//! keys and looks at its display.
//!
//! Every run has a time limit, and nothing outlives it. A firmware that ends badly, or hangs in a
//! fault, is a [`Failure`] that repeats its words and names the fault. It knows no firmware.

use std::{
    env,
    ffi::{OsStr, OsString},
    fmt,
    io::{self, BufRead, BufReader, Read},
    ops::ControlFlow,
    os::unix::net::UnixStream,
    path::Path,
    process::{Child, Command, ExitStatus, Stdio},
    sync::mpsc::{self, Receiver, RecvTimeoutError, SyncSender},
    thread,
    time::{Duration, Instant},
};

use image::RgbImage;
use serde_json::{Value, json};
use tempfile::TempDir;

use super::qmp::{self, Monitor};
use crate::command::Program;

/// An emulated board about to boot a firmware, and for how long it may run.
#[derive(Clone, Debug)]
pub struct Qemu {
    program: &'static str,
    arguments: Vec<OsString>,
    limit: Duration,
}

impl Qemu {
    /// An Arm board by the name QEMU has for it.
    pub fn arm(machine: &str) -> Self {
        Self::new("qemu-system-arm").args(["-M", machine])
    }

    /// QEMU's 32-bit RISC-V board, with no firmware but ours.
    pub fn riscv32() -> Self {
        Self::new("qemu-system-riscv32").args(["-M", "virt", "-bios", "none"])
    }

    fn new(program: &'static str) -> Self {
        let emulator = Self {
            program,
            arguments: Vec::new(),
            limit: Duration::from_secs(60),
        };
        emulator
            .args(["-semihosting-config", "enable=on,target=native"])
            .args(["-serial", "null", "-monitor", "none"])
    }

    /// Appends options of QEMU's.
    pub fn args<A: AsRef<OsStr>>(mut self, arguments: impl IntoIterator<Item = A>) -> Self {
        let arguments = arguments.into_iter().map(|it| it.as_ref().to_owned());
        self.arguments.extend(arguments);
        self
    }

    /// Lets every instruction take 2^`shift` ns of the board's time, so that its timers count
    /// instructions.
    pub fn counting_instructions(self, shift: u8) -> Self {
        self.args(["-icount", &format!("shift={shift}")])
    }

    /// The time after which the firmware is ended; a minute unless it is named.
    pub fn limit(self, limit: Duration) -> Self {
        Self { limit, ..self }
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
        let stepping = one_by_one(self.program);
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
        let start = |error| Failure::Start {
            program: self.program,
            error,
        };
        let folder = TempDir::with_prefix("reflet-").map_err(start)?;
        let mut monitor = OsString::from("unix:");
        monitor.push(folder.path().join(MONITOR));
        monitor.push(",server=on,wait=off");
        let mut child = self
            .command(firmware)
            .args(["-display", "none", "-qmp"])
            .arg(monitor)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .map_err(start)?;
        let (sender, lines) = mpsc::sync_channel(LINES);
        forward(child.stderr.take(), sender.clone());
        forward(child.stdout.take(), sender);
        Ok(Running {
            child,
            lines,
            said: Vec::new(),
            limit: self.limit,
            deadline: Instant::now() + self.limit,
            folder,
            monitor: None,
        })
    }

    /// Shows a firmware to a person until they or it end it: without a limit, its words where ours
    /// go, and its display in a window if this machine has a screen.
    pub fn show(self, firmware: &Path) -> Result<(), Failure> {
        let mut command = self.command(firmware);
        if !has_screen() {
            command.args(["-display", "none"]);
        }
        let status = command.status().map_err(|error| Failure::Start {
            program: self.program,
            error,
        })?;
        judge(status, &[])
    }

    fn command(&self, firmware: &Path) -> Command {
        let mut command = Command::new(self.program);
        command.args(&self.arguments).arg("-kernel").arg(firmware);
        command
    }
}

/// How many lines may wait to be read.
const LINES: usize = 1 << 12;

/// The monitor's socket in the folder of a run.
const MONITOR: &str = "monitor";

/// Whether a window can be opened: elsewhere than on X and Wayland there is always a screen.
fn has_screen() -> bool {
    let is_named = |variable| env::var_os(variable).is_some_and(|value| !value.is_empty());
    cfg!(target_os = "macos") || ["DISPLAY", "WAYLAND_DISPLAY"].into_iter().any(is_named)
}

/// Sends on the lines of a pipe until it closes or nobody listens any more.
fn forward(pipe: Option<impl Read + Send + 'static>, lines: SyncSender<String>) {
    let Some(pipe) = pipe else { return };
    thread::spawn(move || {
        BufReader::new(pipe)
            .split(b'\n')
            .map_while(Result::ok)
            .map(|line| String::from_utf8_lossy(&line).trim_end().to_owned())
            .try_for_each(|line| lines.send(line))
    });
}

/// A key of the machine QEMU runs on; a board makes of it what it will.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    Left,
    Right,
    Up,
    Down,
    Control,
}

impl Key {
    /// QEMU's name for it.
    const fn code(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
            Self::Up => "up",
            Self::Down => "down",
            Self::Control => "ctrl",
        }
    }
}

/// A firmware that runs; dropping it ends it.
#[derive(Debug)]
pub struct Running {
    child: Child,
    lines: Receiver<String>,
    said: Vec<String>,
    limit: Duration,
    deadline: Instant,
    folder: TempDir,
    monitor: Option<Monitor<UnixStream>>,
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
        let status = self.status()?;
        judge(status, &self.said)?;
        Err(Failure::Silence {
            said: self.said.join("\n"),
        })
    }

    /// Waits until the firmware ends by itself, and returns all it has said.
    pub fn end(mut self) -> Result<String, Failure> {
        while self.next_line()?.is_some() {}
        let status = self.status()?;
        judge(status, &self.said)?;
        Ok(self.said.join("\n"))
    }

    /// Presses a key and lets it go.
    pub fn press(&mut self, key: Key) -> Result<(), Failure> {
        let key = json!({ "type": "qcode", "data": key.code() });
        for down in [true, false] {
            let event = json!({ "type": "key", "data": { "down": down, "key": key } });
            self.ask("input-send-event", json!({ "events": [event] }))?;
        }
        Ok(())
    }

    /// What the board's display shows.
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
        let rest = self.deadline.saturating_duration_since(Instant::now());
        match self.lines.recv_timeout(rest) {
            Ok(line) => Ok(Some(line)),
            Err(RecvTimeoutError::Disconnected) => Ok(None),
            Err(RecvTimeoutError::Timeout) => Err(self.time_out()),
        }
    }

    /// How the firmware ended: it has closed its pipes, so it will be a moment at most.
    fn status(&mut self) -> Result<ExitStatus, Failure> {
        loop {
            match self.child.try_wait() {
                Ok(Some(status)) => return Ok(status),
                Ok(None) if Instant::now() < self.deadline => {
                    thread::sleep(Duration::from_millis(1));
                }
                _ => return Err(self.time_out()),
            }
        }
    }

    fn time_out(&mut self) -> Failure {
        // A monitor that does not answer either leaves the rest of the message to say it.
        let registers = self.ask(
            "human-monitor-command",
            json!({ "command-line": "info registers" }),
        );
        let registers = registers.unwrap_or_default();
        Failure::TimeOut {
            limit: self.limit,
            whereabouts: registers.as_str().and_then(whereabouts),
            said: tail(&self.said),
        }
    }

    fn ask(&mut self, command: &str, arguments: Value) -> Result<Value, Failure> {
        let monitor = match &mut self.monitor {
            Some(monitor) => monitor,
            none => none.insert(connect(&self.folder.path().join(MONITOR))?),
        };
        monitor
            .execute(command, arguments)
            .map_err(Failure::Monitor)
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // It may have ended already, which is just as well.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

fn connect(socket: &Path) -> Result<Monitor<UnixStream>, Failure> {
    /// The monitor answers in milliseconds, on a busy machine in some more.
    const PATIENCE: Duration = Duration::from_secs(10);
    let stream = UnixStream::connect(socket).and_then(|stream| {
        stream.set_read_timeout(Some(PATIENCE))?;
        Ok(stream)
    });
    let stream = stream.map_err(|error| Failure::Monitor(error.into()))?;
    Monitor::new(stream).map_err(Failure::Monitor)
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

fn judge(status: ExitStatus, said: &[String]) -> Result<(), Failure> {
    if status.success() {
        return Ok(());
    }
    Err(Failure::Fault {
        status,
        said: tail(said),
    })
}

/// The last words, with room for a panic's message or QEMU's list of registers.
fn tail(said: &[String]) -> String {
    said[said.len().saturating_sub(20)..].join("\n")
}

/// What can go wrong on an emulated board.
#[derive(Debug)]
pub enum Failure {
    /// QEMU could not be started, mostly because it is not there.
    Start {
        program: &'static str,
        error: io::Error,
    },
    /// The firmware ended, and not well: by a panic, a fault, or its own exit status.
    Fault { status: ExitStatus, said: String },
    /// The firmware did not end, or did not say what was waited for, in time.
    TimeOut {
        limit: Duration,
        whereabouts: Option<String>,
        said: String,
    },
    /// The firmware ended well without saying what was waited for.
    Silence { said: String },
    /// QEMU's monitor failed.
    Monitor(qmp::Error),
    /// The picture of the display cannot be read.
    Screen(image::ImageError),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start { program, error } if error.kind() == io::ErrorKind::NotFound => {
                write!(
                    f,
                    "there is no program `{program}`: `cargo xtask setup` gets it"
                )
            }
            Self::Start { program, error } => write!(f, "`{program}` does not start: {error}"),
            Self::Fault { status, said } => {
                write!(f, "the firmware failed ({status})")?;
                quote(f, said)
            }
            Self::TimeOut {
                limit,
                whereabouts,
                said,
            } => {
                write!(f, "the firmware was ended after {} s", limit.as_secs_f64())?;
                if let Some(whereabouts) = whereabouts {
                    write!(f, ": {whereabouts}")?;
                }
                quote(f, said)
            }
            Self::Silence { said } => {
                write!(f, "the firmware ended before it said what was waited for")?;
                quote(f, said)
            }
            Self::Monitor(error) => error.fmt(f),
            Self::Screen(error) => write!(f, "the picture of the display is unreadable: {error}"),
        }
    }
}

/// Repeats the firmware's words, if it had any.
fn quote(f: &mut fmt::Formatter<'_>, said: &str) -> fmt::Result {
    match said {
        "" => Ok(()),
        said => write!(f, "; it said:\n{said}"),
    }
}

impl std::error::Error for Failure {}

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
