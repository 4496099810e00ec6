//! Reads the text of a scene file from disk. This file never knows what the text says.

use std::borrow::ToOwned;
use std::fs::File;
use std::io::{self, Read};
use std::path::Path;
use std::string::String;
use std::vec::Vec;

use super::{FileError, MAX_BYTES, Problem, SceneFile};

impl SceneFile {
    /// Reads the scene called `name` from the file at `path`, or the only scene if `name` is `None`.
    ///
    /// # Errors
    ///
    /// The file cannot be read or is larger than [`MAX_BYTES`]; and all errors of [`SceneFile::parse`].
    pub fn read(path: impl AsRef<Path>, name: Option<&str>) -> Result<Self, FileError> {
        let path = path.as_ref();
        let read = text_of(path)
            .map_err(FileError::new)
            .and_then(|text| Self::parse(&text, name))
            .map_err(|error| error.in_file(Some(path)))?;
        Ok(Self {
            path: Some(path.to_owned()),
            ..read
        })
    }
}

/// Returns the text of the file at `path`, if that is UTF-8 and at most [`MAX_BYTES`] long.
///
/// It stops one byte beyond the limit, so a pipe or a device, which has no known size, is never read
/// without end.
fn text_of(path: &Path) -> Result<String, Problem> {
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes))
        .map_err(Problem::Unreadable)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Problem::TooLarge);
    }
    String::from_utf8(bytes).map_err(|_| {
        let words = "the file is not UTF-8 text";
        Problem::Unreadable(io::Error::new(io::ErrorKind::InvalidData, words))
    })
}
