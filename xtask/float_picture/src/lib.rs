//! Draws pictures in single precision, in the form of the reference's pictures: with the float port,
//! which is how a program on a board would be written, and with the reference's own formulas.
#![deny(missing_docs)]
// `prepared.rs` is compiled twice: for the float port's model and for the reference's own settings.
#![allow(clippy::duplicate_mod)]

#[macro_use]
#[path = "../../../src/kinds.rs"]
mod kinds;
#[macro_use]
#[path = "../../../src/host/shapes.rs"]
mod shapes;

pub mod port;
pub mod single;

pub use port::render;
pub use reflet::host::reference::Shading;

use reflet::host::reference::Picture;

/// Returns the picture with these pixels.
fn picture((width, height): (u32, u32), pixel: impl Fn(u32, u32) -> [u8; 3]) -> Picture {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Picture {
        width,
        height,
        pixels: places.map(|(x, y)| pixel(x, y)).collect(),
    }
}
