//! Dithers a picture as a display with few levels would show it.

use clap::ValueEnum;
use embedded_graphics::Pixel;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Rgb565, Rgb888};
use embedded_graphics::prelude::{Drawable, PointsIter};
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::display::{Ditherable, dither};

/// Colour formats of the displays that a picture can be dithered for.
#[derive(Clone, Copy, ValueEnum)]
pub enum Levels {
    Rgb565,
    Gray4,
    Gray2,
    Binary,
}

impl Levels {
    /// Replaces the picture by its dithered version, which has only the levels of this format.
    pub fn dither(self, display: &mut SimulatorDisplay<Rgb888>) {
        match self {
            Self::Rgb565 => dither_to::<Rgb565>(display),
            Self::Gray4 => dither_to::<Gray4>(display),
            Self::Gray2 => dither_to::<Gray2>(display),
            Self::Binary => dither_to::<BinaryColor>(display),
        }
    }
}

/// Dithers a picture like `reflet::display::Dithered`. A dot depends only on its colour and its position.
fn dither_to<C: Ditherable + Into<Rgb888>>(display: &mut SimulatorDisplay<Rgb888>) {
    for at in display.bounding_box().points() {
        let dot: C = dither(display.get_pixel(at), at);
        let Ok(()) = Pixel(at, dot.into()).draw(display);
    }
}
