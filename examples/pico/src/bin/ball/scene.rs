//! The scene `harbour`, written from a scene file by `cargo xtask scene`.

use reflet::{Camera, Material, scene};

const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .ambient(0.2)
    .diffuse(0.4)
    .specular(0.8, 4.0)
    .mirror(0.4);
const WATER: Material = Material::new([0.6, 0.8, 1.0])
    .ambient(0.2)
    .diffuse(0.1)
    .specular(0.0, 1.0)
    .mirror(0.7);

/// The view the scene was made for.
pub const CAMERA: Camera =
    Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).fov(50.0);

scene! {
    /// The scene `harbour`.
    pub struct Harbour {
        sphere([0.0, 0.0, 1.0], 1.0, GOLD);
        plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER);
        light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
        background([0.3, 0.4, 0.6]);
        camera(CAMERA);
    }
}
