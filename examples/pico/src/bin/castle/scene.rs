//! The scene that the board draws. `cargo xtask scene FILE.json > scene.rs` in the repository
//! writes one of yours over this file; then put its name into the line with `Shown` in `main.rs`.

use reflet::Camera;
use reflet::scenes::BuiltIn;
pub use reflet::scenes::Castle;

/// Camera of the first picture.
pub const CAMERA: Camera = Castle::CAMERA;
