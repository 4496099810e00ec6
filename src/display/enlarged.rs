//! Floor 8: a display seen as one with fewer and larger pixels.

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::primitives::Rectangle;

use crate::number::signed;

/// A display of which a square of `scale` by `scale` pixels is drawn as one.
///
/// A picture drawn on it takes about 1/`scale`² of the work. Its top left corner is (0, 0); where
/// the display's sides are no multiples of `scale`, the last column and row reach beyond its edge,
/// and so much of them is left out. There is no buffer: each pixel is one `fill_solid` of the
/// display, which costs a display behind a bus more commands than a whole row does.
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
/// ```
#[derive(Debug)]
pub struct Enlarged<'a, D> {
    display: &'a mut D,
    scale: u32,
}

impl<'a, D: DrawTarget> Enlarged<'a, D> {
    /// A display with pixels of this size; 0 is taken for 1, and more than 2³⁰ for 2³⁰.
    pub fn new(display: &'a mut D, scale: u32) -> Self {
        let scale = scale.clamp(1, 1 << 30);
        Self { display, scale }
    }

    /// How many of its pixels a display of this size is high and wide.
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
