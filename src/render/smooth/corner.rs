//! Floor 7: the corners of pixels, and the line of them that a row of pixels leaves to the row below.

use super::CHUNK;
use crate::color::Levels;
use crate::ray::PathMark;
use crate::trace::Traced;

/// A corner of pixels: what its path shows. It is aligned so that it is copied as two words.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(align(4))]
pub(super) struct Corner {
    pub(super) color: Levels,
    /// What the path met.
    pub(super) path: PathMark,
}

impl Corner {
    /// A corner that is not known. It is all zeros, so it needs no constant in flash.
    pub(super) const NONE: Self = Self {
        color: Levels::DARK,
        path: PathMark::NONE,
    };

    /// Returns the corner whose path was traced.
    pub(super) fn of(traced: Traced) -> Self {
        Self {
            color: Levels::of(traced.sum),
            path: traced.signature.mark(),
        }
    }

    /// Returns the contrast to another corner, in 8-bit levels.
    pub(super) fn contrast(&self, other: &Self) -> u32 {
        self.color.contrast(other.color)
    }
}

/// A side of a pixel: whether an edge crosses it, and where.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Side(u8);

impl Side {
    /// Length of a side, in steps.
    pub(super) const LENGTH: i32 = 32;

    /// A side whose ends meet the same.
    pub(super) const WHOLE: Self = Self(0);

    /// Added where more than one edge crosses a side, or where the colour changes much between a corner and an edge.
    const TANGLED: u8 = 1 << 6;

    /// A side that an edge crosses `at` this distance from its left or upper end, 1 to 31 steps.
    pub(super) fn divided(at: u8) -> Self {
        Self(at)
    }

    /// A side that more than one edge crosses, or along which the colour changes much. An edge crosses it `at` this distance.
    pub(super) fn tangled(at: u8) -> Self {
        Self(at | Self::TANGLED)
    }

    /// Tests whether no edge crosses the side.
    pub(super) fn is_whole(self) -> bool {
        self == Self::WHOLE
    }

    /// Tests whether more than one edge crosses the side, or the colour changes much along it.
    pub(super) fn is_tangled(self) -> bool {
        self.0 & Self::TANGLED != 0
    }

    /// Returns where an edge crosses the side, in steps; its middle if none does.
    pub(super) fn at(self) -> i32 {
        if self.is_whole() {
            Self::LENGTH / 2
        } else {
            i32::from(self.0 & (Self::TANGLED - 1))
        }
    }
}

/// The corners on one line of a chunk: those of its pixels, and the first one of the next chunk.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Line {
    pub(super) corners: [Corner; CHUNK as usize + 1],
    /// The side from each corner to the next one.
    pub(super) sides: [Side; CHUNK as usize],
    /// A bit for each side that an edge crosses.
    pub(super) crossed: u32,
    /// A bit for each pixel that may show several cells of a checker.
    pub(super) tiled: u32,
    /// From the highest bit: the number of the line plus one, in 18 bits, so that all zeros are a line that is not known; the
    /// number of the chunk, in 11 bits; [`Line::DIVIDED`], [`Line::FLAT`] and [`Line::ONE`].
    place: u32,
}

impl Line {
    /// A line that is not known. It is all zeros, so it needs no constant in flash.
    pub(super) const NONE: Self = Self {
        corners: [Corner::NONE; CHUNK as usize + 1],
        sides: [Side::WHOLE; CHUNK as usize],
        crossed: 0,
        tiled: 0,
        place: 0,
    };

    /// Set if the sides were divided for a row of pixels of two parts, where edges are found to another tolerance.
    const DIVIDED: u32 = 4;

    /// Set if all corners are known to have one colour, because no path hits anything.
    const FLAT: u32 = 2;

    /// Set if the paths through all corners, but those beyond the picture, are known to hit the same shapes, lit by the same
    /// lights.
    const ONE: u32 = 1;

    /// Returns what `place` holds of a line of the chunk that begins at column `first`, for a row of pixels that `is_divided` or
    /// not, without the other flags.
    fn place_of([line, first]: [u32; 2], is_divided: bool) -> u32 {
        let flag = if is_divided { Self::DIVIDED } else { 0 };
        ((line + 1) << 14) | (first / CHUNK) << 3 | flag
    }

    /// Tests whether [`Line::begin`] with these arguments makes this line.
    pub(super) fn is_of(&self, at: [u32; 2], is_divided: bool) -> bool {
        self.place & !(Self::FLAT | Self::ONE) == Self::place_of(at, is_divided)
    }

    /// Returns the line, counted from the top.
    pub(super) fn line(&self) -> u32 {
        (self.place >> 14).saturating_sub(1)
    }

    /// Tests whether all corners are known to have one colour.
    fn is_flat(&self) -> bool {
        self.place & Self::FLAT != 0
    }

    /// Gives all corners the colour of a path that hits nothing.
    pub(super) fn flatten(&mut self, all: Corner) {
        self.corners = [all; CHUNK as usize + 1];
        self.place |= Self::FLAT | Self::ONE;
    }

    /// Notes that the paths through all corners hit the same shapes, lit by the same lights.
    pub(super) fn unite(&mut self) {
        self.place |= Self::ONE;
    }

    /// Tests whether all corners of this line and of another one are known to be the same.
    pub(super) fn is_flat_with(&self, other: &Self) -> bool {
        self.is_flat() && other.is_flat() && self.corners[0] == other.corners[0]
    }

    /// Tests whether the paths through all corners of two lines are known to hit the same shapes, lit by the same lights.
    pub(super) fn is_one_with(&self, other: &Self) -> bool {
        self.place & other.place & Self::ONE != 0 && self.corners[0].path == other.corners[0].path
    }

    /// Makes it the same as another line. Inlined, it would link a copy for parts of memory that overlap.
    #[inline(never)]
    pub(super) fn copy(&mut self, other: &Self) {
        *self = *other;
    }

    /// Makes it a line further down, which has the same corners.
    pub(super) fn descend(&mut self, lines: u32) {
        self.place += lines << 14;
    }

    /// Makes it a line of a chunk, whose sides no edge crosses, for a row of pixels that `is_divided` or not. `at` is the
    /// number of the line and the chunk's first column.
    pub(super) fn begin(&mut self, at: [u32; 2], is_divided: bool) {
        self.place = Self::place_of(at, is_divided);
        self.sides = [Side::WHOLE; CHUNK as usize];
        (self.crossed, self.tiled) = (0, 0);
    }
}

/// What a row with smooth edges leaves to the row below it: the corners of pixels on the line between the two.
///
/// `N` is the number of columns of the picture over 32, rounded up: 8 for 240 columns. It takes 308 bytes each. Columns
/// beyond trace the line above again, and so does a row that does not follow the one above. Use it for the rows of one
/// picture only.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use reflet::quality::{Seam, Smooth};
/// use reflet::scenes::{BuiltIn, Mirror1};
///
/// let frame = Mirror1::frame(&Mirror1::CAMERA).quality::<Smooth<2>>().prepare(Size::new(64, 64));
/// let rows = frame.on(&Mirror1)?;
/// let (mut seam, mut row) = (Seam::<2>::new(), [Rgb888::BLACK; 64]);
/// let [first, second] = [20, 21].map(|y| rows.next_row(&mut seam, y, 0, &mut row).rays);
/// assert!(second < first);
///
/// let mut alone = [Rgb888::BLACK; 64];
/// rows.row(21, 0, &mut alone);
/// assert_eq!(row, alone);
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct Seam<const N: usize>(pub(crate) [Line; N]);

impl<const N: usize> Seam<N> {
    /// Creates a seam in which no row has left anything. It is all zeros, so a static one takes no flash.
    pub const fn new() -> Self {
        const { assert!(N > 0, "a seam has room for at least 32 columns") };
        Self([Line::NONE; N])
    }
}

impl<const N: usize> Default for Seam<N> {
    fn default() -> Self {
        Self::new()
    }
}
