//! The built-in scene `mirror1`.

use crate::{Camera, Material, scene};

pub(super) const FLOOR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.2);
pub(super) const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.2)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.1);
pub(super) const MIRROR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.0)
    .diffuse(0.0)
    .specular(1.0, 8.0)
    .mirror(0.9);
pub(super) const RED_PARTICLE: Material = Material::new([0.9, 0.3, 0.1])
    .ambient(0.2)
    .diffuse(0.5)
    .specular(0.9, 10.0)
    .mirror(0.1);
pub(super) const BLUE_PARTICLE: Material = Material::new([0.1, 0.3, 0.9])
    .ambient(0.2)
    .diffuse(0.5)
    .specular(0.9, 10.0)
    .mirror(0.1);

pub(super) const CAMERA: Camera =
    Camera::look_at([0.5, -2.0, 0.4], [0.5, 0.0, 0.4], [0.0, 0.0, 1.0]).fov(65.0);

scene! {
    /// The scene `mirror1`: three spheres joined by rods, beside a cylinder that is a mirror.
    pub struct Mirror1 {
        sphere([2.0, 2.0, 0.1], 0.5, RED_PARTICLE);
        sphere([2.0, 4.0, 0.1], 0.5, BLUE_PARTICLE);
        sphere([2.0, 4.0, 2.1], 0.5, RED_PARTICLE);
        plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], FLOOR);
        cylinder([-2.0, 4.0, 0.0], [0.0, 0.0, 1.0], 2.0, 4.0, MIRROR);
        // The rods between the particles.
        cylinder([2.0, 3.0, 0.1], [0.0, 1.0, 0.0], 0.1, 2.0, WHITE);
        cylinder([2.0, 4.0, 1.1], [0.0, 0.0, 1.0], 0.1, 2.0, WHITE);
        light([2.5, 2.5, 4.0], [1.0, 0.8, 0.5]);
        light([0.5, -2.5, -0.1], [0.5, 0.8, 1.0]);
        camera(CAMERA);
    }
}
