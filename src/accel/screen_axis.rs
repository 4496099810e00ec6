//! The columns of pixels that a ball or a capsule can cover. The camera is looked at along the columns,
//! so the problem is two-dimensional: the shape lies between its two tangents. Rows are treated in the
//! same way. All bounds are widened by more than the rounding error.

use crate::number::{signed, square_root, unsigned_wide};
use crate::ray::ScreenAxis;
use crate::vector::Vector;

/// A range of pixel columns in which rays can hit a shape. Columns outside of the picture may be
/// included.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Columns {
    pub(crate) first: i32,
    pub(crate) last: i32,
}

impl Columns {
    /// All columns. Used where nothing is known about a shape.
    pub(crate) const ALL: Self = Self {
        first: 0,
        last: i32::MAX,
    };

    /// Returns a single column.
    pub(crate) const fn at(column: i32) -> Self {
        Self {
            first: column,
            last: column,
        }
    }

    /// Returns the smallest range that holds both ranges.
    fn with(self, other: Self) -> Self {
        Self {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }
}

/// Returns a radius enlarged by more than the rounding error of the bounds: 2⁻¹⁰ of it and 64 steps.
pub(super) const fn widened(radius: i32) -> i32 {
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

    /// Returns the columns in which rays can hit the convex hull of balls of the same radius, `None` if the picture does
    /// not show them. `ways` are the vectors from the eye to their centres.
    pub(super) fn hull_columns(
        &self,
        ways: impl Iterator<Item = Vector> + Clone,
        radius: i32,
    ) -> Option<Columns> {
        let mut aheads = ways.clone().map(|way| way.dot(self.ahead));
        if aheads.clone().any(|ahead| ahead <= radius) {
            return aheads.any(|ahead| ahead >= -radius).then_some(Columns::ALL);
        }
        let columns = ways.map(|way| self.sphere_bounds(way, radius));
        self.visible(columns.reduce(Columns::with)?)
    }

    /// Returns the columns in which rays can hit a sphere, `None` if the picture does not show them.
    ///
    /// `way` is the vector from the eye to the sphere's centre.
    pub(super) fn sphere_columns(&self, way: Vector, radius: i32) -> Option<Columns> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            // A part of the sphere, or all of it, is not in front of the eye.
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
        let [first, last] = self.sixteenths(ahead * aside, spread, scale);
        Columns {
            first: (first >> 4) - 1,
            last: (last >> 4) + 2,
        }
    }

    /// Returns a range that cuts the picture or the column to the right of it, where smooth edges have corners, else `None`.
    fn visible(&self, columns: Columns) -> Option<Columns> {
        (columns.last >= 0 && columns.first <= signed(self.width)).then_some(columns)
    }
}
