//! Words on the command line, and lines about what is wrong with them; it prints nothing.

use embedded_graphics::geometry::Size;

/// Width and height of a picture, such as `320x240`.
pub fn size(text: &str) -> Result<Size, &'static str> {
    let side = |digits: &str| match digits.bytes().all(|digit| digit.is_ascii_digit()) {
        true => digits.parse::<u16>().ok().filter(|&side| side > 0),
        false => None,
    };
    let sides = text
        .split_once('x')
        .map(|(width, height)| (side(width), side(height)));
    match sides {
        Some((Some(width), Some(height))) => Ok(Size::new(width.into(), height.into())),
        _ => Err("not a width and a height from 1 to 65535, such as 320x240"),
    }
}

/// What clap says over several lines, without its advice to read the help.
pub fn in_one_line(text: &str) -> String {
    let end = |line: &&str| line.starts_with("Usage:") || line.starts_with("For more info");
    let empty = |line: &&str| line.is_empty() || line.starts_with("tip: to pass");
    let lines = text.lines().map(str::trim).take_while(|line| !end(line));
    let lines: Vec<_> = lines.filter(|line| !empty(line)).collect();
    lines.join("; ").trim_start_matches("error: ").to_owned()
}

/// What would break the line, which may come from a path or a file, is written as an escape.
pub fn one_line(text: &str) -> String {
    let escaped = |letter: char| match letter.is_control() {
        true => letter.escape_default().to_string(),
        false => letter.to_string(),
    };
    text.chars().map(escaped).collect()
}
