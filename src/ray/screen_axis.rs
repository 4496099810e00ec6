//! The columns of a picture as points on a line: where a ray in a given direction crosses it.

use crate::number::{Quotient, divide, narrowed_unsigned, signed, unsigned_wide, wide};
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

    /// Returns the column of a ray whose tangent is `numerator` over the denominator that made `scale`.
    /// Rounds down. Columns further than 2¹⁹ from the picture's middle are clamped.
    pub(crate) fn column(&self, numerator: i64, scale: Quotient) -> i32 {
        (half_pixels::<0>(numerator, scale) + signed(self.width) - 1) >> 1
    }

    /// As [`ScreenAxis::column`], in sixteenths of a column.
    pub(crate) fn sixteenths(&self, numerator: i64, scale: Quotient) -> i32 {
        half_pixels::<3>(numerator, scale) + 8 * (signed(self.width) - 1)
    }

    /// Tests whether a tangent of `numerator` / `denominator` and its negative are beside the columns that
    /// may be traced. The denominator is above 0.
    pub(crate) fn is_beside(&self, numerator: i64, denominator: i64) -> bool {
        let beyond = self.column(numerator, self.columns_for_each(denominator));
        beyond > signed(2 * self.width)
    }

    /// Tests whether the column where a plane through the eye cuts the row is exact to an eighth of a
    /// column. The plane touches a cylinder, and what the cylinder's radius is off by, 32 steps, turns it
    /// by 32 / `touching`.
    ///
    /// With a normal of length n, the column is at the tangent p / q, where q is the normal's part aside.
    /// `scale` is made for q. If the plane turns by an angle, the tangent changes by at most (n / q)²
    /// times the angle.
    pub(crate) fn is_exact(&self, normal: i64, scale: Quotient, touching: i32) -> bool {
        let each = half_pixels::<3>(1 << 30, self.columns_for_each(1 << 30));
        let turned = half_pixels::<3>(normal, scale);
        turned < 1 << 22 && 16 * wide(turned, turned) <= wide(each, touching)
    }
}

/// Returns `numerator` · `scale`, rounded down, in half pixels with `PLACES` fraction bits.
#[inline(never)]
fn half_pixels<const PLACES: i32>(numerator: i64, scale: Quotient) -> i32 {
    let size = numerator.unsigned_abs();
    let drop = 32_u32.saturating_sub(size.leading_zeros());
    let product = (size >> drop) * u64::from(scale.mantissa);
    // Further to the side than any picture is wide: 2²⁰ half pixels.
    let beside = 1 << (20 + PLACES);
    let half_pixels = signed(narrowed_unsigned(
        match scale.exponent + signed(drop) + PLACES {
            0.. => beside,
            shift @ -63..0 => (product >> -shift).min(beside),
            _ => 0,
        },
    ));
    if numerator < 0 {
        !half_pixels
    } else {
        half_pixels
    }
}
