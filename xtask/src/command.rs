//! Runs other programs under a time limit, and streams or reads their output.
//!
//! The chores start every process through this module, so no process can block them for ever. This
//! module never knows what a program is for.

use std::ffi::OsStr;
use std::io::{BufRead, BufReader, Read};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Output, Stdio};
use std::sync::mpsc;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};
use std::{fmt, io, thread};

use rustix::process::{Pid, Signal, kill_process};

#[derive(Debug)]
pub struct Program {
    command: Command,
    limit: Duration,
}

impl Program {
    /// Creates a program without arguments. It may run for a minute and has an empty standard input.
    pub fn new(name: impl AsRef<OsStr>) -> Self {
        let mut command = Command::new(name);
        command.stdin(Stdio::null());
        Self {
            command,
            limit: Duration::from_secs(60),
        }
    }

    pub fn args<A: AsRef<OsStr>>(mut self, arguments: impl IntoIterator<Item = A>) -> Self {
        self.command.args(arguments);
        self
    }

    pub fn env(mut self, key: impl AsRef<OsStr>, value: impl AsRef<OsStr>) -> Self {
        self.command.env(key, value);
        self
    }

    /// Sets the folder in which the program runs. Default: the current folder.
    pub fn in_folder(mut self, folder: impl AsRef<Path>) -> Self {
        self.command.current_dir(folder);
        self
    }

    /// Sets the time limit. After it, the program and all processes it started are killed.
    pub fn limit(mut self, limit: Duration) -> Self {
        self.limit = limit;
        self
    }

    /// Runs the program. Its output goes to this process's standard output and standard error.
    pub fn stream(self) -> Result<(), Failure> {
        self.run().map(|_| ())
    }

    /// Runs the program. All of its output goes to this process's standard error.
    pub fn stream_to_stderr(mut self) -> Result<(), Failure> {
        self.command.stdout(io::stderr());
        self.stream()
    }

    /// Runs the program and returns its standard output, without white space at both ends.
    pub fn read(mut self) -> Result<String, Failure> {
        self.command.stdout(Stdio::piped()).stderr(Stdio::piped());
        Ok(text(&self.run()?.stdout))
    }

    /// Runs the program and returns what it said, whether it succeeded, and its processor time.
    pub fn watch(self) -> Watched {
        let (mut said, mut processor) = (String::new(), Duration::ZERO);
        let outcome = self.start_with_one_pipe().and_then(|mut running| {
            while let Some(line) = running.line()? {
                said += &line;
                said.push('\n');
            }
            let status = running.status()?;
            processor = running.processor;
            if status.success() {
                Ok(())
            } else {
                Err(Failure::Status {
                    command: running.command.clone(),
                    status,
                    complaints: String::new(),
                })
            }
        });
        Watched {
            said,
            outcome,
            processor,
        }
    }

    /// Tests whether the program exists, runs, and ends with success.
    pub fn succeeds(self) -> bool {
        self.read().is_ok()
    }

    /// Starts the program and returns while it runs. [`Running::line`] reads its output line by line.
    pub fn start(mut self) -> Result<Running, Failure> {
        self.command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = self.spawn()?;
        let (sender, lines) = mpsc::sync_channel(LINES);
        forward(child.stderr.take(), sender.clone());
        forward(child.stdout.take(), sender);
        Ok(self.running(child, lines))
    }

    /// Starts the program with standard output and standard error in one pipe, which keeps their
    /// order. If the program writes parts of lines to both, these parts may be mixed.
    fn start_with_one_pipe(mut self) -> Result<Running, Failure> {
        let pipe = io::pipe().and_then(|(reader, writer)| {
            self.command.stdout(writer.try_clone()?).stderr(writer);
            Ok(reader)
        });
        let reader = pipe.map_err(|error| self.not_started(error))?;
        let child = self.spawn()?;
        let (sender, lines) = mpsc::sync_channel(LINES);
        forward(Some(reader), sender);
        Ok(self.running(child, lines))
    }

    fn running(&self, child: Child, lines: Receiver<String>) -> Running {
        Running {
            command: self.to_string(),
            child,
            lines,
            limit: self.limit,
            deadline: Instant::now() + self.limit,
            processor: Duration::ZERO,
        }
    }

    fn run(mut self) -> Result<Output, Failure> {
        /// Time to wait for a killed process. It closes its pipes within milliseconds.
        const PATIENCE: Duration = Duration::from_secs(10);
        let child = self.spawn()?;
        let id = child.id();
        let (sender, output) = mpsc::channel();
        thread::spawn(move || sender.send(child.wait_with_output()));
        match output.recv_timeout(self.limit) {
            Ok(Ok(output)) if output.status.success() => Ok(output),
            Ok(Ok(Output { status, stderr, .. })) => Err(Failure::Status {
                command: self.to_string(),
                status,
                complaints: text(&stderr),
            }),
            Ok(Err(_)) | Err(_) => {
                end(id as i32);
                let _ = output.recv_timeout(PATIENCE);
                Err(Failure::TimeOut {
                    command: self.to_string(),
                    limit: self.limit,
                })
            }
        }
    }

    fn spawn(&mut self) -> Result<Child, Failure> {
        let child = self.command.spawn();
        child.map_err(|error| self.not_started(error))
    }

    fn not_started(&self, error: io::Error) -> Failure {
        let program = self.command.get_program().to_string_lossy().into_owned();
        match error.kind() {
            io::ErrorKind::NotFound => Failure::Missing { program },
            _ => Failure::Start { program, error },
        }
    }
}

/// What came of a program that was watched.
#[derive(Debug)]
pub struct Watched {
    /// Standard output and standard error, in the order in which the lines were printed.
    pub said: String,
    pub outcome: Result<(), Failure>,
    /// Processor time of the program and of all programs that it waited for.
    pub processor: Duration,
}

const LINES: usize = 1 << 12;

impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.command.get_program().to_string_lossy())?;
        self.command
            .get_args()
            .try_for_each(|argument| write!(f, " {}", argument.to_string_lossy()))
    }
}

/// Sends each line of a pipe to `lines`, until the pipe closes or the receiver is dropped.
fn forward(pipe: Option<impl Read + Send + 'static>, lines: SyncSender<String>) {
    let Some(pipe) = pipe else { return };
    thread::spawn(move || {
        BufReader::new(pipe)
            .split(b'\n')
            .map_while(Result::ok)
            .try_for_each(|line| lines.send(String::from_utf8_lossy(&line).trim_end().into()))
    });
}

/// A running program. Dropping it kills the program and all processes that it started.
#[derive(Debug)]
pub struct Running {
    command: String,
    child: Child,
    lines: Receiver<String>,
    limit: Duration,
    deadline: Instant,
    /// Processor time, once the program has ended.
    processor: Duration,
}

impl Running {
    /// Returns the next line of standard output or standard error, or `None` after both are closed.
    pub fn line(&mut self) -> Result<Option<String>, Failure> {
        let rest = self.deadline.saturating_duration_since(Instant::now());
        match self.lines.recv_timeout(rest) {
            Ok(line) => Ok(Some(line)),
            Err(RecvTimeoutError::Disconnected) => Ok(None),
            Err(RecvTimeoutError::Timeout) => Err(self.time_out()),
        }
    }

    /// Returns the exit status. Waits for it: the pipes are closed already, so the process ends
    /// soon.
    pub fn status(&mut self) -> Result<ExitStatus, Failure> {
        loop {
            match self.reap() {
                Ok(Some(status)) => return Ok(status),
                Ok(None) if Instant::now() < self.deadline => {
                    thread::sleep(Duration::from_millis(1));
                }
                _ => return Err(self.time_out()),
            }
        }
    }

    /// Takes the exit status if the program has ended, and notes its processor time.
    fn reap(&mut self) -> io::Result<Option<ExitStatus>> {
        // One at a time: the system only knows the sum over all children that have been waited for.
        static ONE_AT_A_TIME: Mutex<()> = Mutex::new(());
        let _lock = ONE_AT_A_TIME.lock().unwrap_or_else(PoisonError::into_inner);
        let before = time_of_children();
        let status = self.child.try_wait()?;
        if status.is_some() {
            self.processor = time_of_children().saturating_sub(before);
        }
        Ok(status)
    }

    fn time_out(&self) -> Failure {
        Failure::TimeOut {
            command: self.command.clone(),
            limit: self.limit,
        }
    }
}

impl Drop for Running {
    fn drop(&mut self) {
        // A process that has ended has no process number any more: another process may have the same
        // number.
        if let Ok(None) = self.child.try_wait() {
            end(self.child.id() as i32);
        }
        let _ = self.child.wait();
    }
}

#[derive(Debug, thiserror::Error)]
pub enum Failure {
    #[error("there is no program `{program}`")]
    Missing { program: String },
    #[error("`{program}` does not start: {error}")]
    Start { program: String, error: io::Error },
    #[error("`{command}` failed ({status}){}", after(": ", complaints))]
    Status {
        command: String,
        status: ExitStatus,
        complaints: String,
    },
    #[error("`{command}` was ended after {} s", .limit.as_secs_f64())]
    TimeOut { command: String, limit: Duration },
}

/// Returns `beginning` and `words` joined, or an empty string if `words` is empty.
pub(crate) fn after(beginning: &str, words: &str) -> String {
    match words {
        "" => String::new(),
        words => format!("{beginning}{words}"),
    }
}

/// Returns the processor time of all children that have been waited for, from fields 16 and 17 of
/// Linux's `/proc/self/stat`; zero elsewhere.
fn time_of_children() -> Duration {
    /// Milliseconds of the unit of these fields, which is the same on every Linux.
    const TICK: u64 = 10;
    let line = std::fs::read_to_string("/proc/self/stat").unwrap_or_default();
    // The second field is the program's name in parentheses, which may contain spaces.
    let fields = line.rsplit_once(") ").map_or("", |(_, fields)| fields);
    let ticks = fields.split(' ').skip(13).take(2);
    let ticks = ticks.filter_map(|field| field.parse::<u64>().ok());
    Duration::from_millis(TICK * ticks.sum::<u64>())
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).trim().to_owned()
}

/// Kills a process and all processes it started: a child left behind would keep our output open.
fn end(id: i32) {
    let children = Program::new("pgrep").args(["-P", &id.to_string()]).read();
    if let Some(process) = Pid::from_raw(id) {
        // The process may have ended already.
        let _ = kill_process(process, Signal::KILL);
    }
    let children = children.unwrap_or_default();
    children.lines().flat_map(str::parse).for_each(end);
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shell(script: &str) -> Program {
        Program::new("sh").args(["-c", script])
    }

    #[test]
    fn output_is_read_without_the_space_around_it() {
        assert_eq!(shell("echo '  a b '").read().unwrap(), "a b");
    }

    #[test]
    fn program_that_is_watched_is_ended_with_its_children() {
        let slow = shell("sleep 61.75 & wait").limit(Duration::from_millis(200));
        let failure = slow.watch().outcome.unwrap_err();
        assert!(failure.to_string().ends_with("was ended after 0.2 s"));
        // A killed process can be seen until the system has taken it down.
        let is_gone = |_| {
            thread::sleep(Duration::from_millis(20));
            let found = Program::new("pgrep").args(["-fx", "sleep 61.75"]);
            !found.succeeds()
        };
        assert!((0..100).any(is_gone));
    }

    #[test]
    fn all_that_is_said_is_heard_in_its_order() {
        let watched = shell("echo a; echo b >&2; echo c; exit 3").watch();
        assert_eq!(watched.said, "a\nb\nc\n");
        let words = "`sh -c echo a; echo b >&2; echo c; exit 3` failed (exit status: 3)";
        assert_eq!(watched.outcome.unwrap_err().to_string(), words);
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn processor_time_is_that_of_the_program_and_its_children() {
        let busy = "sh -c 'i=0; while [ $i -lt 200000 ]; do i=$((i+1)); done'";
        let watched = shell(busy).watch();
        watched.outcome.unwrap();
        assert!(watched.processor >= Duration::from_millis(20));
        assert!(shell("sleep 0.3").watch().processor < Duration::from_millis(200));
    }

    #[test]
    fn failure_names_the_command_and_repeats_its_words() {
        let failure = shell("echo it is full >&2; exit 3").read().unwrap_err();
        let words = "`sh -c echo it is full >&2; exit 3` failed (exit status: 3): it is full";
        assert_eq!(failure.to_string(), words);
    }

    #[test]
    fn missing_program_is_named() {
        let failure = Program::new("no-such-program").read().unwrap_err();
        assert_eq!(failure.to_string(), "there is no program `no-such-program`");
    }

    #[test]
    fn program_past_its_limit_is_ended_with_its_children() {
        let start = Instant::now();
        // Reading waits until every process that holds the pipe has ended, here a grandchild.
        let slow = shell("(sh -c 'sleep 60; :'; :) & sleep 60").limit(Duration::from_millis(200));
        let failure = slow.read().unwrap_err();
        assert!(failure.to_string().ends_with("was ended after 0.2 s"));
        // Less than `PATIENCE`, the time `run` waits for a process that cannot be killed.
        assert!(start.elapsed() < Duration::from_secs(10));
    }

    #[test]
    fn program_is_given_no_input() {
        assert_eq!(shell("cat").read().unwrap(), "");
    }
}
