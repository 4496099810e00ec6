//! Finds the part of a scene file that an error names, such as `spheres[3]`, in the text. The text is JSON that was
//! read already, so nothing is checked here.

use reflet::host::file::{FileError, Problem};
use reflet::{Error, ErrorKind};

/// Returns line and column of the part that an error names, counted from 1; `None` if it names none.
pub(crate) fn of(error: &FileError, text: &str) -> Option<(usize, usize)> {
    let (list, index) = match error.problem() {
        Problem::Json { line, column, .. } => return Some((*line, *column)),
        Problem::Repeated { place, .. } | Problem::UnknownMaterial { place, .. } => {
            let (list, index) = place.strip_suffix(']')?.split_once('[')?;
            (list.to_owned(), index.parse().ok())
        }
        Problem::TwoBackgrounds => ("sky".to_owned(), None),
        Problem::Camera(_) => ("camera".to_owned(), None),
        Problem::Scene(error) | Problem::TooSmall { error, .. } => part(error),
        _ => return None,
    };
    let mut scanner = Scanner {
        text: text.as_bytes(),
        at: 0,
    };
    scanner.enter_scene(error.scene())?;
    scanner.enter_key(&list)?;
    if let Some(index) = index {
        scanner.enter_item(index)?;
    }
    Some(line_and_column(text, scanner.at))
}

/// Returns the key of the refused part in a scene file, and its index if the key holds a list.
fn part(error: &Error) -> (String, Option<usize>) {
    match error.index() {
        Some(index) => (format!("{}s", error.part()), Some(index)),
        None if error.kind() == ErrorKind::Epsilon => ("epsilon".to_owned(), None),
        None => (error.part().to_owned(), None),
    }
}

fn line_and_column(text: &str, at: usize) -> (usize, usize) {
    let (mut line, mut column) = (1, 1);
    for byte in text.bytes().take(at) {
        match byte {
            b'\n' => (line, column) = (line + 1, 1),
            // The bytes of a letter after its first one.
            0x80..=0xbf => {}
            _ => column += 1,
        }
    }
    (line, column)
}

/// Tests whether a byte may stand between two values.
fn separates(byte: u8) -> bool {
    const BYTE_ORDER_MARK: [u8; 3] = [0xef, 0xbb, 0xbf];
    byte.is_ascii_whitespace() || byte == b',' || byte == b':' || BYTE_ORDER_MARK.contains(&byte)
}

/// A place in JSON text: the start of a value, or what stands before it.
#[derive(Clone, Copy)]
struct Scanner<'a> {
    text: &'a [u8],
    at: usize,
}

impl<'a> Scanner<'a> {
    /// Skips what separates values, and returns the next byte.
    fn next(&mut self) -> Option<u8> {
        loop {
            match self.text.get(self.at) {
                Some(byte) if separates(*byte) => self.at += 1,
                byte => return byte.copied(),
            }
        }
    }

    fn skip(&mut self) {
        let mut depth = 0;
        while let Some(byte) = self.next() {
            match byte {
                b'"' => _ = self.string(),
                b'{' | b'[' => (depth, self.at) = (depth + 1, self.at + 1),
                b'}' | b']' => (depth, self.at) = (depth - 1, self.at + 1),
                _ => self.skip_word(),
            }
            if depth <= 0 {
                return;
            }
        }
    }

    /// Skips a number, a truth value or `null`.
    fn skip_word(&mut self) {
        let is_word = |byte: &u8| byte.is_ascii_alphanumeric() || b"+-.".contains(byte);
        while self.text.get(self.at).is_some_and(is_word) {
            self.at += 1;
        }
    }

    /// Skips a text, and returns it as it is written.
    fn string(&mut self) -> &'a [u8] {
        let start = self.at + 1;
        self.at = start;
        while let Some(byte) = self.text.get(self.at).filter(|byte| **byte != b'"') {
            self.at += if *byte == b'\\' { 2 } else { 1 };
        }
        let end = self.at.min(self.text.len());
        self.at = end + 1;
        self.text.get(start..end).unwrap_or(&[])
    }

    /// Moves to the scene with this name, or without one: the only one, or one of an array. A name with an
    /// escape is not found.
    fn enter_scene(&mut self, name: Option<&str>) -> Option<()> {
        if self.next()? != b'[' {
            return Some(());
        }
        let mut index = 0;
        loop {
            let mut item = *self;
            item.enter_item(index)?;
            let mut own = item;
            let own = own.enter_key("name").map(|()| own.string());
            if own == name.map(str::as_bytes) {
                *self = item;
                return Some(());
            }
            index += 1;
        }
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
            let is_meant = self.string() == key.as_bytes();
            self.next()?;
            if is_meant {
                return Some(());
            }
            self.skip();
        }
        None
    }
}
