//! Computes the colour along one ray by the recurrence cⁱ = (1 − αᵢ) cᵢ + αᵢ cⁱ⁺¹. This file knows no
//! picture.

use std::vec::Vec;

use super::Shading;
use super::model::{Ray, Scene, Vector};

/// Returns the linear colour that arrives along a ray, before it is clamped to 0 to 1.
pub(super) fn color(scene: &Scene, ray: Ray, reflections: u32, shading: Shading) -> Vector {
    match shading {
        Shading::Normals => scene.normal_color(&ray),
        Shading::BlinnPhong | Shading::Phong => light(scene, ray, reflections, shading),
    }
}

/// Returns the colour along a ray under lights and mirrors: evaluates the recurrence from its last term.
///
/// The first loop collects the surfaces along the path, and a fold over the reversed list combines their
/// colours. So a room of mirrors takes heap memory and never overflows the call stack.
fn light(scene: &Scene, mut ray: Ray, reflections: u32, shading: Shading) -> Vector {
    let mut surfaces = Vec::new();
    let mut end = Vector::ZERO;
    for _ in 0..=reflections {
        let Some(surface) = scene.nearest(&ray) else {
            end = scene.beyond(ray.direction);
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
