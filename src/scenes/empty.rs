//! The built-in scene `empty`.

use super::BuiltIn;
use crate::{Camera, Description, Scene, SceneBuilder, StaticScene};

const CAMERA: Camera = Camera::look_at([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).fov(75.0);

const BUILDER: SceneBuilder<0, 0, 0, 1, 0> = SceneBuilder::new()
    .light([0.0, 0.0, 0.1], [1.0, 0.4, 0.2])
    .camera(CAMERA);

/// The scene `empty`: one light and no shapes, so every pixel is the background.
#[derive(Clone, Copy, Debug)]
pub struct Empty;

impl StaticScene for Empty {
    type Scene = Scene<0, 0, 0, 1, 0>;
    const SCENE: &'static Self::Scene = &BUILDER.build();
}

impl BuiltIn for Empty {
    const NAME: &'static str = "empty";
    const CAMERA: Camera = CAMERA;

    fn with_description<R>(read: impl FnOnce(Description<'_>) -> R) -> R {
        read(BUILDER.description())
    }
}
