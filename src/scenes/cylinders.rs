//! The built-in scene `cylinders`.

use super::BuiltIn;
use crate::{Camera, Description, Material, Scene, SceneBuilder, StaticScene};

const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.6)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.1);

const CAMERA: Camera = Camera::look_at([0.0, 3.0, 8.0], [0.0, 1.0, 0.0], [0.0, 1.0, 0.0]).fov(45.0);

const BUILDER: SceneBuilder<0, 0, 3, 3, 1> = SceneBuilder::new()
    .cylinder([-1.5, 1.0, 0.0], [-1.0, 1.0, 1.0], 0.5, 1.5, WHITE)
    .cylinder([0.0, 1.0, 0.0], [0.0, 1.0, 1.0], 0.5, 1.5, WHITE)
    .cylinder([1.5, 1.0, 0.0], [1.0, 1.0, 1.0], 0.5, 1.5, WHITE)
    .light([20.0, 50.0, 0.0], [1.0, 0.4, 0.2])
    .light([50.0, 50.0, 50.0], [0.2, 0.4, 0.9])
    .light([-50.0, 50.0, 50.0], [0.2, 0.8, 0.2])
    .camera(CAMERA);

/// The scene `cylinders`: three open cylinders with slanting axes under three coloured lights.
#[derive(Clone, Copy, Debug)]
pub struct Cylinders;

impl StaticScene for Cylinders {
    type Scene = Scene<0, 0, 3, 3, 1>;
    const SCENE: &'static Self::Scene = &BUILDER.build();
}

impl BuiltIn for Cylinders {
    const NAME: &'static str = "cylinders";
    const CAMERA: Camera = CAMERA;

    fn with_description<R>(read: impl FnOnce(Description<'_>) -> R) -> R {
        read(BUILDER.description())
    }
}
