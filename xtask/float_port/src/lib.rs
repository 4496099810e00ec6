//! The model of `reflet` in `f32`, as one would write it without `reflet`: the float side of the
//! comparison in `docs/boards.md`.
//!
//! A fair competitor: the textbook's formulas, no allocation, no recursion, the scene a constant
//! that the optimiser sees through, the core's own instruction for roots where there is one. It
//! uses no trick of `reflet`'s, and nothing is checked.
#![no_std]
#![deny(missing_docs)]

mod camera;
mod float;
mod scene;
mod shade;
mod shape;
mod trace;
mod vector;

pub use camera::{Camera, View};
pub use scene::{Cylinder, Light, Material, Plane, Scene, Sphere};
pub use shade::Shading;
pub use shape::Ray;
pub use vector::Vector;

/// Red, green and blue of what comes along a ray of a [`View`], after at most `reflections`
/// reflections.
#[inline]
pub fn pixel(scene: &Scene, shading: Shading, ray: &Ray, reflections: u32) -> [u8; 3] {
    let color = match shading {
        Shading::Normals => trace::normal(scene, ray),
        shading => trace::color(scene, shading, *ray, reflections),
    };
    [color.x, color.y, color.z].map(|channel| (255.0 * channel.clamp(0.0, 1.0) + 0.5) as u8)
}
