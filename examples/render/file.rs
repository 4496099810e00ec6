//! Files that never replace another; it never knows what is in them.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use command_line::Failure;

/// The path of a file that is still to be written.
pub struct NewFile(PathBuf);

impl NewFile {
    /// Refuses a path where a file or a folder is, or whose folder is missing. A device or a pipe
    /// may be there: what is sent to it replaces nothing.
    pub fn at(path: &Path) -> Result<Self, Failure> {
        let folder = match path.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        if path.symlink_metadata().is_ok() && !is_stream(path) {
            return Err(format!("{} exists and is not written over", path.display()).into());
        }
        if !folder.is_dir() {
            let (path, folder) = (path.display(), folder.display());
            return Err(format!("{path} cannot be written: there is no folder {folder}").into());
        }
        Ok(Self(path.to_owned()))
    }

    /// `NAME.png` in the current folder, or the first of `NAME-2.png`, `NAME-3.png` that is free.
    pub fn picture_of(scene: &str) -> Self {
        let safe = |letter: char| match letter.is_alphanumeric() || "-_ ".contains(letter) {
            true => letter,
            false => '_',
        };
        let name: String = scene.chars().map(safe).take(50).collect();
        let mut path = PathBuf::from(format!("{name}.png"));
        let mut number = 1;
        while path.symlink_metadata().is_ok() {
            number += 1;
            path.set_file_name(format!("{name}-{number}.png"));
        }
        Self(path)
    }

    /// Where it will be.
    pub fn path(&self) -> &Path {
        &self.0
    }

    /// Writes all of it, or leaves nothing behind.
    pub fn write(&self, bytes: &[u8]) -> Result<(), Failure> {
        let Self(path) = self;
        let failed = |error: io::Error| format!("{} cannot be written: {error}", path.display());
        if is_stream(path) {
            let stream = File::options().write(true).open(path);
            return Ok(stream
                .and_then(|mut stream| stream.write_all(bytes))
                .map_err(failed)?);
        }
        let mut file = File::create_new(path).map_err(failed)?;
        file.write_all(bytes).map_err(|error| {
            // The first error is the one to report.
            let _ = fs::remove_file(path);
            failed(error).into()
        })
    }
}

fn is_stream(path: &Path) -> bool {
    path.metadata()
        .is_ok_and(|found| !found.is_file() && !found.is_dir())
}
