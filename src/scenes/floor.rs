//! The built-in scene `floor`.

use super::cylinders::WHITE;
use crate::{Camera, scene};

pub(super) const CAMERA: Camera =
    Camera::look_at([-2.0, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.75]).fov(75.0);

scene! {
    /// The scene `floor`: one plane without a light, so with ambient light only, seen by a tilted camera.
    pub struct Floor {
        plane([0.0, 0.0, -0.5], [0.0, 0.0, 1.0], WHITE);
        camera(CAMERA);
    }
}
