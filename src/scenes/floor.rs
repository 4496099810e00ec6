//! The built-in scene `floor`.

use crate::{Camera, Material, scene};

const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.6)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.1);

pub(super) const CAMERA: Camera =
    Camera::look_at([-2.0, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.75]).fov(75.0);

scene! {
    /// The scene `floor`: one plane without a light, so with ambient light only, seen by a tilted camera.
    pub struct Floor {
        plane([0.0, 0.0, -0.5], [0.0, 0.0, 1.0], WHITE);
        camera(CAMERA);
    }
}
