//! Floor 8: pictures and their rows as pixels of a display. The only floor that names
//! embedded-graphics; it knows no ray.

mod bound;
mod budget;
mod dither;
mod enlarged;

pub use budget::{Budgeted, Choice, Front, FrontPoint, Grade};
pub use dither::{Ditherable, Dithered, Threshold, dither};
pub use enlarged::Enlarged;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::transform::Transform;

use crate::accel::World;
use crate::color::Sum;
use crate::number::unsigned;
use crate::render::Quality;
use crate::render::{Frame, Picture, Report};
use crate::shade::Shading;

impl<W: World + Copy, Q: Quality, K: Shading> Frame<'_, W, Q, K> {
    /// Makes the frame ready for one size of picture; each side is taken as 1 to 65535 pixels.
    #[inline(always)]
    pub fn sized(&self, size: Size) -> Picture<W, Q, K> {
        self.prepared(size.width, size.height)
    }

    /// Draws the frame over the whole target, row by row.
    ///
    /// # Errors
    /// The target's own, at once: no further row is worked out.
    pub fn draw<D>(&self, target: &mut D) -> Result<Report, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
        let area = target.bounding_box();
        if area.is_zero_sized() {
            return Ok(Report::NONE);
        }
        self.sized(area.size).draw_at(area.top_left, target)
    }
}

impl<W: World, Q: Quality, K: Shading> Picture<W, Q, K> {
    /// The size it was made for.
    pub fn size(&self) -> Size {
        let [width, height] = self.sides();
        Size::new(width, height)
    }

    /// Fills `pixels` with row `y` from column `x` on; row 0 is at the top.
    ///
    /// What would lie beyond the picture's edges stays as it is.
    pub fn row<C: PixelColor + From<Rgb888>>(&self, y: u32, x: u32, pixels: &mut [C]) -> Report {
        self.fill_row(y, x, pixels, shown)
    }

    /// Draws the whole picture with its top left corner at `top_left` of the target, row by row;
    /// what lies outside the target is not worked out.
    ///
    /// # Errors
    /// The target's own, at once: no further row is worked out.
    pub fn draw_at<D>(&self, top_left: Point, target: &mut D) -> Result<Report, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
        self.draw_area(Rectangle::new(Point::zero(), self.size()), top_left, target)
    }

    /// Draws the part of the picture inside `area` (in the picture's own coordinates), where the
    /// picture's top left corner is at `top_left` of the target.
    ///
    /// # Errors
    /// The target's own, at once: no further row is worked out.
    pub fn draw_area<D>(
        &self,
        area: Rectangle,
        top_left: Point,
        target: &mut D,
    ) -> Result<Report, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
        let visible = Rectangle::new(
            target.bounding_box().top_left - top_left,
            target.bounding_box().size,
        );
        let area = Rectangle::new(Point::zero(), self.size())
            .intersection(&area)
            .intersection(&visible);
        let mut report = Report::NONE;
        if area.is_zero_sized() {
            return Ok(report);
        }
        let Some(generator) = self.generator() else {
            target.fill_solid(&area.translate(top_left), shown(self.only_sum()))?;
            report.rays = u64::from(area.size.width) * u64::from(area.size.height);
            return Ok(report);
        };
        let (left, width) = (area.top_left.x, area.size.width);
        for y in area.rows() {
            let row = Rectangle::new(Point::new(left, y) + top_left, Size::new(width, 1));
            let start = [unsigned(left), unsigned(y)];
            let (drawn, part) = self.in_row(generator, start, |colors| {
                let pixels = (0..width).map(|_| shown(colors.next_color()));
                target.fill_contiguous(&row, pixels)
            });
            drawn?;
            report = report.merge(part);
        }
        Ok(report)
    }
}

/// A sum as a display shows it.
#[inline(always)]
fn shown<C: From<Rgb888>>(sum: Sum) -> C {
    let [red, green, blue] = sum.to_rgb8();
    C::from(Rgb888::new(red, green, blue))
}
