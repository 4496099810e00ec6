//! The rectangle of pixels that a shape covers, and the columns of its tips.

use super::screen_axis::Columns;
use crate::number::{difference_modulo_2_16, to_u16, to_u32, unsigned};

/// A rectangle of pixels outside of which no ray hits a shape. The last row and column are included.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenRect {
    /// First pixel column of the rectangle that a shape covers on the screen.
    pub(super) left: u16,
    /// Last pixel column of the rectangle that a shape covers on the screen.
    pub(super) right: u16,
    /// First pixel row of the rectangle that a shape covers on the screen, plus [`BESIDE`].
    top: u16,
    /// Last pixel row of the rectangle that a shape covers on the screen, minus [`BESIDE`].
    bottom: u16,
    /// Columns of the highest and of the lowest point of the shape.
    tips: [u16; 2],
    /// Index of the shape among its kind, with the bit [`THIN_SHAPE`].
    shape: u16,
}

/// Number of rows from the first row of a rectangle to the first row that can show the shape's highest
/// point. As many lie between the last row that can show its lowest point and the rectangle's last row.
const BESIDE: u16 = 2;

/// Number of rows at each end of a ball in which only its tip may be visible, so that it may be thin
/// there. In the rows between, a ball is wider than [`LONGEST_STRIDE`](super::LONGEST_STRIDE), or
/// marked as thin in all rows.
const TIP_ROWS: u16 = 2;

/// Bit that marks a shape so thin that it may lie between two traced pixels of a row.
pub(super) const THIN_SHAPE: u16 = 1 << 15;

impl ScreenRect {
    /// Placeholder for a rectangle that is not known. It is all zeros, so it needs no constant in
    /// flash.
    pub(super) const NONE: Self = Self {
        left: 0,
        right: 0,
        top: 0,
        bottom: 0,
        tips: [0; 2],
        shape: 0,
    };

    /// Returns the rectangle of a shape that the picture does not show. `shape` is its index. The left
    /// column is the largest number, so no row reaches it.
    pub(super) fn of_nothing(shape: usize) -> Self {
        Self {
            left: u16::MAX,
            bottom: u16::MAX,
            shape: to_u16(to_u32(shape)) % THIN_SHAPE,
            ..Self::NONE
        }
    }

    /// Returns the rectangle of the shape with index `shape`. `tips` are the columns of its highest and
    /// lowest point; they matter only where a ray passes beside the shape.
    pub(super) fn new(
        shape: usize,
        columns: Columns,
        rows: Columns,
        tips: Option<[i32; 2]>,
    ) -> Self {
        let held = |column: i32| to_u16(unsigned(column.clamp(0, 0xffff)));
        let shape = to_u16(to_u32(shape)) % THIN_SHAPE;
        let [highest, lowest] = tips.unwrap_or_default();
        let tips = match rows.first + i32::from(BESIDE) < 0 {
            // The highest point lies above the picture, so row 0 does not show it.
            true => [lowest; 2],
            false => [highest, lowest],
        };
        // Below `u16::MAX`, which means "not thin".
        let tip = |column: i32| to_u16(unsigned(column.clamp(0, 0xfffe)));
        Self {
            left: held(columns.first),
            right: held(columns.last),
            top: held(rows.first.saturating_add(BESIDE.into())),
            bottom: held(rows.last.saturating_sub(BESIDE.into())),
            tips: tips.map(tip),
            shape: match columns.is_thin {
                true => shape | THIN_SHAPE,
                false => shape,
            },
        }
    }

    /// Returns the shape's index among its kind.
    #[inline(always)]
    pub(super) fn shape(&self) -> usize {
        usize::from(self.shape % THIN_SHAPE)
    }

    /// Returns the shape's centre column if the shape is thin in row `y`, else `u16::MAX`.
    ///
    /// A ball may be thin near its tips only. In these rows the result is the column of the tip.
    #[inline(always)]
    pub(super) fn middle(&self, y: u16) -> u16 {
        let [highest, lowest] = self.tips;
        // A row above the first tip row, or below the last, wraps to a large number.
        if difference_modulo_2_16(y, self.top) < TIP_ROWS {
            highest
        } else if difference_modulo_2_16(self.bottom, y) < TIP_ROWS {
            lowest
        } else if self.shape & THIN_SHAPE != 0 {
            highest.midpoint(lowest)
        } else {
            u16::MAX
        }
    }

    /// Tests whether row `y` cuts the rectangle.
    #[inline(always)]
    pub(super) fn has_row(&self, y: u16) -> bool {
        let (y, beside) = (u32::from(y), u32::from(BESIDE));
        u32::from(self.top) <= y + beside && y <= u32::from(self.bottom) + beside
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
