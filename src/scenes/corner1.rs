//! The built-in scene `corner1`.

use crate::{Camera, Material, scene};

pub(super) const GREEN: Material = Material::new([0.3, 1.0, 0.4])
    .ambient(0.2)
    .diffuse(0.9)
    .specular(0.1, 4.0);

pub(super) const CAMERA: Camera =
    Camera::look_at([0.0, 0.5, 0.0], [0.0, 0.5, 1.0], [0.0, 1.0, 0.0]).fov(75.0);

scene! {
    /// The scene `corner1`: three planes, and a light that lies in two of them. Which surfaces are lit
    /// depends on the distance from a surface at which shadow rays start.
    pub struct Corner1 {
        plane([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], GREEN);
        plane([0.0, 0.0, 0.0], [0.0, 1.0, 0.0], GREEN);
        plane([-0.3, 0.0, 0.0], [1.0, 0.0, 0.0], GREEN);
        light([0.0, 0.0, 0.1], [1.0, 0.4, 0.2]);
        camera(CAMERA);
    }
}
