//! What the tests have in common: firmware that is built once, and the desk's picture.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use boards::{Picture, SIDE};
use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::Camera;
use reflet::scenes::BuiltIn;

/// A package of firmware: its folder from the root of the repository, and its target.
pub struct Package {
    folder: &'static str,
    target: &'static str,
    built: OnceLock<PathBuf>,
}

impl Package {
    pub const fn new(folder: &'static str, target: &'static str) -> Self {
        let built = OnceLock::new();
        Self {
            folder,
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
            place.join(self.target).join("release").join(name)
        })
    }
}

/// Returns the picture on the desk.
pub fn simulated<S: BuiltIn>(camera: &Camera) -> Vec<u16> {
    let size = Size::new(SIDE as u32, SIDE as u32);
    let mut display = SimulatorDisplay::<Rgb565>::new(size);
    S::frame(camera).draw(&mut display).unwrap();
    let bytes = display.to_be_bytes();
    let pixels = bytes.chunks_exact(2);
    pixels
        .map(|it| u16::from_be_bytes([it[0], it[1]]))
        .collect()
}

/// Returns the number of pixels that differ.
pub fn different(shown: &Picture, expected: &[u16]) -> usize {
    assert_eq!(shown.pixels.len(), expected.len());
    let pairs = shown.pixels.iter().zip(expected);
    pairs.filter(|(shown, expected)| shown != expected).count()
}
