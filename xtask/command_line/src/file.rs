//! Writes bytes to new files, to streams and to standard output. Never replaces a file. This module
//! never knows what the bytes are.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};

use crate::{Failure, one_line};

/// Path that stands for standard output.
const STANDARD_OUTPUT: &str = "-";

/// A destination that was tested to be writable before the work began.
#[derive(Debug)]
pub struct NewFile {
    path: PathBuf,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    StandardOutput,
    /// A device or a pipe. Writing to it replaces nothing.
    Stream,
    /// A file that does not exist yet.
    File,
    /// A file that does not exist yet. Its name gets a number if another file has the name by then.
    Numbered,
}

impl NewFile {
    /// Tests that a new file can be written at `path`, or standard output if `path` is `-`.
    ///
    /// # Errors
    ///
    /// Fails if something at `path` would be replaced, or if nothing can be written there.
    pub fn at(path: &Path) -> Result<Self, Failure> {
        let shown = shown(path);
        let failed = |error| not_written(path, &error);
        let kind = if is_standard_output(path) {
            Kind::StandardOutput
        } else if is_stream(path) {
            // Opening a pipe waits for its reader, which may not be ready yet.
            if !is_pipe(path) {
                open_stream(path).map_err(failed)?;
            }
            Kind::Stream
        } else if path.symlink_metadata().is_ok() {
            return Err(format!("{shown} exists and is not written over").into());
        } else if !folder_of(path).is_dir() {
            let missing = self::shown(folder_of(path));
            return Err(format!("{shown} cannot be written: there is no folder {missing}").into());
        } else {
            try_out(path).map_err(failed)?;
            Kind::File
        };
        let path = path.to_owned();
        Ok(Self { path, kind })
    }

    /// Tests that a new PNG file can be written at `path`, or standard output if `path` is `-`.
    ///
    /// # Errors
    ///
    /// Fails like [`NewFile::at`], and if the name has the extension of another format.
    pub fn png_at(path: &Path) -> Result<Self, Failure> {
        let extension = path.extension().unwrap_or("png".as_ref());
        match extension.eq_ignore_ascii_case("png") {
            true => Self::at(path),
            false => {
                let (shown, png) = (shown(path), shown(&path.with_extension("png")));
                Err(format!("{shown}: pictures are written as PNG only: name it {png}").into())
            }
        }
    }

    /// Tests that a PNG file can be written. `write` takes the first free name of `NAME.png`,
    /// `NAME-2.png`, `NAME-3.png` and so on.
    ///
    /// # Errors
    ///
    /// Fails if no file can be created there.
    pub fn free_png(path: &Path) -> Result<Self, Failure> {
        let failed = |error| not_written(path, &error);
        let (_, tried) = create_numbered(path).map_err(failed)?;
        fs::remove_file(tried).map_err(failed)?;
        let (path, kind) = (path.to_owned(), Kind::Numbered);
        Ok(Self { path, kind })
    }

    /// Writes all bytes and returns the path. Removes the file if that fails. If standard output has
    /// no reader any more, this is no error.
    pub fn write(self, bytes: &[u8]) -> Result<PathBuf, Failure> {
        let Self { path, kind } = self;
        let failed = |error| not_written(&path, &error);
        let (mut file, path) = match kind {
            Kind::StandardOutput => {
                print(bytes)?;
                return Ok(path);
            }
            Kind::Stream => {
                let sent = open_stream(&path).and_then(|mut stream| stream.write_all(bytes));
                sent.map_err(failed)?;
                return Ok(path);
            }
            Kind::File => (File::create_new(&path).map_err(failed)?, path),
            Kind::Numbered => create_numbered(&path).map_err(failed)?,
        };
        if let Err(error) = file.write_all(bytes) {
            // Only the first error is reported.
            let _ = fs::remove_file(&path);
            return Err(not_written(&path, &error));
        }
        Ok(path)
    }
}

/// Returns the path as text for a person, in one line.
pub fn shown(path: &Path) -> String {
    one_line(&path.to_string_lossy())
}

/// Tests whether the path stands for standard output.
pub fn is_standard_output(path: &Path) -> bool {
    path == Path::new(STANDARD_OUTPUT)
}

/// Tests whether two paths lead to the same file. The file need not exist yet.
pub fn are_same_file(one: &Path, other: &Path) -> bool {
    one == other || location(one).is_some_and(|it| Some(it) == location(other))
}

/// Prints the bytes on standard output. A closed pipe is no error.
///
/// # Errors
///
/// Fails if standard output cannot be written for another reason.
pub fn print(bytes: impl AsRef<[u8]>) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    let printed = output
        .write_all(bytes.as_ref())
        .and_then(|()| output.flush());
    match printed {
        Err(error) if error.kind() != ErrorKind::BrokenPipe => {
            Err(format!("standard output cannot be written: {error}").into())
        }
        _ => Ok(()),
    }
}

fn not_written(path: &Path, error: &io::Error) -> Failure {
    format!("{} cannot be written: {error}", shown(path)).into()
}

fn is_stream(path: &Path) -> bool {
    path.metadata()
        .is_ok_and(|found| !found.is_file() && !found.is_dir())
}

#[cfg(unix)]
fn is_pipe(path: &Path) -> bool {
    use std::os::unix::fs::FileTypeExt;
    path.metadata()
        .is_ok_and(|found| found.file_type().is_fifo())
}

#[cfg(not(unix))]
fn is_pipe(_: &Path) -> bool {
    false
}

fn open_stream(path: &Path) -> io::Result<File> {
    File::options().write(true).open(path)
}

fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// Returns the path of a file without links and without `..`. Its last part need not exist. `None`
/// for standard output.
fn location(path: &Path) -> Option<PathBuf> {
    if is_standard_output(path) {
        return None;
    }
    let found = path.canonicalize();
    found.ok().or_else(|| {
        let folder = folder_of(path).canonicalize().ok()?;
        Some(folder.join(path.file_name()?))
    })
}

/// Creates a file and removes it: the only sure test that the file can be created.
fn try_out(path: &Path) -> io::Result<()> {
    File::create_new(path)?;
    fs::remove_file(path)
}

/// Creates the file with the first free name of `NAME.png`, `NAME-2.png`, `NAME-3.png` and so on.
fn create_numbered(path: &Path) -> io::Result<(File, PathBuf)> {
    let stem = path.file_stem().unwrap_or(path.as_os_str());
    let mut next = path.to_owned();
    let mut number = 1;
    loop {
        match File::create_new(&next) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => number += 1,
            made => return made.map(|file| (file, next)),
        }
        let mut name = OsString::from(stem);
        name.push(format!("-{number}.png"));
        next.set_file_name(name);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_the_same_however_they_lead_there() {
        let folder = tempfile::tempdir().unwrap();
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("a")).unwrap();
        #[cfg(unix)]
        std::os::unix::fs::symlink(path("a"), path("link")).unwrap();
        assert!(are_same_file(&path("x"), &path("./x")));
        assert!(are_same_file(&path("x"), &path("a/../x")));
        #[cfg(unix)]
        assert!(are_same_file(&path("a/x"), &path("link/x")));
        assert!(!are_same_file(&path("x"), &path("a/x")));
        assert!(!are_same_file(&path("x"), &path("y")));
        assert!(are_same_file("-".as_ref(), "-".as_ref()));
        assert!(!are_same_file("./-".as_ref(), "-".as_ref()));
    }

    #[test]
    fn name_without_a_number_comes_first() {
        let folder = tempfile::tempdir().unwrap();
        let castle = folder.path().join("castle.png");
        for name in ["castle.png", "castle-2.png", "castle-3.png"] {
            let written = NewFile::free_png(&castle).unwrap().write(b"dots");
            assert_eq!(written.unwrap(), folder.path().join(name));
        }
    }

    #[test]
    fn nothing_is_left_where_nothing_is_written() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.png");
        drop((NewFile::png_at(&path), NewFile::free_png(&path)));
        assert_eq!(fs::read_dir(folder.path()).unwrap().count(), 0);
    }

    #[test]
    fn name_of_another_format_is_refused() {
        let refused = NewFile::png_at(Path::new("a.jpg")).unwrap_err().to_string();
        let expected = "a.jpg: pictures are written as PNG only: name it a.png";
        assert_eq!(refused, expected);
    }
}
