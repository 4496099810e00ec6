//! Draws a frame of the library into a [`Picture`], the form that `compare` takes. This file knows no
//! scene.

use std::vec;
use std::vec::Vec;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::Size;

use super::reference::Picture;
use crate::accel::World;
use crate::render::Quality;
use crate::shade::Shading;

/// Draws a frame, row by row, and returns it as a [`Picture`] that can be compared with others.
///
/// ```
/// use embedded_graphics::prelude::Size;
/// use reflet::StaticFrame;
/// use reflet::host::painted;
/// use reflet::scenes::{BuiltIn, Empty};
///
/// let frame = Empty::frame(&Empty::CAMERA);
/// let picture = painted(&frame.sized(Size::new(2, 1)));
/// assert_eq!(picture.pixels.len(), 2);
/// ```
pub fn painted<W: World, Q: Quality, K: Shading>(
    picture: &crate::render::Picture<W, Q, K>,
) -> Picture {
    let Size { width, height } = picture.size();
    let mut row = vec![Rgb888::BLACK; width as usize];
    let rows = (0..height).flat_map(|y| {
        picture.row(y, 0, &mut row);
        let bytes = row.iter().map(|pixel| [pixel.r(), pixel.g(), pixel.b()]);
        bytes.collect::<Vec<_>>()
    });
    Picture {
        pixels: rows.collect(),
        width,
        height,
    }
}
