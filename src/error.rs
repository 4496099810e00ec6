//! Floor 0: the one error of the crate: which part is wrong, what is wrong with it, and the fix.

use core::fmt;

use crate::error_kind::ErrorKind;

/// What is wrong with a scene, a camera, or a call: the part and the fix.
///
/// ```
/// use reflet::{ErrorKind, Material, RuntimeScene, room};
///
/// let mut scene = RuntimeScene::<room!(spheres: 1)>::new();
/// let chalk = scene.add_material(Material::new([0.9, 0.9, 0.8]))?;
/// let error = scene.add_sphere([0, 0, 0], -1, chalk).unwrap_err();
/// assert_eq!((error.part(), error.index()), ("sphere", Some(0)));
/// assert_eq!(error.kind(), ErrorKind::Radius);
/// assert_eq!(error.to_string(), "sphere 0: radius must be greater than 0");
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Error {
    part: &'static str,
    index: Option<usize>,
    kind: ErrorKind,
}

impl Error {
    /// An error of the only part of its name, such as the camera.
    pub(crate) const fn of(part: &'static str, kind: ErrorKind) -> Self {
        Self {
            part,
            index: None,
            kind,
        }
    }

    /// An error of one of several parts of a name, counted from 0.
    pub(crate) const fn at(part: &'static str, index: usize, kind: ErrorKind) -> Self {
        Self {
            part,
            index: Some(index),
            kind,
        }
    }

    /// Returns the name of the part: `"sphere"`, `"camera"`, `"scene"`.
    pub const fn part(&self) -> &'static str {
        self.part
    }

    /// Returns the number of the part among those of its name, counted from 0; `None` if there is only
    /// one.
    pub const fn index(&self) -> Option<usize> {
        self.index
    }

    /// Returns what is wrong with the part.
    pub const fn kind(&self) -> ErrorKind {
        self.kind
    }

    /// Stops the compiler with the error as its message; for constants.
    pub(crate) const fn stop(&self) -> ! {
        let mut message = Message::EMPTY;
        message.push(self.part);
        if let Some(index) = self.index {
            message.push(" ");
            message.push_number(index);
        }
        message.push(": ");
        message.push(self.kind.message());
        panic!("{}", message.as_str())
    }

    /// Stops the compiler if there is an error; for constants.
    pub(crate) const fn refuse(part: &'static str, fault: Option<ErrorKind>) {
        if let Some(kind) = fault {
            Self::of(part, kind).stop();
        }
    }

    /// Stops the compiler if there is an error in one of several parts; for constants.
    pub(crate) const fn refuse_at(part: &'static str, index: usize, fault: Option<ErrorKind>) {
        if let Some(kind) = fault {
            Self::at(part, index, kind).stop();
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.index {
            Some(index) => write!(formatter, "{} {index}: {}", self.part, self.kind),
            None => write!(formatter, "{}: {}", self.part, self.kind),
        }
    }
}

impl core::error::Error for Error {}

/// Text put together while a constant is compiled.
struct Message {
    bytes: [u8; 256],
    len: usize,
}

impl Message {
    const EMPTY: Self = Self {
        bytes: [0; 256],
        len: 0,
    };

    /// Appends text; what is longer than the room is cut off.
    const fn push(&mut self, text: &str) {
        let text = text.as_bytes();
        let mut index = 0;
        while index < text.len() && self.len < self.bytes.len() {
            self.bytes[self.len] = text[index];
            self.len += 1;
            index += 1;
        }
    }

    /// Appends a number in decimal digits.
    const fn push_number(&mut self, number: usize) {
        const DIGITS: &[&str] = &["0", "1", "2", "3", "4", "5", "6", "7", "8", "9"];
        if number > 9 {
            self.push_number(number / 10);
        }
        self.push(DIGITS[number % 10]);
    }

    const fn as_str(&self) -> &str {
        let (text, _) = self.bytes.split_at(self.len);
        match core::str::from_utf8(text) {
            Ok(text) => text,
            Err(_) => "this scene is wrong",
        }
    }
}

#[cfg(test)]
mod tests {
    use std::string::ToString;

    use super::*;

    #[test]
    fn compiler_and_program_say_the_same() {
        for error in [
            Error::at("sphere", 120, ErrorKind::Radius),
            Error::of("camera", ErrorKind::Up),
            Error::at("material", 0, ErrorKind::Brightness),
        ] {
            let stopped = std::panic::catch_unwind(|| error.stop()).unwrap_err();
            assert_eq!(
                *stopped.downcast::<std::string::String>().unwrap(),
                error.to_string()
            );
        }
    }
}
