//! What whoever typed the command can mend: bad arguments, bad files. One line, exit code 2.

use std::fmt;

/// A mistake in an argument or in a file that an argument names.
#[derive(Debug)]
pub struct Misuse(String);

impl Misuse {
    /// A mistake, in words.
    pub fn new(words: impl fmt::Display) -> Self {
        Self(words.to_string())
    }

    /// What the command line's parser says over several lines, without its advice to read the
    /// help.
    pub fn from_clap(error: &clap::Error) -> Self {
        let text = error.render().to_string();
        let is_end = |line: &&str| line.starts_with("Usage:") || line.starts_with("For more info");
        let is_empty = |line: &&str| line.is_empty() || line.starts_with("tip: to pass");
        let lines = text.lines().map(str::trim).take_while(|line| !is_end(line));
        let lines: Vec<_> = lines.filter(|line| !is_empty(line)).collect();
        Self(lines.join("; ").trim_start_matches("error: ").to_owned())
    }
}

/// What would break the line, which may come from a path or a file, is written as an escape.
impl fmt::Display for Misuse {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.chars().try_for_each(|letter| {
            match letter.is_control() || matches!(letter, '\u{2028}' | '\u{2029}') {
                true => write!(f, "{}", letter.escape_default()),
                false => write!(f, "{letter}"),
            }
        })
    }
}

impl std::error::Error for Misuse {}
