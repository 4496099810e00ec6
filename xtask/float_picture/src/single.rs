//! The double-precision reference's own formulas, in single precision: its files, compiled once more.
//!
//! Every direction and normal is brought back to length one, and half chords are taken from the
//! distance of a centre from the ray: as good as a picture in `f32` can be without cleverness.

// Only what follows a ray is called.
#![allow(dead_code)]

#[path = "../../../src/host/reference/shade.rs"]
mod shade;
#[path = "../../../src/host/reference/shape.rs"]
mod shape;
#[path = "../../../src/host/reference/trace.rs"]
mod trace;
#[path = "../../../src/host/reference/vector.rs"]
mod vector;
#[path = "../../../src/host/reference/view.rs"]
mod view;
#[path = "../../../src/host/reference/world.rs"]
mod world;

use reflet::host::reference::{Camera, Picture, Scene, Shading};

use self::view::View;
use self::world::World;

/// What is computed in.
type Real = f32;

mod scene {
    pub use reflet::host::reference::{Cylinder, Light, Material, Plane, Scene, Sphere};
}

/// The picture of a scene, every number of which is the nearest `f32`.
pub fn render(
    scene: &Scene,
    camera: &Camera,
    (width, height): (u32, u32),
    reflections: u32,
    shading: Shading,
) -> Picture {
    let world = World::new(scene);
    let view = View::new(camera, width, height);
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels = places.map(|(x, y)| {
        vector::quantised(trace::color(&world, view.ray(x, y), reflections, shading))
    });
    Picture {
        width,
        height,
        pixels: pixels.collect(),
    }
}
