//! The model of `reflet` in `f32`, as one would write it without `reflet`: the float side of the
//! comparison in `docs/boards.md`.
//!
//! It is a fair competitor: textbook formulas, no allocation, no recursion, a constant scene that
//! the optimiser can use, and the core's own instruction for square roots if there is one. It uses
//! none of `reflet`'s techniques, and checks nothing. The formulas are in files of the reference,
//! which are compiled once more. Only the sum along a path is written here.
#![no_std]
#![deny(missing_docs)]

#[macro_use]
#[path = "../../../src/kinds.rs"]
mod kinds;
#[macro_use]
#[path = "../../../src/host/shapes.rs"]
mod shapes;

#[path = "../../../src/host/reference/model/mod.rs"]
mod model;
mod real;
#[path = "../../../src/host/reference/shading.rs"]
mod shading;

pub use model::*;
pub use shading::Shading;

/// Returns the red, green and blue of a ray of a [`View`], after at most `reflections` reflections.
#[inline]
pub fn pixel(scene: &Scene, shading: Shading, ray: &Ray, reflections: u32) -> [u8; 3] {
    quantised(match shading {
        Shading::Normals => scene.normal_color(ray),
        shading => color(scene, shading, *ray, reflections),
    })
}

/// Follows a ray for at most `reflections` reflections and adds up the colours of its hits by their
/// weights.
#[inline]
fn color(scene: &Scene, shading: Shading, mut ray: Ray, reflections: u32) -> Vector {
    let mut color = Vector::ZERO;
    let mut weight = 1.0;
    for _ in 0..=reflections {
        let Some(surface) = scene.nearest(&ray) else {
            return color + scene.beyond(ray.direction) * weight;
        };
        let mirror = surface.material.mirror;
        if mirror < 1.0 {
            color += scene.own_color(&surface, shading) * (weight * (1.0 - mirror));
        }
        weight *= mirror;
        if weight == 0.0 {
            break;
        }
        ray = surface.reflected();
    }
    color
}
