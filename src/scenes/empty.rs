//! The built-in scene `empty`.

use crate::{Camera, scene};

pub(super) const CAMERA: Camera =
    Camera::look_at([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).fov(75.0);

scene! {
    /// The scene `empty`: one light and no shapes, so every pixel is the background.
    pub struct Empty {
        light([0.0, 0.0, 0.1], [1.0, 0.4, 0.2]);
        camera(CAMERA);
    }
}
