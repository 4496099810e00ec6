//! Writes bytes to files, to streams and to standard output. Replaces a file only if the user named its
//! path. This module never knows what the bytes are.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::process;

use crate::{Failure, one_line};

/// Path that stands for standard output.
const STANDARD_OUTPUT: &str = "-";

/// A destination that was tested to be writable before the work began.
#[derive(Debug)]
pub struct OutputFile {
    path: PathBuf,
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    StandardOutput,
    /// A device or a pipe. Writing to it replaces nothing.
    Stream,
    /// A file with a name that the user chose. If it exists, it is replaced.
    File,
    /// A new file. Its name gets a number if another file has the name by then.
    Numbered,
}

impl OutputFile {
    /// Tests that a file can be written at `path`, or standard output if `path` is `-`. If there is a
    /// file already, `write` replaces it.
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
        } else if path.is_dir() {
            return Err(format!("{shown} cannot be written: it is a folder").into());
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

    /// Tests that a PNG file can be written at `path`, or standard output if `path` is `-`.
    ///
    /// # Errors
    /// Fails like [`OutputFile::at`], and if the name has the extension of another format.
    pub fn png_at(path: &Path) -> Result<Self, Failure> {
        Self::in_format(path, "png", "pictures")
    }

    /// As [`OutputFile::png_at`], for a GIF file.
    pub fn gif_at(path: &Path) -> Result<Self, Failure> {
        Self::in_format(path, "gif", "films")
    }

    fn in_format(path: &Path, format: &str, what: &str) -> Result<Self, Failure> {
        let extension = path.extension().unwrap_or(format.as_ref());
        if extension.eq_ignore_ascii_case(format) {
            Self::at(path)
        } else {
            let (shown, named) = (shown(path), shown(&path.with_extension(format)));
            let format = format.to_uppercase();
            Err(format!("{shown}: {what} are written as {format} only: name it {named}").into())
        }
    }

    /// Tests that a PNG file can be written. `write` takes the first free name of `NAME.png`,
    /// `NAME-2.png`, `NAME-3.png` and so on.
    pub fn free_png(path: &Path) -> Result<Self, Failure> {
        let failed = |error| not_written(path, &error);
        let (_, tried) = create_numbered(path).map_err(failed)?;
        fs::remove_file(tried).map_err(failed)?;
        let (path, kind) = (path.to_owned(), Kind::Numbered);
        Ok(Self { path, kind })
    }

    /// Writes all bytes and returns the path. If that fails, no new file is left, and an old file keeps
    /// its bytes. If standard output has no reader any more, this is no error.
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
            Kind::File => {
                replace(&path, bytes).map_err(failed)?;
                return Ok(path);
            }
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

pub fn is_standard_output(path: &Path) -> bool {
    path == Path::new(STANDARD_OUTPUT)
}

/// Tests whether two paths lead to the same file. The file need not exist yet.
pub fn are_same_file(one: &Path, other: &Path) -> bool {
    one == other || location(one).is_some_and(|it| Some(it) == location(other))
}

/// Prints the bytes on standard output. A closed pipe is no error.
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

/// Tests whether [`replace`] can write a file: creates what it would create, and removes it.
fn try_out(path: &Path) -> io::Result<()> {
    let tried = match path.canonicalize() {
        // The owner may have made the file read-only.
        Ok(existing) => {
            open_stream(&existing)
                .and_then(|_| create_beside(&existing))?
                .1
        }
        Err(_) if path.is_symlink() => create_beside(path)?.1,
        Err(_) => File::create_new(path).map(|_| path.to_owned())?,
    };
    fs::remove_file(tried)
}

/// Writes all bytes to a file, which may exist. They go to a temporary file first, which is then
/// renamed. So the file never holds only a part of them.
fn replace(path: &Path, bytes: &[u8]) -> io::Result<()> {
    // The file that a link leads to is replaced, not the link.
    let target = path.canonicalize().unwrap_or_else(|_| path.to_owned());
    let (mut file, temporary) = create_beside(&target)?;
    let written = file.write_all(bytes).and_then(|()| {
        if let Ok(old) = target.metadata() {
            file.set_permissions(old.permissions())?;
        }
        // Some systems do not rename an open file.
        drop(file);
        fs::rename(&temporary, &target)
    });
    if written.is_err() {
        // Only the first error is reported.
        let _ = fs::remove_file(&temporary);
    }
    written
}

/// Creates a temporary file in the folder of `path`.
fn create_beside(path: &Path) -> io::Result<(File, PathBuf)> {
    let mut number = 1;
    loop {
        let temporary = path.with_file_name(format!(".reflet-{}-{number}", process::id()));
        match File::create_new(&temporary) {
            Err(error) if error.kind() == ErrorKind::AlreadyExists => number += 1,
            made => return made.map(|file| (file, temporary)),
        }
    }
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
