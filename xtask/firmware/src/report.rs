//! Words and numbers on the semihosting console.

use semihosting::io::{Write, stdout};

pub fn text(words: &str) {
    if let Ok(mut console) = stdout() {
        // Whoever reads the report misses what could not be written.
        let _ = console.write_all(words.as_bytes());
    }
}

/// Writes a name and a number of 16 hexadecimal digits.
pub fn number(name: &str, value: u64) {
    text(name);
    for digit in (0..16).rev() {
        let nibble = (value >> (4 * digit)) as usize & 0xf;
        text("0123456789abcdef".get(nibble..=nibble).unwrap_or("?"));
    }
}

/// Prints an error message and ends the emulation.
pub fn stop(what: &str) -> ! {
    text("refused: ");
    text(what);
    text("\n");
    semihosting::process::exit(1)
}
