//! Draws on displays: dithering, larger pixels, the coarse pass of a still picture, and the functions that
//! draw frames and rows.
//!
//! Floor 8, the only one that names embedded-graphics. It knows no ray.

mod areas;
mod bound;
pub(crate) mod budget;
mod coarse;
mod dither;
mod enlarged;

pub use crate::accel::BoundedShape;
pub use crate::accel::any_scene::AnyScene;
pub use areas::Areas;
pub use coarse::coarse_first;
pub use dither::{Ditherable, Dithered, Threshold, dither};
pub use enlarged::Enlarged;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::transform::Transform;

use crate::color::Sum;
use crate::number::unsigned;
use crate::qualities::Quality;
use crate::render::{Buffer, FrameBuilder, PreparedFrame, Report, Rows, Seam};
use crate::shade::Shading;

/// Widest picture with smooth edges of which [`Rows::draw_area`] keeps what a row leaves to the next one, in parts of 32
/// columns.
const WIDEST: usize = 10;

impl<S: AnyScene, Q: Quality, K: Shading> FrameBuilder<'_, S, Q, K> {
    /// Prepares the frame for a picture of `size` pixels. Each side is clamped to 1 to 65535, or 65534 with smooth edges.
    #[inline(always)]
    pub fn prepare(&self, size: Size) -> PreparedFrame<S, Q, K> {
        self.prepared(size.width, size.height)
    }

    /// Draws the frame over the whole target, row by row, and returns a report on the picture.
    ///
    /// # Errors
    /// The error of the target, at once: no further row is computed.
    pub fn draw<D: DrawTarget<Color: From<Rgb888>>>(
        &self,
        target: &mut D,
    ) -> Result<Report, D::Error> {
        let area = target.bounding_box();
        if area.is_zero_sized() {
            return Ok(Report::NONE);
        }
        let frame = self.prepare(area.size);
        let whole = Rectangle::new(Point::zero(), frame.size());
        frame
            .unchanged(self.scene())
            .draw_area(whole, area.top_left, target)
    }
}

impl<S: AnyScene, Q, K> PreparedFrame<S, Q, K> {
    /// Returns the size of the picture in pixels; each side is 1 to 65535.
    pub fn size(&self) -> Size {
        let [width, height] = self.sides();
        Size::new(width, height)
    }
}

impl<S: AnyScene, Q: Quality, K: Shading> Rows<'_, S, Q, K> {
    /// Returns the size of the picture in pixels; each side is 1 to 65535.
    pub fn size(&self) -> Size {
        let [width, height] = self.sides();
        Size::new(width, height)
    }

    /// Computes the colours of row `y` from column `x` on, writes them to `pixels`, and returns a
    /// report. Row 0 is at the top.
    ///
    /// Pixels beyond the edges of the picture stay as they are.
    pub fn row<C: PixelColor + From<Rgb888>>(&self, y: u32, x: u32, pixels: &mut [C]) -> Report {
        self.fill_row(y, x, pixels, (None, shown))
    }

    /// Does what [`Rows::row`] does, for rows that are asked for from top to bottom.
    ///
    /// With smooth edges ([`Smooth`](crate::quality::Smooth)) a row takes from `seam` what the row above it has left there,
    /// and leaves something to the row below: it takes about half of the time. Colours are the same if the seam was used
    /// for this frame only: make a new one for each frame, and for each core. Other qualities do not use the seam.
    #[inline(always)]
    pub fn next_row<C: PixelColor + From<Rgb888>, const N: usize>(
        &self,
        seam: &mut Seam<N>,
        y: u32,
        x: u32,
        pixels: &mut [C],
    ) -> Report {
        self.fill_row(y, x, pixels, (Some(&mut seam.0), shown))
    }

    /// Draws the part of the picture that lies inside of `area`, and returns a report on it.
    ///
    /// `area` is in coordinates of the picture. The top left corner of the whole picture is at the point
    /// `top_left` of the target. Pixels outside of the target are not computed.
    ///
    /// # Errors
    /// The error of the target, at once: no further row is computed.
    pub fn draw_area<D: DrawTarget<Color: From<Rgb888>>>(
        &self,
        area: Rectangle,
        top_left: Point,
        target: &mut D,
    ) -> Result<Report, D::Error> {
        let mut visible = target.bounding_box();
        visible.top_left = Point::new(
            visible.top_left.x.saturating_sub(top_left.x),
            visible.top_left.y.saturating_sub(top_left.y),
        );
        let picture = Rectangle::new(Point::zero(), self.size());
        let area = common(common(picture, area), visible);
        let mut report = Report::NONE;
        if area.is_zero_sized() {
            return Ok(report);
        }
        if let Some(only) = self.only_sum() {
            target.fill_solid(&area.translate(top_left), shown(only))?;
            report.rays = u64::from(area.size.width) * u64::from(area.size.height);
            return Ok(report);
        }
        let Some(generator) = self.generator() else {
            return Ok(report);
        };
        let (left, width) = (area.top_left.x, area.size.width);
        let mut seam = Seam::<WIDEST>::new();
        for y in area.rows() {
            let row = Rectangle::new(Point::new(left, y) + top_left, Size::new(width, 1));
            let start = [unsigned(left), unsigned(y)];
            let (drawn, part) = match Q::SMOOTHNESS {
                1 => self.in_row(generator, start, |colors| {
                    let mut buffer = Buffer::NONE;
                    let pixels = (0..width).map(|_| shown(colors.next_color(&mut buffer)));
                    target.fill_contiguous(&row, pixels)
                }),
                _ => self.in_smooth_row(generator, start, &mut seam.0, |colors| {
                    let pixels = (0..width).map(|_| shown(colors.next_color()));
                    target.fill_contiguous(&row, pixels)
                }),
            };
            drawn?;
            report = report.merge(part);
        }
        Ok(report)
    }
}

/// Returns the common part of two rectangles of any size.
fn common(one: Rectangle, other: Rectangle) -> Rectangle {
    let end = |it: Rectangle| {
        let Size { width, height } = it.size;
        let Point { x, y } = it.top_left;
        Point::new(
            x.saturating_add_unsigned(width),
            y.saturating_add_unsigned(height),
        )
    };
    let start = one.top_left.component_max(other.top_left);
    let end = end(one).component_min(end(other));
    let side = |start: i32, end: i32| unsigned(end.saturating_sub(start).max(0));
    Rectangle::new(start, Size::new(side(start.x, end.x), side(start.y, end.y)))
}

/// Returns the colour that a display shows for the sum of a path.
#[inline(always)]
fn shown<C: From<Rgb888>>(sum: Sum) -> C {
    let [red, green, blue] = sum.to_rgb8();
    C::from(Rgb888::new(red, green, blue))
}
