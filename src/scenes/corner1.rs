//! The built-in scene `corner1`.

use super::BuiltIn;
use crate::{Camera, Description, Material, Scene, SceneBuilder, StaticScene};

const GREEN: Material = Material::new([0.3, 1.0, 0.4])
    .ambient(0.2)
    .diffuse(0.9)
    .specular(0.1, 4.0);

const CAMERA: Camera = Camera::look_at([0.0, 0.5, 0.0], [0.0, 0.5, 1.0], [0.0, 1.0, 0.0]).fov(75.0);

const BUILDER: SceneBuilder<0, 3, 0, 1, 1> = SceneBuilder::new()
    .plane([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], GREEN)
    .plane([0.0, 0.0, 0.0], [0.0, 1.0, 0.0], GREEN)
    .plane([-0.3, 0.0, 0.0], [1.0, 0.0, 0.0], GREEN)
    .light([0.0, 0.0, 0.1], [1.0, 0.4, 0.2])
    .camera(CAMERA);

/// The scene `corner1`: three planes, and a light that lies in two of them. Which surfaces are lit
/// depends on the distance from a surface at which shadow rays start.
#[derive(Clone, Copy, Debug)]
pub struct Corner1;

impl StaticScene for Corner1 {
    type Scene = Scene<0, 3, 0, 1, 1>;
    const SCENE: &'static Self::Scene = &BUILDER.build();
}

impl BuiltIn for Corner1 {
    const NAME: &'static str = "corner1";
    const CAMERA: Camera = CAMERA;

    fn with_description<R>(read: impl FnOnce(Description<'_>) -> R) -> R {
        read(BUILDER.description())
    }
}
