//! The examples' binaries, built once, and folders to run them in.

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;

use serde_json::Value;

/// What a call leaves behind.
pub struct Outcome {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

/// A folder of its own for one test, empty at its start.
pub struct Folder(PathBuf);

impl Folder {
    pub fn new(test: &str) -> Self {
        let path = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .join("command_line")
            .join(test);
        if path.exists() {
            fs::remove_dir_all(&path).expect("what an earlier run left can be removed");
        }
        fs::create_dir_all(&path).expect("a folder can be made");
        Self(path)
    }

    pub fn path(&self, name: &str) -> PathBuf {
        self.0.join(name)
    }

    /// The names of what is in it, sorted.
    pub fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the folder can be read");
        let name = |entry: fs::DirEntry| entry.file_name().into_string().expect("plain names");
        let mut names: Vec<_> = entries
            .map(|entry| name(entry.expect("an entry")))
            .collect();
        names.sort();
        names
    }

    /// Runs the program with arguments that are separated by spaces.
    pub fn render(&self, arguments: &str) -> Outcome {
        self.run(&arguments.split_whitespace().collect::<Vec<_>>())
    }

    pub fn run(&self, arguments: &[&str]) -> Outcome {
        finish(self.command("render", arguments).stdout(Stdio::piped()))
    }

    /// Runs the program with a standard output that nobody reads.
    pub fn render_unread(&self, arguments: &str) -> Outcome {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        finish(
            self.command("render", &arguments.split_whitespace().collect::<Vec<_>>())
                .stdout(writer),
        )
    }

    /// Runs the program and returns its exit code, the bytes it prints and its words.
    pub fn render_bytes(&self, arguments: &str) -> (i32, Vec<u8>, String) {
        let arguments: Vec<_> = arguments.split_whitespace().collect();
        let output = self.command("render", &arguments).output();
        let output = output.expect("the example runs");
        let words = String::from_utf8(output.stderr).expect("the example says UTF-8");
        let code = output.status.code().expect("the example ends by itself");
        (code, output.stdout, words)
    }

    /// Runs the program with less memory than the machine may have.
    #[cfg(target_os = "linux")]
    pub fn render_in_4_gigabytes(&self, arguments: &str) -> Outcome {
        let mut shell = Command::new("sh");
        shell
            .args(["-c", "ulimit -v 4000000 && exec \"$0\" \"$@\""])
            .arg(binary("render"));
        shell
            .args(arguments.split_whitespace())
            .current_dir(&self.0);
        finish(shell.stdout(Stdio::piped()).stderr(Stdio::piped()))
    }

    /// Runs the program with environment variables.
    #[cfg(feature = "window")]
    pub fn render_with(&self, arguments: &str, variables: &[(&str, &str)]) -> Outcome {
        let mut command = self.command("render", &arguments.split_whitespace().collect::<Vec<_>>());
        finish(
            command
                .envs(variables.iter().copied())
                .stdout(Stdio::piped()),
        )
    }

    fn command(&self, example: &'static str, arguments: &[&str]) -> Command {
        let mut command = Command::new(binary(example));
        command
            .args(arguments)
            .current_dir(&self.0)
            .stdin(Stdio::null())
            .stderr(Stdio::piped());
        command
    }
}

fn finish(command: &mut Command) -> Outcome {
    let output = command.spawn().and_then(|child| child.wait_with_output());
    let output = output.expect("the example runs");
    let text = |bytes| String::from_utf8(bytes).expect("the example prints UTF-8");
    Outcome {
        code: output.status.code().expect("the example ends by itself"),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    }
}

/// Set by whoever has just built all examples in the profile of the tests.
const ARE_BUILT: &str = "EXAMPLES_ARE_BUILT";

/// An example as the sources say it is now.
///
/// Cargo tells a test nothing about examples, so it is asked: with the profile, the features and
/// the folder of this test there is nothing to be built after a whole `cargo test`.
fn binary(example: &'static str) -> PathBuf {
    static BINARIES: Mutex<BTreeMap<&str, PathBuf>> = Mutex::new(BTreeMap::new());
    let mut binaries = BINARIES.lock().expect("no build has failed");
    let built = binaries.entry(example).or_insert_with(|| {
        let target = Path::new(env!("CARGO_TARGET_TMPDIR"))
            .parent()
            .expect("target/tmp");
        if env::var_os(ARE_BUILT).is_some() {
            return target.join("debug/examples").join(example);
        }
        let profile = if cfg!(debug_assertions) {
            "test"
        } else {
            "release"
        };
        let features = if cfg!(feature = "window") {
            "window"
        } else {
            ""
        };
        let output = Command::new(env!("CARGO"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .args(["build", "--example", example, "--message-format", "json"])
            .args(["--profile", profile, "--features", features])
            .arg("--target-dir")
            .arg(target)
            .output()
            .expect("cargo runs");
        let messages = String::from_utf8_lossy(&output.stdout);
        let complaints = String::from_utf8_lossy(&output.stderr);
        let mut lines = messages.lines().rev();
        let executable = lines.find_map(|message| executable(example, message));
        executable.unwrap_or_else(|| panic!("the example is built: {complaints}"))
    });
    built.clone()
}

/// The path in one of Cargo's messages, if it is the one about the example.
fn executable(example: &str, message: &str) -> Option<PathBuf> {
    let message: Value = serde_json::from_str(message).ok()?;
    let is_example = message["target"]["name"] == example;
    is_example
        .then(|| message["executable"].as_str().map(PathBuf::from))
        .flatten()
}
