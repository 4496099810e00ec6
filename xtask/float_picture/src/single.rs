//! The double-precision reference's own formulas, in single precision: its files, compiled once more.
//!
//! Every direction and normal is brought back to length one, and half chords are taken from the
//! distance of a centre from the ray: as good as a picture in `f32` can be without cleverness.

// Only what follows a ray is called.
#![allow(dead_code, unused_imports)]

#[path = "../../../src/host/reference/model/mod.rs"]
mod model;
#[path = "../../../src/host/reference/prepared.rs"]
mod prepared;
#[path = "../../../src/host/reference/real.rs"]
mod real;
#[path = "../../../src/host/reference/trace.rs"]
mod trace;

use reflet::host::reference::*;

use self::prepared::{Prepared, camera};

/// What is computed in.
type Real = f32;

/// The picture of a scene, every number of which is the nearest `f32`.
pub fn render(
    scene: &Scene,
    eye: &Camera,
    size: (u32, u32),
    reflections: u32,
    shading: Shading,
) -> Picture {
    let (prepared, view) = (Prepared::new(scene), model::View::new(&camera(eye), size));
    let scene = prepared.scene();
    super::picture(size, |x, y| {
        model::quantised(trace::color(&scene, view.ray(x, y), reflections, shading))
    })
}
