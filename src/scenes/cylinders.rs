//! The built-in scene `cylinders`.

use crate::{Camera, Material, scene};

pub(super) const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.6)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.1);

pub(super) const CAMERA: Camera =
    Camera::look_at([0.0, 3.0, 8.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]).fov(45.0);

scene! {
    /// The scene `cylinders`: three open cylinders with slanting axes under three coloured lights.
    pub struct Cylinders {
        cylinder([-1.5, 1.0, 0.0], [-1.0, 1.0, 1.0], 0.5, 1.5, WHITE);
        cylinder([0.0, 1.0, 0.0], [0.0, 1.0, 1.0], 0.5, 1.5, WHITE);
        cylinder([1.5, 1.0, 0.0], [1.0, 1.0, 1.0], 0.5, 1.5, WHITE);
        light([20.0, 50.0, 0.0], [1.0, 0.4, 0.2]);
        light([50.0, 50.0, 50.0], [0.2, 0.4, 0.9]);
        light([-50.0, 50.0, 50.0], [0.2, 0.8, 0.2]);
        camera(CAMERA);
    }
}
