//! What the tests of whole pictures share.

use embedded_graphics::{
    pixelcolor::{Rgb888, RgbColor},
    prelude::Size,
};
use reflet::{Picture, Quality, Shading, World, host::reference};

/// The whole picture, row by row, in the form that pictures are compared in.
pub fn painted<W: World, Q: Quality, K: Shading>(picture: &Picture<W, Q, K>) -> reference::Picture {
    let Size { width, height } = picture.size();
    let mut row = vec![Rgb888::BLACK; width as usize];
    let rows = (0..height).flat_map(|y| {
        picture.row(y, 0, &mut row);
        let bytes = row.iter().map(|pixel| [pixel.r(), pixel.g(), pixel.b()]);
        bytes.collect::<Vec<_>>()
    });
    reference::Picture {
        pixels: rows.collect(),
        width,
        height,
    }
}
