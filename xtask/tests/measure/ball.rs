//! The scene `ball`, written from a scene file by `cargo xtask scene`.

use reflet::{Camera, Material, scene};

const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .ambient(0.2)
    .diffuse(0.4)
    .specular(0.8, 4.0)
    .mirror(0.4);

/// The view the scene was made for.
pub const CAMERA: Camera =
    Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).fov(50.0);

scene! {
    /// The scene `ball`.
    pub struct Ball {
        sphere([0.0, 0.0, 1.0], 1.0, GOLD);
        plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], GOLD);
        cylinder([2.0, 0.0, 1.0], [0.0, 0.0, 1.0], 0.5, 0.2, GOLD);
        disc([2.0, 0.0, 1.1], [0.0, 0.0, 1.0], 0.5, GOLD);
        light([3.0, -4.0, 6.125], [1.0, 1.0, 1.0]);
        background([0.25, 0.5, 1.0]);
        epsilon(0.0005);
        camera(CAMERA);
    }
}
