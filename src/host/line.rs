//! Text from outside in one line: names and paths may hold anything.

use std::string::{String, ToString};

/// The text with every control character and line separator escaped as in Rust.
///
/// ```
/// assert_eq!(reflet::host::line::one_line("red\nbox"), "red\\nbox");
/// ```
pub fn one_line(text: &str) -> String {
    escaped(text, |letter| letter.escape_default().to_string())
}

/// The text with what breaks a line or steers a terminal replaced by its `escape`.
pub fn escaped(text: &str, escape: impl Fn(char) -> String) -> String {
    let breaks = |letter: char| letter.is_control() || matches!(letter, '\u{2028}' | '\u{2029}');
    let written = |letter: char| match breaks(letter) {
        true => escape(letter),
        false => letter.to_string(),
    };
    text.chars().map(written).collect()
}
