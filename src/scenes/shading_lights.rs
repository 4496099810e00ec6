//! The built-in scene `shading_lights`.

use super::BuiltIn;
use crate::{Camera, Description, Material, Scene, SceneBuilder, StaticScene};

const FLOOR: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.9)
    .specular(0.1, 4.0)
    .mirror(0.2);
const WHITE: Material = Material::new([0.9, 0.9, 0.9])
    .ambient(0.1)
    .diffuse(0.9)
    .specular(0.1, 8.0);

const CAMERA: Camera =
    Camera::look_at([0.0, -4.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]).fov(70.0);

const BUILDER: SceneBuilder<1, 2, 0, 2, 2> = SceneBuilder::new()
    .sphere([0.0, 0.0, 0.0], 1.0, WHITE)
    .plane([0.0, 4.0, 0.0], [0.0, -1.0, 0.0], WHITE)
    .plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], FLOOR)
    // A green light from the right, and a red one from the left.
    .light([3.0, 0.0, 3.0], [0.0, 1.0, 0.0])
    .light([-3.0, 0.0, 3.0], [1.0, 0.0, 0.0])
    .camera(CAMERA);

/// The scene `shading_lights`: one matte sphere between a red and a green light.
#[derive(Clone, Copy, Debug)]
pub struct ShadingLights;

impl StaticScene for ShadingLights {
    type Scene = Scene<1, 2, 0, 2, 2>;
    const SCENE: &'static Self::Scene = &BUILDER.build();
}

impl BuiltIn for ShadingLights {
    const NAME: &'static str = "shading_lights";
    const CAMERA: Camera = CAMERA;

    fn with_description<R>(read: impl FnOnce(Description<'_>) -> R) -> R {
        read(BUILDER.description())
    }
}
