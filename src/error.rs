//! Floor 0: the one error type of the crate. It names the part that is wrong, the mistake, and the fix.

use core::fmt;

use crate::error_kind::ErrorKind;

/// The error of a scene, a camera, a material or a call: names the part, the mistake and the fix.
///
/// As text it is one line: the part, its index if it has one, and [`ErrorKind::message`]. [`Debug`](fmt::Debug) writes the
/// same, so that `unwrap` and a `main` that returns the error show the fix, too.
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
/// assert_eq!(format!("{error:?}"), error.to_string());
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub struct Error {
    part: &'static str,
    index: Option<usize>,
    kind: ErrorKind,
}

impl Error {
    /// Creates an error of a part that exists only once, such as the camera. It has no index.
    pub(crate) const fn of(part: &'static str, kind: ErrorKind) -> Self {
        Self::new(part, None, kind)
    }

    /// Creates an error of a part of which a scene can have several, such as a sphere. `index` counts from 0
    /// within its kind.
    pub(crate) const fn at(part: &'static str, index: usize, kind: ErrorKind) -> Self {
        Self::new(part, Some(index), kind)
    }

    /// Creates an error of a part, with its index if it has one.
    pub(crate) const fn new(part: &'static str, index: Option<usize>, kind: ErrorKind) -> Self {
        Self { part, index, kind }
    }

    /// Returns the name of the part that is wrong: `"sphere"`, `"plane"`, `"cylinder"`, `"disc"`, `"triangle"`,
    /// `"light"`, `"sun"`, `"material"`, `"scene"`, `"sky"`, `"camera"`, `"motion"` or `"number"`.
    ///
    /// For [`ErrorKind::Limit`] it is the name of a need, such as `"mirrors"`.
    pub const fn part(&self) -> &'static str {
        self.part
    }

    /// Returns the index of the part that is wrong among those of its kind, counted from 0.
    ///
    /// It is `None` for parts that exist only once, such as the camera.
    pub const fn index(&self) -> Option<usize> {
        self.index
    }

    /// Returns the kind of the mistake, such as [`ErrorKind::Radius`].
    pub const fn kind(&self) -> ErrorKind {
        self.kind
    }

    /// Panics with the text of the error. In a constant, this stops the compiler.
    #[track_caller]
    pub(crate) const fn stop(&self) -> ! {
        self.stop_in_line(None)
    }

    /// Panics with the text of the error and the line of the user's source that is wrong.
    #[track_caller]
    pub(crate) const fn stop_in_line(&self, line: Option<u32>) -> ! {
        let mut message = Message::EMPTY;
        message.push(self.part);
        if let Some(index) = self.index {
            message.push(" ");
            message.push_number(index);
        }
        if let Some(line) = line {
            message.push(" in line ");
            message.push_number(line as usize);
        }
        message.push(": ");
        message.push(self.kind.message());
        panic!("{}", message.as_str())
    }

    /// Panics if `fault` is `Some`, for a part that exists only once. In a constant, this stops the
    /// compiler.
    #[track_caller]
    pub(crate) const fn refuse(part: &'static str, fault: Option<ErrorKind>) {
        if let Some(kind) = fault {
            Self::of(part, kind).stop();
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

impl fmt::Debug for Error {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, formatter)
    }
}

impl core::error::Error for Error {}

/// A text of at most 256 bytes that constant code puts together.
struct Message {
    bytes: [u8; 256],
    len: usize,
}

impl Message {
    const EMPTY: Self = Self {
        bytes: [0; 256],
        len: 0,
    };

    /// Appends text. Cuts it off where the message would exceed 256 bytes.
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
mod tests;
