//! The double-precision reference's own formulas in single precision: its files are compiled once
//! more.
//!
//! Every direction and normal is normalised, and half chords are computed from the distance of a
//! centre from the ray. A picture in `f32` cannot be much better without special techniques.

// Only the functions that follow a ray are called.
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
    let (prepared, view) = (Prepared::new(scene), model::View::new(&camera(eye), size));
    let scene = prepared.scene();
    super::picture(size, |x, y| {
        model::quantised(trace::color(&scene, view.ray(x, y), reflections, shading))
    })
}
