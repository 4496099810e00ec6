//! Draws a frame of the library into a [`Picture`], the form that `compare` takes. This file knows no
//! scene.

use std::vec;
use std::vec::Vec;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::Size;

use super::reference::Picture;
use crate::accel::any_scene::AnyScene;
use crate::qualities::Quality;
use crate::render::{Rows, Seam};
use crate::shade::Shading;

/// Draws a frame, row by row, and returns it as a [`Picture`] that can be compared with others.
///
/// ```
/// use embedded_graphics::prelude::Size;
/// use reflet::host::painted;
/// use reflet::scenes::{BuiltIn, Empty};
///
/// let frame = Empty::frame(&Empty::CAMERA);
/// let frame = frame.prepare(Size::new(2, 1));
/// let picture = painted(&frame.on(&Empty).unwrap());
/// assert_eq!(picture.pixels.len(), 2);
/// ```
pub fn painted<S: AnyScene, Q: Quality, K: Shading>(rows: &Rows<'_, S, Q, K>) -> Picture {
    let Size { width, height } = rows.size();
    let mut row = vec![Rgb888::BLACK; width as usize];
    let mut seam = Seam::<32>::new(); // for 1024 columns
    let pixels = (0..height).flat_map(|y| {
        rows.next_row(&mut seam, y, 0, &mut row);
        let bytes = row.iter().map(|pixel| [pixel.r(), pixel.g(), pixel.b()]);
        bytes.collect::<Vec<_>>()
    });
    Picture {
        pixels: pixels.collect(),
        width,
        height,
    }
}
