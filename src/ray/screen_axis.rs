//! The columns of a picture as points on a line: where a ray in a given direction crosses it.

use crate::number::{
    Quotient, divide, high_unsigned, narrowed_unsigned, signed, unsigned, unsigned_wide, wide,
};
use crate::vector::{Direction, Point};

/// Rays through the centres of a picture's columns, projected along the columns: all start at one near
/// point and lie in one plane. It also serves for rows; then rows take the place of columns.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ScreenAxis {
    pub(crate) origin: Point,
    /// Direction of the camera's view, at right angles to the screen axis.
    pub(crate) ahead: Direction,
    /// Direction from one column to the next.
    pub(crate) aside: Direction,
    /// Distance from the point to the picture along `ahead`: `distance` · 2^`scale` half pixels.
    pub(crate) distance: i32,
    pub(crate) scale: i32,
    /// Number of pixels along the screen axis.
    pub(crate) width: u32,
}

impl ScreenAxis {
    /// Returns the factor from a numerator over `denominator` to half pixels: `distance` · 2^`scale` /
    /// `denominator`.
    #[inline(never)]
    pub(crate) fn columns_for_each(&self, denominator: i64) -> Quotient {
        let drop = 33_u32.saturating_sub(denominator.leading_zeros());
        let Quotient { mantissa, exponent } = divide(
            unsigned_wide(self.distance.into()) << 31,
            narrowed_unsigned(unsigned_wide(denominator >> drop)),
        );
        Quotient {
            mantissa,
            exponent: exponent - 31 - signed(drop) + self.scale,
        }
    }

    /// Returns two columns, in sixteenths: rays whose tangents are `numerator` ± `off`, over the denominator
    /// that made `scale`, lie between the first and one sixteenth after the last. `off` is at least 0.
    /// Columns further than 2¹⁹ from the picture's middle are clamped.
    #[inline(never)]
    pub(crate) fn sixteenths(&self, numerator: i64, off: i64, scale: Quotient) -> [i32; 2] {
        let (size, off) = (numerator.unsigned_abs(), off.unsigned_abs());
        let zeros = (size | off | 1).leading_zeros();
        // The spread has twice the limit of the middle: what it reaches must not move into the picture.
        let middle = in_sixteenths(size, zeros, scale).min(FURTHEST);
        let middle = if numerator < 0 { !middle } else { middle };
        let spread = in_sixteenths(off, zeros, scale) + 1;
        let middle = middle + 8 * (signed(self.width) - 1);
        [middle - spread, middle + spread]
    }

    /// Tests whether a tangent of `numerator` / `denominator` and its negative are surely beside the picture. The
    /// denominator is above 0.
    pub(crate) fn is_beside(&self, numerator: i64, denominator: i64) -> bool {
        let [beyond, _] = self.sixteenths(numerator, 0, self.columns_for_each(denominator));
        beyond > signed(32 * self.width)
    }

    /// Tests whether the column where a plane through the eye cuts the row is exact to an eighth of a
    /// column. The plane touches a cylinder, and what the cylinder's radius is off by, 32 steps, turns it
    /// by 32 / `touching`.
    ///
    /// With a normal of length n, the column is at the tangent p / q, where q is the normal's part aside.
    /// `scale` is made for q. If the plane turns by an angle, the tangent changes by at most (n / q)²
    /// times the angle.
    pub(crate) fn is_exact(&self, normal: i64, scale: Quotient, touching: i32) -> bool {
        let to_picture = Quotient {
            mantissa: unsigned(self.distance),
            exponent: self.scale,
        };
        let each = in_sixteenths(1, 63, to_picture);
        let turned = in_sixteenths(unsigned_wide(normal), normal.leading_zeros(), scale);
        turned < 1 << 22 && 16 * wide(turned, turned) <= wide(each, touching)
    }
}

/// Largest distance of a column from the middle of a picture, in sixteenths of a column. Greater ones are clamped.
const FURTHEST: i32 = 1 << 23;

/// Converts a length to sixteenths of a column, rounded down, but at most to twice [`FURTHEST`]. The length is
/// `size` · `scale`, in half pixels. `size` has at least `zeros` leading zeros.
#[inline(always)]
fn in_sixteenths(size: u64, zeros: u32, scale: Quotient) -> i32 {
    let product = high_unsigned(narrowed_unsigned(size << zeros >> 32), scale.mantissa);
    match signed(zeros) - 67 - scale.exponent {
        ..0 => 2 * FURTHEST,
        down @ 0..32 => signed((product >> down).min(2 * unsigned(FURTHEST))),
        _ => 0,
    }
}
