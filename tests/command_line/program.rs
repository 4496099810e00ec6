//! Builds the examples' programs once, and runs them in folders of their own.

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;

use image::RgbImage;

/// Result of a call: its exit code and its output.
pub struct Outcome {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

/// A folder for one test, empty at its start.
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

    pub fn write(&self, name: &str, content: impl AsRef<[u8]>) {
        fs::write(self.path(name), content).expect("a file can be written");
    }

    pub fn read(&self, name: &str) -> Vec<u8> {
        fs::read(self.path(name)).expect("the file is there")
    }

    pub fn png(&self, name: &str) -> RgbImage {
        let image = image::open(self.path(name)).expect("the file is a picture");
        image.to_rgb8()
    }

    /// Returns the sorted names of the folder's files.
    pub fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).expect("the folder can be read");
        let names = entries.map(|entry| entry.expect("an entry").file_name());
        let names = names.map(|name| name.into_string().expect("plain names"));
        let mut names: Vec<_> = names.collect();
        names.sort();
        names
    }

    /// Runs the program with arguments that are separated by spaces.
    pub fn render(&self, arguments: &str) -> Outcome {
        self.run(&words(arguments))
    }

    pub fn run(&self, arguments: &[&str]) -> Outcome {
        finish(&mut self.command("render", arguments))
    }

    /// Runs another example without arguments.
    pub fn example(&self, name: &'static str) -> Outcome {
        finish(&mut self.command(name, &[]))
    }

    /// Runs the program with a standard output that has no reader.
    pub fn render_unread(&self, arguments: &str) -> Outcome {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        finish(self.command("render", &words(arguments)).stdout(writer))
    }

    /// Runs the program. Returns its exit code, the bytes on standard output, and the text on
    /// standard error.
    pub fn render_bytes(&self, arguments: &str) -> (i32, Vec<u8>, String) {
        let output = self.command("render", &words(arguments)).output();
        let output = output.expect("the example runs");
        let words = String::from_utf8(output.stderr).expect("the example says UTF-8");
        let code = output.status.code().expect("the example ends by itself");
        (code, output.stdout, words)
    }

    /// Runs the program with at most 4 GB of memory.
    #[cfg(target_os = "linux")]
    pub fn render_in_4_gigabytes(&self, arguments: &str) -> Outcome {
        let mut shell = Command::new("sh");
        shell.args(["-c", "ulimit -v 4000000 && exec \"$0\" \"$@\""]);
        shell.arg(binary("render")).args(words(arguments));
        finish(shell.current_dir(&self.0))
    }

    fn command(&self, example: &'static str, arguments: &[&str]) -> Command {
        let mut command = Command::new(binary(example));
        command.args(arguments).current_dir(&self.0);
        command.stdin(Stdio::null());
        command
    }
}

fn words(arguments: &str) -> Vec<&str> {
    arguments.split_whitespace().collect()
}

fn finish(command: &mut Command) -> Outcome {
    let output = command.output().expect("the example runs");
    let text = |bytes| String::from_utf8(bytes).expect("the example prints UTF-8");
    Outcome {
        code: output.status.code().expect("the example ends by itself"),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    }
}

/// Environment variable that says that all examples have just been built in the profile of the
/// tests.
const ARE_BUILT: &str = "EXAMPLES_ARE_BUILT";

/// Returns the path of an example's program, built from the current sources.
///
/// Cargo does not give a test the path of an example, so this runs cargo. With the profile, the
/// features and the folder of this test, nothing needs building after a whole `cargo test`.
fn binary(example: &'static str) -> PathBuf {
    static BINARIES: Mutex<BTreeMap<&str, PathBuf>> = Mutex::new(BTreeMap::new());
    let mut binaries = BINARIES.lock().expect("no build has failed");
    let built = binaries.entry(example).or_insert_with(|| {
        let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent();
        let target = target.expect("target/tmp");
        let (profile, folder) =
            if cfg!(debug_assertions) { ("test", "debug") } else { ("release", "release") };
        let program = format!("{example}{}", env::consts::EXE_SUFFIX);
        let program = target.join(folder).join("examples").join(program);
        if env::var_os(ARE_BUILT).is_some() {
            return program;
        }
        let features = [
            ("film", cfg!(feature = "film")),
            ("window", cfg!(feature = "window")),
        ];
        let features = features.into_iter().filter(|(_, is_on)| *is_on);
        let features: Vec<_> = features.map(|(name, _)| name).collect();
        let output = Command::new(env!("CARGO"))
            .current_dir(env!("CARGO_MANIFEST_DIR"))
            .env_remove("CARGO_BUILD_TARGET")
            .args(["build", "--example", example, "--profile", profile])
            .args(["--features", &features.join(",")])
            .arg("--target-dir")
            .arg(target)
            .output()
            .expect("cargo runs");
        let complaints = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "it is built: {complaints}");
        program
    });
    built.clone()
}
