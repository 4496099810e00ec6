//! Firmware for the tests, which is built once.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

/// A program of a package: the package's folder from the root of the repository, and its target.
pub struct Package {
    folder: &'static str,
    program: &'static str,
    target: &'static str,
    built: OnceLock<PathBuf>,
}

impl Package {
    pub const fn new(folder: &'static str, program: &'static str, target: &'static str) -> Self {
        let built = OnceLock::new();
        Self {
            folder,
            program,
            target,
            built,
        }
    }

    /// Builds the package as its README tells, and returns the path of the program.
    pub fn path(&self) -> &Path {
        self.built.get_or_init(|| {
            let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
            let name = self.folder.rsplit('/').next().unwrap();
            let place = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
            let cargo = Command::new(env!("CARGO"))
                .args(["build", "--release", "--locked", "--target-dir"])
                .arg(&place)
                .current_dir(root.join(self.folder))
                .status();
            assert!(cargo.unwrap().success(), "{name} cannot be built");
            let place = place.join(self.target).join("release");
            place.join(self.program)
        })
    }
}
