//! Floor 8: ordered dithering for displays with few levels per channel. This file knows colours and
//! their positions on a display, and no scene.

mod colors;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics::prelude::PointsIter;
use embedded_graphics::primitives::Rectangle;

use crate::number::{to_u8, unsigned};

/// A draw target for a display `D` with few levels per channel: dithers 24-bit colours with [`dither`]
/// and draws them on `D`.
///
/// A dithered pixel depends only on its colour and its position on `D`. So a picture drawn in parts, or
/// in rows of any order, equals the picture drawn at once, on every machine. Each call is passed on as
/// the same call of `D`. Only an area filled with one colour between two levels becomes a call of
/// [`DrawTarget::fill_contiguous`]. Nothing is stored between calls. `D` clips, and errors are those of
/// `D`.
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

impl<'a, D: DrawTarget<Color: Ditherable>> Dithered<'a, D> {
    /// Creates a dithering draw target for `display`.
    pub fn new(display: &'a mut D) -> Self {
        Self { display }
    }
}

impl<D: Dimensions> Dimensions for Dithered<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.display.bounding_box()
    }
}

impl<D: DrawTarget<Color: Ditherable>> DrawTarget for Dithered<'_, D> {
    type Color = Rgb888;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(
        &mut self,
        pixels: I,
    ) -> Result<(), D::Error> {
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

/// Returns the colour that a display with few levels per channel shows for `color` at the point `at`.
///
/// Use it for rows from [`Rows::row`](crate::Rows::row), and [`Dithered`] for a display. Each channel
/// becomes one of the two levels around it. A colour that is a level stays unchanged. An area of one
/// colour has, in any 8 x 8 points, a mean within half a 64th of a level of that colour. The pattern
/// repeats every 8 points, through negative coordinates, too. The mean is a mean of levels: nothing is
/// corrected for the eye or the panel.
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

/// A colour type with few levels per channel, to which 24-bit colours can be dithered.
///
/// The colour types of embedded-graphics implement it. A type of your own, for a display with 3 bits for
/// red and green and 2 bits for blue, implements it like this:
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
    /// Returns `color` with each channel as one of the two levels around it, chosen by the threshold.
    ///
    /// A higher threshold must not give a higher level; [`Threshold::level`] has this property. If the
    /// lowest and the highest threshold give the same result for a colour, [`Dithered`] uses it for all
    /// thresholds.
    fn dithered(color: Rgb888, threshold: Threshold) -> Self;
}

/// The threshold of a point: how far a value must lie above a level to be shown as the next level.
///
/// The threshold is (2 n + 1) / 128 of the distance between two levels, where n, 0 to 63, is the number
/// of the point in Bayer's 8 x 8 matrix (B. E. Bayer, "An optimum method for two-level rendition of
/// continuous-tone pictures", IEEE International Conference on Communications, 1973). The matrix is
/// computed, not stored: n has the bits of x ^ y and of y in turn, the last bits first.
///
/// ```
/// use embedded_graphics::geometry::Point;
/// use reflet::display::Threshold;
///
/// // Two levels: 100 of 255 lies above the threshold of one point and below that of its neighbour.
/// let levels = [0, 1].map(|x| Threshold::at(Point::new(x, 0)).level(100, 1));
/// assert_eq!(levels, [1, 0]);
/// assert_eq!(Threshold::at(Point::new(3, -5)), Threshold::at(Point::new(11, 3)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Threshold {
    /// One level minus the threshold, in 255ths of a level, rounded down: 1 to 253.
    rest: u8,
}

impl Threshold {
    const LOWEST: Self = Self::of(63);
    const HIGHEST: Self = Self::of(0);

    /// Returns the threshold of a point. It repeats every 8 points in x and in y.
    #[inline]
    pub const fn at(at: Point) -> Self {
        // `y` is the complement of the point's y, so that the resulting number is 63 - n.
        let (x, y) = (at.x, !at.y);
        let both = x ^ y;
        let first = (both & 1) << 5 | (y & 1) << 4;
        let second = (both & 2) << 2 | (y & 2) << 1;
        let third = (both & 4) >> 1 | (y & 4) >> 2;
        Self::of(unsigned(first | second | third))
    }

    /// Creates a threshold from 63 - n, where n is the number in Bayer's matrix.
    #[inline]
    const fn of(complement: u32) -> Self {
        // Levels are compared in whole 255ths, so rounding down changes no comparison.
        let rest = (2 * complement + 1) * 255 / 128;
        Self { rest: to_u8(rest) }
    }

    /// Returns the level, 0 to `largest`, of an 8-bit channel: floor(`largest` · `value` / 255), or the
    /// next level if the fraction is not below the threshold.
    ///
    /// With every threshold, 0 stays 0 and 255 becomes `largest`.
    #[inline]
    pub const fn level(self, value: u8, largest: u8) -> u8 {
        let sum = largest as u32 * value as u32 + self.rest as u32;
        // Divides by 255, rounded down; exact for any `sum` below 2¹⁶ - 1.
        to_u8((sum + 1 + (sum >> 8)) >> 8)
    }
}
