//! The columns of pixels in which a ball or a capsule can be seen: between its tangents, as seen along
//! the columns. (Along the rows likewise.) Bounds are widened by more than rounding can be wrong.

use super::LONGEST_STRIDE;
use crate::number::{
    Quotient, Unit, divide, narrowed_unsigned, ratio, scaled_by_unit, signed, square_root,
    unsigned_wide, wide,
};
use crate::ray::ScreenAxis;
use crate::vector::Vector;

/// The columns, first and last, in which a shape can be met.
#[derive(Clone, Copy, Debug)]
pub(super) struct Columns {
    pub(super) first: i32,
    pub(super) last: i32,
    /// Whether something may be so thin that it lies between two pixels that are traced.
    pub(super) is_thin: bool,
}

/// What is bound to so few columns, or rather some less for the bounds are wide, is thin.
pub(super) const THIN: i32 = signed(LONGEST_STRIDE) + 4;

impl Columns {
    pub(super) const ALL: Self = Self {
        first: 0,
        last: i32::MAX,
        is_thin: true,
    };

    /// With the pixels beside something thin that are traced for sure, so that it is known on which
    /// side of it their rays pass.
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

    fn with(self, other: Self) -> Self {
        Self {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
            is_thin: self.is_thin || other.is_thin,
        }
    }
}

/// A radius widened by what rounding can be wrong.
pub(super) fn widened(radius: i32) -> i32 {
    radius + (radius >> 10) + 64
}

impl ScreenAxis {
    /// The columns in which a cylinder with rounded ends can be met.
    pub(super) fn capsule_columns(
        &self,
        way: Vector,
        half_axis: Vector,
        radius: i32,
    ) -> Option<Columns> {
        let ends = [way.plus(half_axis), way.minus(half_axis)];
        // An end behind the picture has no columns, but what lies between may be seen.
        if ends.iter().any(|end| end.dot(self.ahead) <= radius) {
            return Some(Columns::ALL);
        }
        let [a, b] = ends.map(|end| self.sphere_bounds(end, radius));
        self.visible(a.with(b))
    }

    /// The columns in which a sphere can be met.
    pub(super) fn sphere_columns(&self, way: Vector, radius: i32) -> Option<Columns> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            // Around the origin, or reaching behind it.
            return (ahead >= -radius).then_some(Columns::ALL);
        }
        self.visible(self.sphere_bounds(way, radius))
    }

    /// The columns between the tangents to a sphere that is ahead, as seen along the columns.
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

    /// The columns in which the highest and the lowest point of a sphere that is ahead are seen,
    /// rounded down; `rows` is the screen_axis along the rows.
    ///
    /// Those points are where the planes of the rows that touch the sphere touch it, so they are as
    /// far aside as its middle, and t (a t ± b r) / (a² + b²) ahead, where it is a ahead and b down,
    /// and t long are the tangents to the circle that it is seen as along the rows.
    pub(super) fn tips(&self, rows: &ScreenAxis, way: Vector, radius: i32) -> Option<[i32; 2]> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            return None;
        }
        let (aside, down) = (i64::from(way.dot(self.aside)), way.dot(rows.aside));
        let square = wide(ahead, ahead) + wide(down, down);
        let tangent = square_root(unsigned_wide(square - wide(radius, radius)));
        let (along, across) = (wide(ahead, tangent), wide(down, radius));
        // The square to 30 bits.
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

    /// Columns that can be seen, or that are traced beside the picture.
    fn visible(&self, columns: Columns) -> Option<Columns> {
        let end = signed(self.width + LONGEST_STRIDE);
        (columns.last >= 0 && columns.first < end).then_some(columns)
    }

    /// How many half pixels a unit of a numerator over this denominator is.
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

    /// The column of a ray whose tangent has this numerator, rounded down and held near the
    /// picture.
    fn column(&self, numerator: i64, scale: Quotient) -> i32 {
        let size = numerator.unsigned_abs();
        let drop = 32_u32.saturating_sub(size.leading_zeros());
        let product = (size >> drop) * u64::from(scale.mantissa);
        // Further to the side than any picture is wide.
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
