//! The rectangle of pixels in which a shape can be seen.

use super::screen_axis::Columns;
use crate::number::{difference_modulo_2_16, to_u16, to_u32, unsigned};

/// A rectangle of pixels in which a shape can be seen, the last row and column included.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenRect {
    pub(super) left: u16,
    pub(super) right: u16,
    /// The first and the last row, less [`BESIDE`].
    top: u16,
    bottom: u16,
    /// The columns of what is highest and of what is lowest.
    tips: [u16; 2],
    /// Which of its kind it is, and [`THIN_SHAPE`].
    shape: u16,
}

/// How many rows lie between the first in which a shape is looked for and the first in which its tip
/// may be seen, and as many at the other end.
const BESIDE: u16 = 2;

/// In how many rows from there on a round shape may be thin; in further ones it is wider than
/// [`LONGEST_STRIDE`] or thin all over.
const TIP_ROWS: u16 = 2;

/// Marks a shape that is so thin that it may lie between two pixels that are traced in a row.
pub(super) const THIN_SHAPE: u16 = 1 << 15;

impl ScreenRect {
    /// Fills the room of a rectangle that is not known; all zeros, which need no constant in flash.
    pub(super) const NONE: Self = Self {
        left: 0,
        right: 0,
        top: 0,
        bottom: 0,
        tips: [0; 2],
        shape: 0,
    };

    /// Of the shape with a number, where it is not seen.
    pub(super) fn of_nothing(shape: usize) -> Self {
        Self {
            left: u16::MAX,
            bottom: u16::MAX,
            shape: to_u16(to_u32(shape)) % THIN_SHAPE,
            ..Self::NONE
        }
    }

    /// Of the shape with a number; the columns of its tips matter only where a ray passes it.
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
            // The highest point lies above the picture, not in the row that stands for it.
            true => [lowest; 2],
            false => [highest, lowest],
        };
        // At most one less than beyond all columns.
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

    /// Which of its kind the shape is.
    #[inline(always)]
    pub(super) fn shape(&self) -> usize {
        usize::from(self.shape % THIN_SHAPE)
    }

    /// The column in the middle of a shape that is thin, or of which only the tip may be seen in
    /// row `y`; beyond all columns for any other.
    #[inline(always)]
    pub(super) fn middle(&self, y: u16) -> u16 {
        let [highest, lowest] = self.tips;
        // A row above the first one, or below the last, wraps to one that is far away.
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

    /// Whether the shape can be seen in a row of pixels.
    #[inline(always)]
    pub(super) fn has_row(&self, y: u16) -> bool {
        let (y, beside) = (u32::from(y), u32::from(BESIDE));
        u32::from(self.top) <= y + beside && y <= u32::from(self.bottom) + beside
    }
}

/// Puts a rectangle behind the first `count`, which are in rising order of their left columns, and
/// then where it belongs among them.
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
