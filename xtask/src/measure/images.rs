//! Firmware images that are built already, kept by what they were built from: one image serves all
//! tests and commands that need it. It builds nothing.

use std::{
    fs,
    hash::{DefaultHasher, Hash, Hasher},
    io::Write,
    path::{Path, PathBuf},
    sync::{Mutex, OnceLock, PoisonError},
};

use anyhow::{Context, Result};
use tempfile::NamedTempFile;

use crate::{command::Program, root, toolchain};

/// Everything that an image is made of, apart from its job. The versions of other packages stand in
/// the lock file in xtask/firmware.
const SOURCES: [&str; 6] = [
    "Cargo.toml",
    "src",
    "xtask/firmware",
    "xtask/float_port",
    "xtask/frame_hash",
    "examples/small/src/stack.rs",
];

/// The image that is made of `key`, whether it is there or not. Images of older sources are removed.
pub fn place(key: impl Hash) -> Result<PathBuf> {
    let mut hasher = DefaultHasher::new();
    key.hash(&mut hasher);
    Ok(folder()?.join(format!("{:016x}", hasher.finish())))
}

/// Returns the bytes of a program.
pub fn read(program: &Path) -> Result<Vec<u8>> {
    fs::read(program).with_context(|| format!("cannot read {}", program.display()))
}

/// Keeps a program at a place, whole or not at all. Several threads and processes may keep the same.
pub fn keep(program: &[u8], place: &Path) -> Result<()> {
    let cannot = || format!("cannot keep {}", place.display());
    let mut file = NamedTempFile::new_in(folder()?).with_context(cannot)?;
    file.write_all(program).with_context(cannot)?;
    file.persist(place).with_context(cannot)?;
    Ok(())
}

/// The folder of the images of the sources as they are now.
fn folder() -> Result<&'static Path> {
    static FOLDER: OnceLock<PathBuf> = OnceLock::new();
    if let Some(folder) = FOLDER.get() {
        return Ok(folder);
    }
    let all = toolchain::target_directory().join("firmware/images");
    let name = format!("{:016x}", sources()?);
    let folder = all.join(&name);
    fs::create_dir_all(&folder).with_context(|| format!("cannot make {}", folder.display()))?;
    for entry in all.read_dir()?.flatten() {
        if entry.file_name() != *name {
            fs::remove_dir_all(entry.path())?;
        }
    }
    Ok(FOLDER.get_or_init(|| folder))
}

/// A hash of all that firmware is made of, apart from its job, and of the compiler's version.
pub fn sources() -> Result<u64> {
    let mut hasher = DefaultHasher::new();
    let version = Program::new("rustc").args(["-vV"]).read()?;
    version.hash(&mut hasher);
    for path in SOURCES {
        add(&root().join(path), &mut hasher)?;
    }
    Ok(hasher.finish())
}

/// Held while a package is built, so that tests that run side by side build it once.
static BUILD: Mutex<()> = Mutex::new(());

/// Returns a program of a package outside of `xtask` for a target, and builds it if it is not there.
pub fn kept(
    (package, target, program): (&Path, &str, &str),
    build: impl FnOnce() -> Result<PathBuf>,
) -> Result<PathBuf> {
    let mut hasher = DefaultHasher::new();
    add(&root().join(package), &mut hasher)?;
    let image = place((package, target, program, hasher.finish()))?;
    let _one = BUILD.lock().unwrap_or_else(PoisonError::into_inner);
    if !image.is_file() {
        keep(&read(&build()?)?, &image)?;
    }
    Ok(image)
}

/// Adds the content of a file, or of all files of a folder in the order of their names, but for what
/// cargo built in it.
fn add(path: &Path, hasher: &mut impl Hasher) -> Result<()> {
    let unreadable = || format!("cannot read {}", path.display());
    if !path.is_dir() {
        path.strip_prefix(root()).unwrap_or(path).hash(hasher);
        fs::read(path).with_context(unreadable)?.hash(hasher);
        return Ok(());
    }
    let entries = path.read_dir().with_context(unreadable)?.flatten();
    let mut paths: Vec<_> = entries.map(|entry| entry.path()).collect();
    paths.retain(|path| !path.ends_with("target"));
    paths.sort();
    paths.iter().try_for_each(|path| add(path, hasher))
}
