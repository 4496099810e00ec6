//! Floor 8: a still picture that is coarse at first: every fourth row, four rows high, and then the rows
//! between.

use core::iter::repeat_n;
use core::ops::Range;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use crate::accel::any_scene::AnyScene;
use crate::number::signed;
use crate::qualities::Quality;
use crate::render::{FrameBuilder, Report};
use crate::shade::Shading;

/// Rows that each row of the first pass covers.
const STEP: u32 = 4;

/// Returns the order in which the rows of a still picture are drawn, coarse first. Each item begins with
/// the row that is traced and has all rows of the display that it covers.
///
/// The first pass covers the whole height with every fourth row. The second pass draws the rows between.
/// So each row is traced once. Programs that trace rows themselves, such as on two cores, use this order;
/// others call [`FrameBuilder::draw_coarse_first`].
///
/// ```
/// use reflet::display::coarse_first;
///
/// assert!(coarse_first(6).eq([0..4, 4..6, 1..2, 2..3, 3..4, 5..6]));
/// ```
pub fn coarse_first(height: u32) -> impl Iterator<Item = Range<u32>> + Clone {
    let coarse = (0..height).step_by(STEP as usize);
    let coarse = coarse.map(move |y| y..height.min(y.saturating_add(STEP)));
    let between = (0..height).filter(|y| y % STEP != 0);
    coarse.chain(between.map(|y| y..y.saturating_add(1)))
}

impl<S: AnyScene, Q: Quality, K: Shading> FrameBuilder<'_, S, Q, K> {
    /// Draws the frame over the whole target as [`draw`](Self::draw) does, but coarse at first: every
    /// fourth row, four rows high, and then the rows between. Returns a report on the picture.
    ///
    /// The picture is there after a quarter of the time. It is traced once: no row is computed again, and
    /// the last state of the target is that of [`draw`](Self::draw). 1.75 times as many pixels are sent.
    /// `row` holds the pixels of one row of the target. If it is shorter, only as many columns are drawn.
    ///
    /// With smooth edges it takes nearly twice as long as `draw`, since no row comes right after the one above it.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888, prelude::*};
    /// use reflet::scenes::{BuiltIn, Floor};
    ///
    /// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
    /// display.set_allow_overdraw(true);
    /// let mut row = [Rgb888::BLACK; 64];
    /// Floor::frame(&Floor::CAMERA).draw_coarse_first(&mut row, &mut display)?;
    ///
    /// let mut plain = MockDisplay::<Rgb888>::new();
    /// Floor::frame(&Floor::CAMERA).draw(&mut plain)?;
    /// display.assert_eq(&plain);
    /// # Ok::<(), core::convert::Infallible>(())
    /// ```
    ///
    /// # Errors
    /// The error of the target, at once: no further row is computed.
    pub fn draw_coarse_first<D: DrawTarget<Color: From<Rgb888>>>(
        &self,
        row: &mut [D::Color],
        target: &mut D,
    ) -> Result<Report, D::Error> {
        let area = target.bounding_box();
        let mut report = Report::NONE;
        if area.is_zero_sized() {
            return Ok(report);
        }
        let frame = self.prepare(area.size);
        let rows = frame.unchanged(self.scene());
        let Size { width, height } = rows.size();
        let columns = u32::try_from(row.len()).unwrap_or(width).min(width);
        let (row, _) = row.split_at_mut(columns as usize);
        for covered in coarse_first(height) {
            report = report.merge(rows.row(covered.start, 0, row));
            let at = area.top_left + Point::new(0, signed(covered.start));
            let size = Size::new(columns, covered.end - covered.start);
            let pixels = repeat_n(&*row, covered.len()).flatten().copied();
            target.fill_contiguous(&Rectangle::new(at, size), pixels)?;
        }
        Ok(report)
    }
}
