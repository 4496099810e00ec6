//! Finds the part of a scene file that an error names, such as `spheres[3]`, in the text. The text is JSON that was
//! read already, so nothing is checked here.

use reflet::host::file::{FileError, Problem};
use reflet::{Error, ErrorKind};

/// Returns line and column of the part that an error names, counted from 1; `None` if it names none.
pub(crate) fn of(error: &FileError, text: &str) -> Option<(usize, usize)> {
    let (list, index) = match error.problem() {
        Problem::Json { line, column, .. } => return Some((*line, *column)),
        Problem::Repeated { place, .. } | Problem::UnknownMaterial { place, .. } => {
            let (list, rest) = place.split_once('[')?;
            (list.to_owned(), rest.trim_end_matches(']').parse().ok())
        }
        Problem::TwoBackgrounds => ("sky".to_owned(), None),
        Problem::Camera(_) => ("camera".to_owned(), None),
        Problem::Scene(error) | Problem::TooSmall { error, .. } => part(error),
        _ => return None,
    };
    let mut scanner = Scanner { text, at: 0 };
    scanner.enter_scene(error.scene())?;
    scanner.enter_key(&list)?;
    if let Some(index) = index {
        scanner.enter_item(index)?;
    }
    Some(line_and_column(text, scanner.at))
}

/// Returns the key of the part that the library refuses, and the index in its list.
fn part(error: &Error) -> (String, Option<usize>) {
    match error.index() {
        Some(index) => (format!("{}s", error.part()), Some(index)),
        None if error.kind() == ErrorKind::Epsilon => ("epsilon".to_owned(), None),
        None => (error.part().to_owned(), None),
    }
}

fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let before = &text[..at];
    let line = before.matches('\n').count() + 1;
    let start = before.rfind('\n').map_or(0, |it| it + 1);
    (line, before[start..].chars().count() + 1)
}

/// A place in JSON text: the start of a value, or what stands before it.
#[derive(Clone, Copy)]
struct Scanner<'a> {
    text: &'a str,
    at: usize,
}

impl Scanner<'_> {
    /// Skips what separates values, and returns the next byte.
    fn next(&mut self) -> Option<u8> {
        let rest = &self.text[self.at..];
        let is_between = |it: char| it.is_whitespace() || ",:\u{feff}".contains(it);
        self.at += rest.len() - rest.trim_start_matches(is_between).len();
        self.text.as_bytes().get(self.at).copied()
    }

    /// Skips the next value.
    fn skip(&mut self) {
        let mut depth = 0;
        while let Some(byte) = self.next() {
            match byte {
                b'"' => self.skip_string(),
                b'{' | b'[' => (depth, self.at) = (depth + 1, self.at + 1),
                b'}' | b']' => (depth, self.at) = (depth - 1, self.at + 1),
                _ => {
                    let rest = &self.text[self.at..];
                    let is_end = |it: char| it.is_whitespace() || ",:]}".contains(it);
                    self.at += rest.find(is_end).unwrap_or(rest.len());
                }
            }
            if depth <= 0 {
                return;
            }
        }
    }

    fn skip_string(&mut self) {
        let bytes = self.text.as_bytes();
        self.at += 1;
        while self.at < bytes.len() && bytes[self.at] != b'"' {
            self.at += if bytes[self.at] == b'\\' { 2 } else { 1 };
        }
        self.at += 1;
    }

    /// Moves to the scene with this name, or without one: the only one, or one of an array.
    fn enter_scene(&mut self, name: Option<&str>) -> Option<()> {
        if self.next()? != b'[' {
            return Some(());
        }
        let mut items = (0..).map_while(|index| {
            let mut item = *self;
            item.enter_item(index).map(|()| item)
        });
        *self = items.find(|item| item.name().as_deref() == name)?;
        Some(())
    }

    /// Returns the name of a scene.
    fn name(mut self) -> Option<String> {
        self.enter_key("name")?;
        let start = self.at;
        self.skip();
        serde_json::from_str(&self.text[start..self.at]).ok()
    }

    /// Moves to an item of the array that comes next.
    fn enter_item(&mut self, index: usize) -> Option<()> {
        self.next()?;
        self.at += 1;
        for _ in 0..index {
            match self.next()? {
                b']' => return None,
                _ => self.skip(),
            }
        }
        (self.next()? != b']').then_some(())
    }

    /// Moves to the value of a key in the object that comes next.
    fn enter_key(&mut self, key: &str) -> Option<()> {
        self.next()?;
        self.at += 1;
        while self.next()? == b'"' {
            let start = self.at + 1;
            self.skip_string();
            let is_meant = &self.text[start..self.at - 1] == key;
            self.next()?;
            if is_meant {
                return Some(());
            }
            self.skip();
        }
        None
    }
}
