//! Floor 8: ordered dithering for displays with few levels. It knows colours and where they are
//! shown, and no scene.

mod colors;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics::prelude::PointsIter;
use embedded_graphics::primitives::Rectangle;

use crate::number::{to_u8, unsigned};

/// A display of few levels that takes pictures of many: what is drawn on it is dithered on the way
/// to `D`, by [`dither`].
///
/// A dot depends on its colour and on where it is on `D`, and on nothing else: a picture drawn in
/// parts, or in rows of any order, has the dots of the whole, and all machines have the same ones.
/// Pixels come in the calls in which they are drawn; only what is filled with one colour that lies
/// between two levels comes pixel by pixel, as [`DrawTarget::fill_contiguous`]. Nothing is kept
/// between calls, and the display clips, as it does without this. Errors are the display's own.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::BinaryColor;
/// use reflet::{Camera, Material, scene};
/// use reflet::display::Dithered;
///
/// scene! {
///     struct Ball {
///         sphere([0.0, 0.0, 0.0], 1.0, Material::new([0.9, 0.9, 0.8]));
///         light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
///     }
/// }
/// const CAMERA: Camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
///
/// let mut display = MockDisplay::<BinaryColor>::new();
/// Ball::frame(&CAMERA).draw(&mut Dithered::new(&mut display))?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct Dithered<'a, D> {
    display: &'a mut D,
}

impl<'a, D> Dithered<'a, D>
where
    D: DrawTarget,
    D::Color: Ditherable,
{
    /// Around a display.
    pub fn new(display: &'a mut D) -> Self {
        Self { display }
    }
}

impl<D: Dimensions> Dimensions for Dithered<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.display.bounding_box()
    }
}

impl<D> DrawTarget for Dithered<'_, D>
where
    D: DrawTarget,
    D::Color: Ditherable,
{
    type Color = Rgb888;
    type Error = D::Error;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), D::Error>
    where
        I: IntoIterator<Item = Pixel<Rgb888>>,
    {
        let dots = pixels.into_iter();
        self.display
            .draw_iter(dots.map(|Pixel(at, color)| Pixel(at, dither(color, at))))
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), D::Error>
    where
        I: IntoIterator<Item = Rgb888>,
    {
        let places = area.points().zip(colors);
        self.display
            .fill_contiguous(area, places.map(|(at, color)| dither(color, at)))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb888) -> Result<(), D::Error> {
        let lowest = D::Color::dithered(color, Threshold::LOWEST);
        if lowest == D::Color::dithered(color, Threshold::HIGHEST) {
            return self.display.fill_solid(area, lowest);
        }
        let visible = area.intersection(&self.bounding_box());
        let dots = visible.points().map(|at| dither(color, at));
        self.display.fill_contiguous(&visible, dots)
    }
}

/// The dot that a display of few levels shows for `color` at the point `at` of it.
///
/// This is for rows from [`Rows::row`](crate::Rows::row); for a display there is [`Dithered`]. Each channel
/// becomes one of the two levels beside it: over any 8 x 8 points, equal colours have a mean within
/// half a 64th of a level of the colour's own, and a colour that is a level stays as it is. The
/// pattern repeats every 8 points, through negative coordinates, too. Nothing is corrected for the
/// eye or the panel: the mean is one of levels.
///
/// ```
/// use embedded_graphics::geometry::Point;
/// use embedded_graphics::pixelcolor::{Gray2, GrayColor, Rgb888};
/// use reflet::display::dither;
///
/// // Half way between the levels 1 and 2 of 0 to 3.
/// let row = [Rgb888::new(128, 128, 128); 4];
/// let mut dots = [Gray2::BLACK; 4];
/// for (x, (dot, color)) in dots.iter_mut().zip(row).enumerate() {
///     *dot = dither(color, Point::new(x as i32, 0));
/// }
/// assert_eq!(dots.map(|dot| dot.luma()), [2, 1, 2, 1]);
/// ```
#[inline]
pub fn dither<C: Ditherable>(color: Rgb888, at: Point) -> C {
    C::dithered(color, Threshold::at(at))
}

/// A colour of few levels that others can be dithered to.
///
/// Those of embedded-graphics are, but it has none for displays with, say, 3, 3 and 2 bits. Such a
/// one is made so:
///
/// ```
/// use embedded_graphics::geometry::Point;
/// use embedded_graphics::pixelcolor::{PixelColor, Rgb888, RgbColor, raw::RawU8};
/// use reflet::display::{Ditherable, Threshold, dither};
///
/// #[derive(Clone, Copy, Debug, PartialEq)]
/// struct Rgb332(u8);
///
/// impl PixelColor for Rgb332 {
///     type Raw = RawU8;
/// }
///
/// impl Ditherable for Rgb332 {
///     fn dithered(color: Rgb888, threshold: Threshold) -> Self {
///         let red = threshold.level(color.r(), 7);
///         let green = threshold.level(color.g(), 7);
///         Self(red << 5 | green << 2 | threshold.level(color.b(), 3))
///     }
/// }
///
/// let white: Rgb332 = dither(Rgb888::WHITE, Point::new(5, 7));
/// assert_eq!(white, Rgb332(255));
/// ```
pub trait Ditherable: PixelColor {
    /// Each channel of `color` as one of the two levels beside it.
    ///
    /// A higher threshold never gives a higher level ([`Threshold::level`] sees to that), and
    /// colours for which the lowest and the highest one give the same are taken to be the same at
    /// all others.
    fn dithered(color: Rgb888, threshold: Threshold) -> Self;
}

/// How far above a level a value must lie to be shown as the next one: (2 n + 1) / 128 of the way,
/// where n is the number, 0 to 63, that Bayer's 8 x 8 matrix has for the point.
///
/// B. E. Bayer, "An optimum method for two-level rendition of continuous-tone pictures", IEEE
/// International Conference on Communications, 1973. The matrix is worked out rather than stored:
/// n has the bits of x ^ y and of y in turn, the last bits first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Threshold {
    /// What is left of a level above the threshold, in 255ths, rounded down: 1 to 253.
    rest: u8,
}

impl Threshold {
    const LOWEST: Self = Self::of(63);
    const HIGHEST: Self = Self::of(0);

    /// The one of a point; the same for points that are a multiple of 8 apart in x and in y.
    #[inline]
    pub const fn at(at: Point) -> Self {
        // What stands here for y is its complement, so that the number is 63 - n.
        let (x, y) = (at.x, !at.y);
        let both = x ^ y;
        let first = (both & 1) << 5 | (y & 1) << 4;
        let second = (both & 2) << 2 | (y & 2) << 1;
        let third = (both & 4) >> 1 | (y & 4) >> 2;
        Self::of(unsigned(first | second | third))
    }

    /// From 63 - n.
    #[inline]
    const fn of(complement: u32) -> Self {
        // Levels are compared in whole 255ths, so rounding down changes no comparison.
        let rest = (2 * complement + 1) * 255 / 128;
        Self { rest: to_u8(rest) }
    }

    /// The level, 0 to `largest`, for a channel of 8 bits: floor(`largest` · `value` / 255), or the
    /// next one if the rest is not below the threshold.
    ///
    /// 0 stays 0 and 255 becomes `largest`, whatever the threshold.
    #[inline]
    pub const fn level(self, value: u8, largest: u8) -> u8 {
        let sum = largest as u32 * value as u32 + self.rest as u32;
        // A 255th, rounded down, of anything below 2¹⁶ - 1.
        to_u8((sum + 1 + (sum >> 8)) >> 8)
    }
}
