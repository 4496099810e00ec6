//! One ray to one colour, by the recurrence cⁱ = (1 − αᵢ) cᵢ + αᵢ cⁱ⁺¹; it knows no picture.

use std::vec::Vec;

use super::shade::{Gleam, blinn_phong, own_color, phong};
use super::shape::Ray;
use super::vector::Vector;
use super::world::World;
use super::{Real, Shading};

/// What the normals view shows where nothing is met.
const BLUE: Vector = Vector([0.0, 0.0, 1.0]);

/// The colour that comes along a ray, before it is clamped.
pub(super) fn color(world: &World, ray: Ray, reflections: u32, shading: Shading) -> Vector {
    match shading {
        Shading::BlinnPhong => light(world, ray, reflections, blinn_phong),
        Shading::Phong => light(world, ray, reflections, phong),
        Shading::Normals => normal(world, &ray),
    }
}

/// How highlights are found; the normals view has none.
pub(super) fn gleam(shading: Shading) -> Gleam {
    match shading {
        Shading::Phong => phong,
        Shading::BlinnPhong | Shading::Normals => blinn_phong,
    }
}

fn normal(world: &World, ray: &Ray) -> Vector {
    let half = |normal| (normal + Vector::grey(1.0)) * 0.5;
    world
        .nearest(ray)
        .map_or(BLUE, |surface| half(surface.normal))
}

/// The recurrence, solved from its end.
///
/// The way out lists the surfaces, the way back combines them, so that a room of mirrors takes
/// memory and never the call stack.
fn light(world: &World, mut ray: Ray, reflections: u32, gleam: Gleam) -> Vector {
    let mut surfaces = Vec::new();
    let mut end = Vector::ZERO;
    for _ in 0..=reflections {
        let Some(surface) = world.nearest(&ray) else {
            end = Vector::of(world.scene.background);
            break;
        };
        let alpha = surface.material.mirror as Real;
        surfaces.push((alpha, own_color(world, &surface, gleam)));
        if alpha == 0.0 {
            break;
        }
        ray = surface.reflected();
    }
    let back = surfaces.into_iter().rev();
    back.fold(end, |next, (alpha, own)| own * (1.0 - alpha) + next * alpha)
}
