//! The built-in scene `shading_lights`.

use crate::{Camera, Material, scene};

pub(super) const FLOOR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.2);
const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.9)
    .specular(0.1, 8.0);

pub(super) const CAMERA: Camera =
    Camera::look_at([0.0, -4.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]).fov(70.0);

scene! {
    /// The scene `shading_lights`: one matte sphere between a red and a green light.
    pub struct ShadingLights {
        sphere([0.0, 0.0, 0.0], 1.0, WHITE);
        plane([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], WHITE);
        plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], FLOOR);
        // Green from the right, red from the left.
        light([3.0, 0.0, 3.0], [0.0, 1.0, 0.0]);
        light([-3.0, 0.0, 3.0], [1.0, 0.0, 0.0]);
        camera(CAMERA);
    }
}
