//! The built-in scene `mirror2`. Materials and camera are those of `mirror1`.

pub(super) use super::mirror1::CAMERA;
use super::mirror1::{BLUE_PARTICLE, FLOOR, MIRROR, RED_PARTICLE, WHITE};
use crate::scene;

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
