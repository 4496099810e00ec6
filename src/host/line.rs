//! Escapes text from outside so that it stays on one line. Names and paths of a user may hold any
//! character.

use alloc::string::{String, ToString};

/// Returns the text with every control character and line separator escaped as in a Rust literal: a line
/// break becomes `\n`.
///
/// ```
/// assert_eq!(reflet::host::line::one_line("red\nbox"), "red\\nbox");
/// ```
pub fn one_line(text: &str) -> String {
    escaped(text, |letter| letter.escape_default().to_string())
}

/// Returns the text with each control character and each Unicode line or paragraph separator replaced by
/// `escape(character)`. These are the characters that break a line or control a terminal.
///
/// ```
/// use reflet::host::line::escaped;
/// assert_eq!(escaped("red\tbox", |letter| format!("<{:x}>", letter as u32)), "red<9>box");
/// ```
pub fn escaped(text: &str, escape: impl Fn(char) -> String) -> String {
    let breaks = |letter: char| letter.is_control() || matches!(letter, '\u{2028}' | '\u{2029}');
    let written = |letter: char| {
        if breaks(letter) { escape(letter) } else { letter.to_string() }
    };
    text.chars().map(written).collect()
}
