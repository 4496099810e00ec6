//! One row of the panel, in its byte order: what a core traces and the DMA sends.

use core::convert::Infallible;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};

/// Width and height of the panel in pixels.
pub const SIDE: u32 = 240;

/// Bytes of a row.
pub const ROW: usize = 2 * SIDE as usize;

/// One row of pixels. As a target it has one row, too.
#[derive(Clone, Copy)]
pub struct Line {
    pub bytes: [u8; ROW],
}

impl Line {
    pub const BLACK: Self = Self { bytes: [0; ROW] };
}

impl OriginDimensions for Line {
    fn size(&self) -> Size {
        Size::new(SIDE, 1)
    }
}

impl DrawTarget for Line {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        for Pixel(at, color) in pixels {
            if let Some(bytes) = self.bytes.get_mut(2 * at.x as usize..) {
                put(bytes, [color]);
            }
        }
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        let bytes = self.bytes.get_mut(2 * area.top_left.x as usize..);
        put(bytes.unwrap_or_default(), colors);
        Ok(())
    }
}

/// Writes colours in the panel's byte order.
pub fn put(bytes: &mut [u8], colors: impl IntoIterator<Item = Rgb565>) {
    for (bytes, color) in bytes.chunks_exact_mut(2).zip(colors) {
        bytes.copy_from_slice(&color.into_storage().to_be_bytes());
    }
}
