//! One ray to one colour, by the recurrence cⁱ = (1 − αᵢ) cᵢ + αᵢ cⁱ⁺¹; it knows no picture.

use std::vec::Vec;

use super::Shading;
use super::model::{Ray, Scene, Vector};

/// The colour that comes along a ray, before it is clamped.
pub(super) fn color(scene: &Scene, ray: Ray, reflections: u32, shading: Shading) -> Vector {
    match shading {
        Shading::Normals => scene.normal_color(&ray),
        Shading::BlinnPhong | Shading::Phong => light(scene, ray, reflections, shading),
    }
}

/// The recurrence, solved from its end.
///
/// The way out lists the surfaces, the way back combines them, so that a room of mirrors takes
/// memory and never the call stack.
fn light(scene: &Scene, mut ray: Ray, reflections: u32, shading: Shading) -> Vector {
    let mut surfaces = Vec::new();
    let mut end = Vector::ZERO;
    for _ in 0..=reflections {
        let Some(surface) = scene.nearest(&ray) else {
            end = scene.background;
            break;
        };
        let alpha = surface.material.mirror;
        surfaces.push((alpha, scene.own_color(&surface, shading)));
        if alpha == 0.0 {
            break;
        }
        ray = surface.reflected();
    }
    let back = surfaces.into_iter().rev();
    back.fold(end, |next, (alpha, own)| own * (1.0 - alpha) + next * alpha)
}
