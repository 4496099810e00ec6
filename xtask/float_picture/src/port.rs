//! Draws pictures with the float port: the program of a board in single precision.

#[path = "../../../src/host/reference/prepared.rs"]
mod prepared;

use float_port as model;
use reflet::host::reference::*;

pub use self::prepared::{Prepared, camera};

/// Number type of all computations.
type Real = f32;

/// Draws a scene whose numbers are rounded to the nearest `f32`.
pub fn render(
    scene: &Scene,
    eye: &Camera,
    size: (u32, u32),
    reflections: u32,
    shading: Shading,
) -> Picture {
    let shading = match shading {
        Shading::BlinnPhong => model::Shading::BlinnPhong,
        Shading::Phong => model::Shading::Phong,
        Shading::Normals => model::Shading::Normals,
    };
    let (prepared, view) = (Prepared::new(scene), model::View::new(&camera(eye), size));
    let scene = prepared.scene();
    super::picture(size, |x, y| {
        model::pixel(&scene, shading, &view.ray(x, y), reflections)
    })
}
