//! The rectangle of pixels that a shape covers.

use super::screen_axis::Columns;
use crate::number::{to_u16, to_u32, unsigned};

/// A rectangle of pixels outside of which no ray hits a shape. The last row and column are included.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenRect {
    /// First pixel column of the rectangle that a shape covers on the screen.
    pub(super) left: u16,
    /// Last pixel column of the rectangle that a shape covers on the screen.
    pub(super) right: u16,
    /// First pixel row of the rectangle that a shape covers on the screen.
    top: u16,
    /// Last pixel row of the rectangle that a shape covers on the screen.
    bottom: u16,
    /// Index of the shape among its kind.
    shape: u16,
}

impl ScreenRect {
    /// Placeholder for a rectangle that is not known. It is all zeros, so it needs no constant in
    /// flash.
    pub(super) const NONE: Self = Self {
        left: 0,
        right: 0,
        top: 0,
        bottom: 0,
        shape: 0,
    };

    /// Returns the rectangle of a shape that the picture does not show. `shape` is its index. The left
    /// column is the largest number, so no row reaches it.
    pub(super) fn of_nothing(shape: usize) -> Self {
        Self {
            left: u16::MAX,
            bottom: u16::MAX,
            shape: to_u16(to_u32(shape)),
            ..Self::NONE
        }
    }

    /// Returns the rectangle of the shape with index `shape`.
    pub(super) fn new(shape: usize, columns: Columns, rows: Columns) -> Self {
        let held = |column: i32| to_u16(unsigned(column.clamp(0, 0xffff)));
        Self {
            left: held(columns.first),
            right: held(columns.last),
            top: held(rows.first),
            bottom: held(rows.last),
            shape: to_u16(to_u32(shape)),
        }
    }

    /// Returns the shape's index among its kind.
    #[inline(always)]
    pub(super) fn shape(&self) -> usize {
        usize::from(self.shape)
    }

    /// Tests whether row `y` cuts the rectangle.
    #[inline(always)]
    pub(super) fn has_row(&self, y: u16) -> bool {
        self.top <= y && y <= self.bottom
    }
}

/// Inserts a rectangle into the first `count` rectangles, which are sorted by their left columns.
///
/// `rects[count]` is overwritten.
pub(super) fn insert(rects: &mut [ScreenRect], count: usize, rect: ScreenRect) {
    let mut rest = rects.get_mut(..=count).unwrap_or_default();
    while let [sorted @ .., place] = rest {
        match sorted.last() {
            Some(before) if before.left > rect.left => *place = *before,
            _ => {
                *place = rect;
                break;
            }
        }
        rest = sorted;
    }
}
