//! The built-in scene `shading_speculars`.

pub(super) use super::shading_lights::CAMERA;
use super::shading_lights::FLOOR;
use crate::{Material, scene};

const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.9)
    .specular(0.1, 2.0);
pub(super) const SHINY: Material = Material::new([0.9, 0.3, 0.1])
    .ambient(0.1)
    .diffuse(0.3)
    .specular(0.9, 10.0)
    .mirror(0.2);

scene! {
    /// The scene `shading_speculars`: matte and shiny spheres and cylinders around one light.
    pub struct ShadingSpeculars {
        sphere([2.0, 0.0, 0.1], 0.6, WHITE);
        sphere([-2.0, 0.0, 0.1], 0.6, SHINY);
        plane([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], WHITE);
        plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], FLOOR);
        // Two pipes along x, above the spheres.
        cylinder([2.0, 0.0, 2.0], [1.0, 0.0, 0.0], 0.5, 4.0, SHINY);
        cylinder([-2.0, 0.0, 2.0], [1.0, 0.0, 0.0], 0.6, 4.0, WHITE);
        light([0.0, 0.0, 0.0], [1.0, 0.9, 0.5]);
        camera(CAMERA);
    }
}
