//! Runs `cargo xtask` as a user would.

use std::{path::Path, process::Command};

pub struct Done {
    pub code: i32,
    pub out: String,
    pub err: String,
}

pub fn xtask(folder: &Path, arguments: &str) -> Done {
    let output = Command::new(env!("CARGO_BIN_EXE_xtask"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .output()
        .unwrap();
    Done {
        code: output.status.code().unwrap(),
        out: String::from_utf8(output.stdout).unwrap(),
        err: String::from_utf8(output.stderr).unwrap(),
    }
}

/// Runs the command with each of the mistakes, one a line: `arguments => words`. Checks that it ends
/// with exit code 2 and prints one line that contains the words.
#[allow(dead_code, reason = "not every test of a command makes mistakes")]
pub fn assert_mistakes(folder: &Path, mistakes: &str) {
    for mistake in mistakes.trim().lines() {
        let (arguments, words) = mistake.split_once(" => ").unwrap();
        let Done { code, out, err } = xtask(folder, arguments);
        let lines = err.lines().count();
        assert_eq!((code, lines, &*out), (2, 1, ""), "{arguments}: {err}");
        assert!(err.starts_with("error: "), "{arguments}: {err}");
        assert!(err.contains(words), "{arguments}: {err}");
    }
}
