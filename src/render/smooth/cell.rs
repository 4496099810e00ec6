//! Floor 7: a pixel between its four corners: whether edges cross it, and the shares of the corners.

use super::corner::{Corner, Side};
use crate::color::{Levels, Mixture};

/// Largest contrast in a pixel with several edges that takes no samples, in 8-bit levels: nobody sees it.
const UNSEEN: u32 = 4;

/// Largest contrast of points between which no edge lies that takes no samples, in 8-bit levels.
pub(super) const UNEVEN: u32 = 16;

/// A pixel. Corners and sides go round clockwise; the first corner is the upper left one, the first side the upper one.
pub(super) struct Cell {
    pub(super) corners: [Corner; 4],
    pub(super) sides: [Side; 4],
}

impl Cell {
    /// Twice the area of a pixel, in steps of its sides: the sum of all weights.
    const AREA: u32 = 2 * (Side::LENGTH * Side::LENGTH) as u32;

    /// Tests whether all four corners meet the same.
    pub(super) fn is_whole(&self) -> bool {
        self.sides.iter().all(|side| side.is_whole())
    }

    /// Tests whether more than one edge crosses the pixel, or one side of it.
    pub(super) fn is_tangled(&self) -> bool {
        let divided = self.sides.iter().filter(|side| !side.is_whole()).count();
        divided > 2 || self.sides.iter().any(|side| side.is_tangled())
    }

    /// Returns the contrast that decides how many samples the pixel takes, in 8-bit levels; 0 if it takes none.
    pub(super) fn contrast(&self) -> u32 {
        let is_tangled = self.is_tangled();
        let next = self.corners.iter().cycle().skip(1);
        let pairs = self.corners.iter().zip(next);
        // In a tangle all corners count, else those that meet the same.
        let pairs = pairs.filter(|(one, other)| is_tangled || one.path.meets_same(other.path));
        let largest = pairs.fold(0, |largest, (one, other)| largest.max(one.contrast(other)));
        let least = if is_tangled { UNSEEN } else { UNEVEN };
        if largest > least { largest } else { 0 }
    }

    /// Returns the sum of two corners' colours.
    #[inline(always)]
    pub(super) fn sum(corners: [&Corner; 2]) -> Mixture {
        let mut mixture = Mixture::NONE;
        for corner in corners {
            mixture.add(corner.color, 1);
        }
        mixture
    }

    /// Returns the mean of the corners' colours. The weight of each is the area of the part of the pixel that is nearest to it;
    /// the points where edges cross the sides bound these parts.
    pub(super) fn color(&self) -> Levels {
        if self.is_whole() {
            let [a, b, c, d] = &self.corners;
            return Self::sum([a, b]).with(Self::sum([c, d])).mean(4);
        }
        const WHOLE: i32 = Side::LENGTH;
        let [top, right, bottom, left] = self.sides.map(Side::at);
        // Edges meet in the middle of the points where they cross the sides.
        let points = [[top, 0], [WHOLE, right], [bottom, WHOLE], [0, left]];
        let (mut x, mut y, mut count) = (0, 0, 0);
        for (point, side) in points.iter().zip(self.sides) {
            if !side.is_whole() {
                (x, y, count) = (x + point[0], y + point[1], count + 1);
            }
        }
        // At least one side is divided, and then another one is, too.
        let [x, y] = match count {
            4 => [x >> 2, y >> 2],
            3 => [(x * 11) >> 5, (y * 11) >> 5],
            _ => [x >> 1, y >> 1],
        };
        // Twice the area between a corner, a point on each of its sides, and the middle.
        let shares = [
            top * y + left * x,
            (WHOLE - top) * y + right * (WHOLE - x),
            (WHOLE - bottom) * (WHOLE - y) + (WHOLE - right) * (WHOLE - x),
            bottom * (WHOLE - y) + (WHOLE - left) * x,
        ];
        let mut mixture = Mixture::NONE;
        for (corner, share) in self.corners.iter().zip(shares) {
            mixture.add(corner.color, share);
        }
        mixture.mean(Self::AREA)
    }

    /// Returns the contrast of a sample to the corners, in 8-bit levels; 0 if one of them meets what the sample meets.
    pub(super) fn contrast_to(&self, sample: &Corner) -> u32 {
        let corners = self.corners.iter();
        let contrast = |corner: &Corner| corner.contrast(sample);
        let contrasts =
            corners.map(|it| if it.path.meets_same(sample.path) { 0 } else { contrast(it) });
        contrasts.min().filter(|least| *least > UNSEEN).unwrap_or(0)
    }
}
