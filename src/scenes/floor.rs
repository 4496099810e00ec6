//! The built-in scene `floor`.

use super::BuiltIn;
use crate::{Camera, Description, Material, Scene, SceneBuilder, StaticScene};

const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.6)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.1);

const CAMERA: Camera =
    Camera::look_at([-2.0, 0.0, 1.0], [0.0, 0.0, 0.0], [1.0, 0.0, 0.75]).fov(75.0);

const BUILDER: SceneBuilder<0, 1, 0, 0, 1> = SceneBuilder::new()
    .plane([0.0, 0.0, -0.5], [0.0, 0.0, 1.0], WHITE)
    .camera(CAMERA);

/// The scene `floor`: one plane without a light, so with ambient light only, seen by a tilted camera.
#[derive(Clone, Copy, Debug)]
pub struct Floor;

impl StaticScene for Floor {
    type Scene = Scene<0, 1, 0, 0, 1>;
    const SCENE: &'static Self::Scene = &BUILDER.build();
}

impl BuiltIn for Floor {
    const NAME: &'static str = "floor";
    const CAMERA: Camera = CAMERA;

    fn with_description<R>(read: impl FnOnce(Description<'_>) -> R) -> R {
        read(BUILDER.description())
    }
}
