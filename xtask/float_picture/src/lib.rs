//! Pictures in single precision, in the form that the reference's are compared in: of the float port,
//! as a program on a board would be written, and of the reference's own formulas.
#![deny(missing_docs)]
// Scenes are made ready for two models: that of the port and that with the reference's own settings.
#![allow(clippy::duplicate_mod)]

#[macro_use]
#[path = "../../../src/kinds.rs"]
mod kinds;
#[macro_use]
#[path = "../../../src/host/shapes.rs"]
mod shapes;

pub mod accuracy;
pub mod port;
pub mod single;

pub use port::render;
pub use reflet::host::reference::Shading;

use reflet::host::reference::Picture;

/// The picture of these pixels.
fn picture((width, height): (u32, u32), pixel: impl Fn(u32, u32) -> [u8; 3]) -> Picture {
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Picture {
        width,
        height,
        pixels: places.map(|(x, y)| pixel(x, y)).collect(),
    }
}
