//! The built-in scene `empty`.

use super::BuiltIn;
use crate::{Camera, scene};

const CAMERA: Camera = Camera::look_at([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).fov(75.0);

scene! {
    /// The scene `empty`: one light and no shapes, so every pixel is the background.
    pub struct Empty {
        light([0.0, 0.0, 0.1], [1.0, 0.4, 0.2]);
        camera(CAMERA);
    }
}

impl BuiltIn for Empty {
    const NAME: &'static str = "empty";
    const CAMERA: Camera = CAMERA;
}
