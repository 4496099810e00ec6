//! One row of the panel, in its byte order: what a core traces and the DMA sends.

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{PixelColor, Rgb565, Rgb888};
use embedded_graphics::prelude::IntoStorage;

/// Width and height of the panel in pixels.
pub const SIDE: u32 = 240;

/// Bytes of a row.
pub const ROW: usize = 2 * SIDE as usize;

/// A colour in the panel's byte order.
#[derive(Clone, Copy, PartialEq)]
pub struct Wire(pub [u8; 2]);

impl PixelColor for Wire {
    type Raw = RawU16;
}

impl From<Rgb565> for Wire {
    fn from(color: Rgb565) -> Self {
        Self(color.into_storage().to_be_bytes())
    }
}

impl From<Rgb888> for Wire {
    fn from(color: Rgb888) -> Self {
        Rgb565::from(color).into()
    }
}

/// One row of the panel.
#[derive(Clone, Copy)]
pub struct Line {
    pub bytes: [u8; ROW],
}

impl Line {
    pub const BLACK: Self = Self { bytes: [0; ROW] };

    /// Calls `trace` for the colours of a row, of which each covers `scale` columns: 1 or 2.
    pub fn fill(&mut self, scale: u32, trace: impl FnOnce(&mut [Wire])) {
        let mut colors = [Wire([0; 2]); SIDE as usize];
        let colors = &mut colors[..(SIDE / scale) as usize];
        trace(colors);
        match scale {
            1 => self.spread::<1>(colors),
            _ => self.spread::<2>(colors),
        }
    }

    fn spread<const SCALE: usize>(&mut self, colors: &[Wire]) {
        let columns = self.bytes.chunks_exact_mut(2 * SCALE);
        for (bytes, Wire(color)) in columns.zip(colors) {
            bytes.copy_from_slice([*color; SCALE].as_flattened());
        }
    }
}
