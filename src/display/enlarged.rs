//! Floor 8: a draw target with fewer and larger pixels than its display.

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::primitives::Rectangle;

use crate::number::signed;

/// A draw target that shows each pixel as a square of `scale` by `scale` pixels of a display.
///
/// A picture drawn on it takes about 1/`scale`² of the work. Its top left corner is (0, 0). If a side of
/// the display is no multiple of `scale`, the last column or row reaches beyond the display's edge and
/// is clipped: the picture then lies up to half a large pixel further right or down. There is no buffer:
/// each pixel is one `fill_solid` of the display. Behind a bus this takes more commands than drawing a
/// whole row at once.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
/// use embedded_graphics::prelude::*;
/// use reflet::scenes::{BuiltIn, Floor};
/// use reflet::display::Enlarged;
///
/// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
/// Floor::frame(&Floor::CAMERA).draw(&mut Enlarged::new(&mut display, 4)).unwrap();
/// assert_eq!(display.get_pixel(Point::new(0, 60)), display.get_pixel(Point::new(3, 63)));
///
/// let size = Enlarged::<MockDisplay<Rgb888>>::size_of(Size::new(65, 64), 4);
/// assert_eq!(size, Size::new(17, 16));
/// ```
#[derive(Debug)]
pub struct Enlarged<'a, D> {
    display: &'a mut D,
    scale: u32,
}

impl<'a, D: DrawTarget> Enlarged<'a, D> {
    /// Creates a target that shows each pixel as `scale` by `scale` pixels of `display`. `scale` is
    /// clamped to 1 to 2³⁰.
    pub fn new(display: &'a mut D, scale: u32) -> Self {
        let scale = scale.clamp(1, 1 << 30);
        Self { display, scale }
    }

    /// Returns the size of the target in its own pixels, for a display of this size, rounded up. A
    /// `scale` of 0 counts as 1.
    pub fn size_of(size: Size, scale: u32) -> Size {
        let scale = scale.max(1);
        Size::new(size.width.div_ceil(scale), size.height.div_ceil(scale))
    }
}

impl<D: DrawTarget> Dimensions for Enlarged<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        let size = self.display.bounding_box().size;
        Rectangle::new(Point::zero(), Self::size_of(size, self.scale))
    }
}

impl<D: DrawTarget> DrawTarget for Enlarged<'_, D> {
    type Color = D::Color;
    type Error = D::Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), D::Error>
    where
        I: IntoIterator<Item = Pixel<D::Color>>,
    {
        let (own, bounds) = (self.bounding_box(), self.display.bounding_box());
        let side = Size::new_equal(self.scale);
        for Pixel(at, color) in pixels {
            if !own.contains(at) {
                continue;
            }
            let at = bounds.top_left + at * signed(self.scale);
            let square = Rectangle::new(at, side).intersection(&bounds);
            self.display.fill_solid(&square, color)?;
        }
        Ok(())
    }
}
