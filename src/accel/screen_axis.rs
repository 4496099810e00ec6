//! The columns of pixels that a ball or a capsule can cover. The camera is looked at along the columns,
//! so the problem is two-dimensional: the shape lies between its two tangents. Rows are treated in the
//! same way. All bounds are widened by more than the rounding error.

use super::LONGEST_STRIDE;
use crate::number::{
    Quotient, Unit, divide, narrowed_unsigned, ratio, scaled_by_unit, signed, square_root,
    unsigned_wide, wide,
};
use crate::ray::ScreenAxis;
use crate::vector::Vector;

/// A range of pixel columns in which rays can hit a shape. Columns outside of the picture may be
/// included.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub(super) first: i32,
    pub(super) last: i32,
    /// Whether part of the shape may be so narrow that it lies between two traced pixels.
    pub(super) is_thin: bool,
}

/// Largest difference of last and first column of a shape that counts as thin. It is more than a
/// stride, because the bounds are wider than the shape.
pub(super) const THIN: i32 = signed(LONGEST_STRIDE) + 4;

impl Columns {
    /// All columns. Used where nothing is known about a shape, so it may be thin.
    pub(super) const ALL: Self = Self {
        first: 0,
        last: i32::MAX,
        is_thin: true,
    };

    /// Widens the range of a thin shape by [`LONGEST_STRIDE`] columns on both sides.
    ///
    /// The range then includes traced pixels on both sides of the shape. Their rays tell on which side
    /// they pass it.
    pub(super) fn with_neighbours(self) -> Self {
        match self.is_thin {
            true => Self {
                first: self.first.saturating_sub(signed(LONGEST_STRIDE)),
                last: self.last.saturating_add(signed(LONGEST_STRIDE)),
                ..self
            },
            false => self,
        }
    }

    /// Returns the smallest range that holds both ranges. It is thin if one of them is.
    fn with(self, other: Self) -> Self {
        Self {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
            is_thin: self.is_thin || other.is_thin,
        }
    }
}

/// Returns a radius enlarged by more than the rounding error of the bounds: 2⁻¹⁰ of it and 64 steps.
pub(super) fn widened(radius: i32) -> i32 {
    radius + (radius >> 10) + 64
}

impl ScreenAxis {
    /// Returns the columns in which rays can hit a capsule (a cylinder with rounded ends), `None` if
    /// the picture does not show them.
    ///
    /// `way` is the vector from the eye to the capsule's middle, `half_axis` the vector from there to
    /// one end.
    pub(super) fn capsule_columns(
        &self,
        way: Vector,
        half_axis: Vector,
        radius: i32,
    ) -> Option<Columns> {
        let ends = [way.plus(half_axis), way.minus(half_axis)];
        // If an end reaches behind the eye, it has no columns. The part between the ends may still be
        // visible.
        if ends.iter().any(|end| end.dot(self.ahead) <= radius) {
            return Some(Columns::ALL);
        }
        let [a, b] = ends.map(|end| self.sphere_bounds(end, radius));
        self.visible(a.with(b))
    }

    /// Returns the columns in which rays can hit a sphere, `None` if the picture does not show them.
    ///
    /// `way` is the vector from the eye to the sphere's centre.
    pub(super) fn sphere_columns(&self, way: Vector, radius: i32) -> Option<Columns> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            // The sphere holds the eye or reaches behind it.
            return (ahead >= -radius).then_some(Columns::ALL);
        }
        self.visible(self.sphere_bounds(way, radius))
    }

    /// Returns the columns between the two tangents to a sphere, seen along the columns.
    ///
    /// The whole sphere must lie in front of the eye.
    fn sphere_bounds(&self, way: Vector, radius: i32) -> Columns {
        let (ahead, aside) = (
            i64::from(way.dot(self.ahead)),
            i64::from(way.dot(self.aside)),
        );
        let radius = i64::from(radius);
        let tangent = square_root(unsigned_wide(
            ahead * ahead + aside * aside - radius * radius,
        ));
        let spread = radius * i64::from(tangent);
        let scale = self.columns_for_each(ahead * ahead - radius * radius);
        let middle = ahead * aside;
        let first = self.column(middle - spread, scale) - 1;
        let last = self.column(middle + spread, scale) + 2;
        Columns {
            first,
            last,
            is_thin: last - first <= THIN,
        }
    }

    /// Returns the columns of the highest and the lowest visible point of a sphere, rounded down.
    /// Returns `None` if the sphere is not wholly in front of the eye. `rows` is the axis of the
    /// picture's rows.
    ///
    /// At these points the sphere touches two planes through the eye that run along the rows of pixels.
    /// The points have the same `aside` as the sphere's centre. Let the centre be a `ahead` and b down,
    /// r the radius and t the length of the tangents to the circle that is the sphere seen along the
    /// rows. The points then lie t (a t ± b r) / (a² + b²) ahead.
    pub(super) fn tips(&self, rows: &ScreenAxis, way: Vector, radius: i32) -> Option<[i32; 2]> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            return None;
        }
        let (aside, down) = (i64::from(way.dot(self.aside)), way.dot(rows.aside));
        let square = wide(ahead, ahead) + wide(down, down);
        let tangent = square_root(unsigned_wide(square - wide(radius, radius)));
        let (along, across) = (wide(ahead, tangent), wide(down, radius));
        // Keep 30 bits of the square.
        let drop = 34_u32.saturating_sub(square.leading_zeros());
        let square = narrowed_unsigned(unsigned_wide(square >> drop));
        Some([along + across, along - across].map(|touched| {
            let share = ratio(
                narrowed_unsigned(unsigned_wide(touched >> drop)).min(square - 1),
                square,
            );
            let ahead = scaled_by_unit(tangent, Unit::from_bits(share)).max(1);
            self.column(aside, self.columns_for_each(ahead.into()))
        }))
    }

    /// Returns a range that cuts the picture or the columns that are traced to the right of it, else
    /// `None`.
    fn visible(&self, columns: Columns) -> Option<Columns> {
        let end = signed(self.width + LONGEST_STRIDE);
        (columns.last >= 0 && columns.first < end).then_some(columns)
    }

    /// Returns the factor from a numerator over `denominator` to half pixels: `distance` · 2^`scale` /
    /// `denominator`.
    fn columns_for_each(&self, denominator: i64) -> Quotient {
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
    fn column(&self, numerator: i64, scale: Quotient) -> i32 {
        let size = numerator.unsigned_abs();
        let drop = 32_u32.saturating_sub(size.leading_zeros());
        let product = (size >> drop) * u64::from(scale.mantissa);
        // In half pixels: further to the side than any picture is wide.
        const BESIDE: u64 = 1 << 20;
        let half_pixels = signed(narrowed_unsigned(match scale.exponent + signed(drop) {
            0.. => BESIDE,
            shift @ -63..0 => (product >> -shift).min(BESIDE),
            _ => 0,
        }));
        let half_pixels = if numerator < 0 {
            !half_pixels
        } else {
            half_pixels
        };
        (half_pixels + signed(self.width) - 1) >> 1
    }
}

#[cfg(test)]
mod tests;
