//! Other programs: started under a time limit, their output streamed or read.
//!
//! Every process the chores start goes through here, so none can hang them. This module never
//! knows what a program is for.

use std::{
    ffi::OsStr,
    fmt,
    io::{self, Read},
    process::{Child, Command, ExitStatus, Stdio},
    thread,
    time::{Duration, Instant},
};

/// A program about to run: what is called, in which environment, and for how long at most.
#[derive(Debug)]
pub struct Program {
    command: Command,
    limit: Duration,
}

impl Program {
    /// A program without arguments that may run for a minute. It is never given any input.
    pub fn new(name: impl AsRef<OsStr>) -> Self {
        let mut command = Command::new(name);
        command.stdin(Stdio::null());
        Self {
            command,
            limit: Duration::from_secs(60),
        }
    }

    /// Appends arguments.
    pub fn args<A: AsRef<OsStr>>(mut self, arguments: impl IntoIterator<Item = A>) -> Self {
        self.command.args(arguments);
        self
    }

    /// Sets one variable of the program's environment.
    pub fn env(mut self, key: impl AsRef<OsStr>, value: impl AsRef<OsStr>) -> Self {
        self.command.env(key, value);
        self
    }

    /// The time after which the program and all it started are ended.
    pub fn limit(mut self, limit: Duration) -> Self {
        self.limit = limit;
        self
    }

    /// Runs the program; its output goes where ours goes.
    pub fn stream(mut self) -> Result<(), Failure> {
        let mut child = self.spawn()?;
        let status = self.wait(&mut child)?;
        self.judge(status, String::new())
    }

    /// Runs the program and returns what it printed, without the white space around it.
    pub fn read(mut self) -> Result<String, Failure> {
        self.command.stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut child = self.spawn()?;
        let output = collect(child.stdout.take());
        let complaints = collect(child.stderr.take());
        let status = self.wait(&mut child)?;
        self.judge(status, text(complaints))?;
        Ok(text(output))
    }

    /// Runs the program and returns all that it printed, errors in their place, and how it ended.
    pub fn watch(mut self) -> (String, Result<(), Failure>) {
        let pipe = io::pipe().and_then(|(reader, writer)| {
            self.command.stdout(writer.try_clone()?).stderr(writer);
            Ok(reader)
        });
        let child = self.spawn();
        // The command's own ends of the pipe would keep it open.
        self.command.stdout(Stdio::null()).stderr(Stdio::null());
        match child {
            Ok(mut child) => {
                let said = collect(pipe.ok());
                let outcome = self.wait(&mut child);
                let outcome = outcome.and_then(|status| self.judge(status, String::new()));
                (text(said), outcome)
            }
            Err(failure) => (String::new(), Err(failure)),
        }
    }

    /// Whether the program exists, runs and is content.
    pub fn succeeds(self) -> bool {
        self.read().is_ok()
    }

    fn spawn(&mut self) -> Result<Child, Failure> {
        self.command.spawn().map_err(|error| Failure::Start {
            program: self.command.get_program().to_string_lossy().into_owned(),
            error,
        })
    }

    fn wait(&self, child: &mut Child) -> Result<ExitStatus, Failure> {
        let start = Instant::now();
        loop {
            match child.try_wait() {
                Ok(Some(status)) => return Ok(status),
                Ok(None) if start.elapsed() < self.limit => {
                    thread::sleep(Duration::from_millis(10));
                }
                _ => {
                    end(child);
                    return Err(Failure::TimeOut {
                        command: self.to_string(),
                        limit: self.limit,
                    });
                }
            }
        }
    }

    fn judge(&self, status: ExitStatus, complaints: String) -> Result<(), Failure> {
        if status.success() {
            return Ok(());
        }
        Err(Failure::Status {
            command: self.to_string(),
            status,
            complaints,
        })
    }
}

/// The command line, as a person would type it.
impl fmt::Display for Program {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.command.get_program().to_string_lossy())?;
        self.command
            .get_args()
            .try_for_each(|argument| write!(f, " {}", argument.to_string_lossy()))
    }
}

/// What can go wrong with another program.
#[derive(Debug)]
pub enum Failure {
    /// It could not be started, mostly because it is not there.
    Start { program: String, error: io::Error },
    /// It ended, and not well.
    Status {
        command: String,
        status: ExitStatus,
        complaints: String,
    },
    /// It did not end in time and was ended.
    TimeOut { command: String, limit: Duration },
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Start { program, error } if error.kind() == io::ErrorKind::NotFound => {
                write!(f, "there is no program `{program}`")
            }
            Self::Start { program, error } => write!(f, "`{program}` does not start: {error}"),
            Self::Status {
                command,
                status,
                complaints,
            } => {
                write!(f, "`{command}` failed ({status})")?;
                match complaints.as_str() {
                    "" => Ok(()),
                    complaints => write!(f, ": {complaints}"),
                }
            }
            Self::TimeOut { command, limit } => {
                write!(f, "`{command}` was ended after {} s", limit.as_secs_f64())
            }
        }
    }
}

impl std::error::Error for Failure {}

/// Reads a pipe to its end beside the program that fills it.
fn collect(pipe: Option<impl Read + Send + 'static>) -> thread::JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        if let Some(mut pipe) = pipe {
            // A pipe that breaks has said what it could; the exit status tells the rest.
            let _ = pipe.read_to_end(&mut bytes);
        }
        bytes
    })
}

fn text(collected: thread::JoinHandle<Vec<u8>>) -> String {
    let bytes = collected.join().unwrap_or_default();
    String::from_utf8_lossy(&bytes).trim().to_owned()
}

/// Ends a process and all it started: an orphan would go on and hold our output open.
fn end(child: &mut Child) {
    let mut processes = vec![child.id()];
    if let Ok(table) = Program::new("ps").args(["-A", "-o", "pid=,ppid="]).read() {
        processes.extend(descendants(&table, child.id()));
    }
    let ids = processes.iter().map(u32::to_string);
    Program::new("kill").args(["-KILL"]).args(ids).succeeds();
    // Already gone where `kill` did its work; the way to end it where there is no `kill`.
    let _ = child.kill();
    let _ = child.wait();
}

/// The processes below `root` in a table of `id parent` lines.
fn descendants(table: &str, root: u32) -> Vec<u32> {
    let pairs: Vec<(u32, u32)> = table
        .lines()
        .filter_map(|line| {
            let mut words = line.split_whitespace().map(str::parse);
            Some((words.next()?.ok()?, words.next()?.ok()?))
        })
        .collect();
    let mut found = vec![root];
    let mut next = 0;
    while next < found.len() {
        let parent = found[next];
        found.extend(
            pairs
                .iter()
                .filter(|pair| pair.1 == parent)
                .map(|pair| pair.0),
        );
        next += 1;
    }
    found.split_off(1)
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
    fn all_that_is_said_is_heard_in_its_order() {
        let (said, outcome) = shell("echo a; echo b >&2; echo c; exit 3").watch();
        assert_eq!(said, "a\nb\nc");
        let words = "`sh -c echo a; echo b >&2; echo c; exit 3` failed (exit status: 3)";
        assert_eq!(outcome.unwrap_err().to_string(), words);
    }

    #[test]
    fn failure_names_the_command_and_repeats_its_words() {
        let failure = shell("echo it is full >&2; exit 3").read().unwrap_err();
        assert_eq!(
            failure.to_string(),
            "`sh -c echo it is full >&2; exit 3` failed (exit status: 3): it is full"
        );
    }

    #[test]
    fn missing_program_is_named() {
        let failure = Program::new("no-such-program").read().unwrap_err();
        assert_eq!(failure.to_string(), "there is no program `no-such-program`");
    }

    #[test]
    fn program_past_its_limit_is_ended_with_its_children() {
        let start = Instant::now();
        // Reading waits until the last holder of the pipe is gone: the grandchild, too.
        let slow = shell("(sleep 60; :) & sleep 60").limit(Duration::from_millis(200));
        let failure = slow.read().unwrap_err();
        assert!(failure.to_string().ends_with("was ended after 0.2 s"));
        assert!(start.elapsed() < Duration::from_secs(30));
    }

    #[test]
    fn descendants_are_found_across_generations() {
        let table = "  1 0\n 10 1\n 11 10\n 12 11\n 20 1\n";
        assert_eq!(descendants(table, 10), [11, 12]);
    }

    #[test]
    fn program_is_given_no_input() {
        assert_eq!(shell("cat").read().unwrap(), "");
    }
}
