//! The built-in scene `columns`.

use super::shading_speculars::SHINY;
use crate::{Camera, Material, scene};

const FLOOR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.5)
    .specular(0.4, 4.0)
    .mirror(0.4);

pub(super) const CAMERA: Camera =
    Camera::look_at([0.0, -8.0, 6.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]).fov(70.0);

scene! {
    /// The scene `columns`: eight columns in a circle on a reflecting floor. One light is inside the circle,
    /// and one is far away to the side.
    pub struct Columns {
        plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], FLOOR);
        // On a circle of radius 3, an eighth of a turn apart.
        cylinder([2.9773350964055805, 0.368070270072946, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        cylinder([1.8450288526113454, 2.3655588204548335, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        cylinder([-0.3680702700729458, 2.9773350964055805, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        cylinder([-2.365558820454834, 1.8450288526113452, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        cylinder([-2.9773350964055805, -0.36807027007294635, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        cylinder([-1.8450288526113452, -2.3655588204548335, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        cylinder([0.3680702700729461, -2.9773350964055805, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        cylinder([2.3655588204548335, -1.8450288526113454, 0.0], [0.0, 0.0, 1.0], 0.25, 4.0, SHINY);
        light([0.0, 1.0, 2.0], [0.0, 0.7, 0.9]);
        light([20.0, -3.0, 0.0], [1.0, 0.2, 0.1]);
        camera(CAMERA);
    }
}
