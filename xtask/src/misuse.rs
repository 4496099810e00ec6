//! A mistake of the person who typed the command: a bad argument or a bad file. It is reported in
//! one line, with exit code 2.

use std::fmt::Display;

use command_line::one_line;

/// A mistake in an argument, or in a file that an argument names.
#[derive(Debug, thiserror::Error)]
#[error("{}", one_line(.0))]
pub struct Misuse(String);

impl Misuse {
    pub fn new(words: impl Display) -> Self {
        Self(words.to_string())
    }
}
