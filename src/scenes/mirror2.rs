//! The built-in scene `mirror2`.

use crate::{Camera, Material, scene};

const FLOOR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.2);
const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.2)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.1);
const MIRROR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.0)
    .diffuse(0.0)
    .specular(1.0, 8.0)
    .mirror(0.9);
const RED_PARTICLE: Material = Material::new([0.9, 0.3, 0.1])
    .ambient(0.2)
    .diffuse(0.5)
    .specular(0.9, 10.0)
    .mirror(0.1);
const BLUE_PARTICLE: Material = Material::new([0.1, 0.3, 0.9])
    .ambient(0.2)
    .diffuse(0.5)
    .specular(0.9, 10.0)
    .mirror(0.1);

pub(super) const CAMERA: Camera =
    Camera::look_at([0.5, -2.0, 0.4], [0.5, 0.0, 0.4], [0.0, 0.0, 1.0]).fov(65.0);

scene! {
    /// The scene `mirror2`: the three particles of [`Mirror1`](super::Mirror1) between two plane mirrors.
    pub struct Mirror2 {
        sphere([2.0, 2.0, 0.1], 0.5, RED_PARTICLE);
        sphere([2.0, 4.0, 0.1], 0.5, BLUE_PARTICLE);
        sphere([2.0, 4.0, 2.1], 0.5, RED_PARTICLE);
        plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], FLOOR);
        plane([-5.0, 5.0, 0.0], [-2.0, 1.0, 0.0], MIRROR);
        plane([5.0, 5.0, 0.0], [2.0, 1.0, 0.0], MIRROR);
        // The rods between the particles.
        cylinder([2.0, 3.0, 0.1], [0.0, 1.0, 0.0], 0.1, 2.0, WHITE);
        cylinder([2.0, 4.0, 1.1], [0.0, 0.0, 1.0], 0.1, 2.0, WHITE);
        light([2.5, 2.5, 4.0], [1.0, 0.8, 0.5]);
        light([0.5, -2.5, -0.1], [0.5, 0.8, 1.0]);
        camera(CAMERA);
    }
}
