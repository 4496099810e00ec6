//! The built-in scene `primitives`.

use super::corner1::GREEN;
use super::cylinders::WHITE;
use crate::{Camera, Material, scene};

const MIRROR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.0)
    .diffuse(0.0)
    .specular(0.0, 0.0)
    .mirror(1.0);

pub(super) const CAMERA: Camera =
    Camera::look_at([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).fov(75.0);

scene! {
    /// The scene `primitives`: a room with a mirroring sphere above a low open cylinder. The camera is at
    /// the origin.
    pub struct Primitives {
        sphere([0.0, 1.5, 4.0], 1.0, MIRROR);
        // The floor, two slanting walls and the far end.
        plane([0.0, -1.0, 0.0], [0.0, 1.0, 0.0], WHITE);
        plane([-2.0, -1.0, 0.0], [0.3939193, 0.91914503, 0.0], GREEN);
        plane([2.0, -1.0, 0.0], [0.3939193, -0.91914503, 0.0], GREEN);
        plane([0.0, 0.0, 50.0], [0.0, 0.0, -1.0], GREEN);
        cylinder([0.0, -0.8, 4.0], [0.0, 1.0, 0.0], 1.0, 0.4, GREEN);
        // Red from behind the camera, blue from the left.
        light([3.0, 0.0, -0.5], [1.0, 0.4, 0.2]);
        light([-3.0, -0.8, 3.0], [0.2, 0.4, 0.9]);
        camera(CAMERA);
    }
}
