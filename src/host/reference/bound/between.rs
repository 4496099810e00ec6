//! Bounds the error of interpolated pixels, if the colours of the traced pixels were exact. This file
//! knows one row of colours and no paths.
//!
//! A stretch goes from one pixel that is always traced to the next, two or four columns on. In a stretch
//! of four, the pixel half way may be traced as well. Then the two pixels at the quarters are moved by
//! three quarters of the curve's error half way, or taken as the middle of a line, or traced, too.

use super::{Stage, Vector, largest};

/// Returns the largest interpolation error that the pixel in column `x` of a row may have.
pub(super) fn error(row: &[&Stage], x: usize, stride: usize, tolerance: f64) -> f64 {
    let place = x % stride.max(1);
    let start = x - place;
    if place == 0 || start + stride >= row.len() {
        return 0.0;
    }
    let stretch = Stretch {
        row,
        start,
        stride,
        tolerance,
    };
    let alike = |column: usize| row[column].trail == row[start].trail;
    let color = |column: usize| Vector(row[column].color);
    let (here, middle, end) = (color(x), start + 2, start + stride);
    let miss = |color: Vector| largest(color - here);
    let mut worst: f64 = 0.0;
    for (bends, is_exact) in stretch.bends().into_iter().flatten() {
        if !alike(end) {
            break;
        }
        let curve = |column: usize| stretch.curve(bends, column);
        if is_exact {
            worst = worst.max(miss(curve(x)));
        }
        if stride == 4 && place != 2 && alike(middle) {
            let missed = color(middle) - curve(middle);
            if stretch.allows(missed, 1.0) {
                worst = worst.max(miss(curve(x) + missed * 0.75));
            }
        }
    }
    // The pixel may be the middle of a line between its two neighbours.
    let (left, right) = (color(x - 1), color(x + 1));
    let is_line = stride == 2 || place != 2;
    if is_line && row[x - 1].trail == row[x + 1].trail {
        let way = right - left;
        if stretch.allows(way, 3.0) {
            worst = worst.max(miss(left + way * 0.5));
        }
        if let (3, 4, Some(beyond)) = (place, stride, row.get(end + stride)) {
            // The bend as in `Bend::of_uneven`; the pixel is moved by an eighth of it.
            let far = Vector(beyond.color) - right;
            let bend = (far - way * 2.0) * 0.3125;
            if row[x + 1].trail == beyond.trail && stretch.allows(bend, 4.0) {
                worst = worst.max(miss(left + way * 0.5 + bend * -0.125));
            }
        }
    }
    worst + stretch.slack()
}

/// A stretch of a row: the columns from one pixel that is always traced to the next.
struct Stretch<'a> {
    row: &'a [&'a Stage],
    start: usize,
    stride: usize,
    tolerance: f64,
}

impl Stretch<'_> {
    /// Returns a bound of the difference between a combination of colours in exact numbers and in fixed
    /// point: eight times the largest rounding error of the colours around, and 2⁻¹⁸.
    fn slack(&self) -> f64 {
        let first = self.start.saturating_sub(self.stride);
        let last = (self.start + 2 * self.stride).min(self.row.len() - 1);
        let rounding = self.row[first..=last].iter().map(|it| it.rounding);
        8.0 * rounding.fold(0.0, f64::max) + f64::exp2(-18.0)
    }

    /// Tests whether fixed point may take `difference` for at most `tolerances` times the tolerance.
    fn allows(&self, difference: Vector, tolerances: f64) -> bool {
        largest(difference) <= tolerances * self.tolerance + self.slack()
    }

    /// Returns the second difference of the colours one stride before, at and one stride after a column,
    /// or `None` if a column is outside the row.
    fn bend(&self, column: usize) -> Option<Vector> {
        let color = |column: usize| Some(Vector(self.row.get(column)?.color));
        let before = color(column.checked_sub(self.stride)?)?;
        let (middle, after) = (color(column)?, color(column + self.stride)?);
        Some((after - middle) - (middle - before))
    }

    /// Returns the pairs of bends that fixed point may use for the curve. The flag tells whether it may
    /// then accept the curve without tracing the pixel half way.
    ///
    /// Fixed point has a bend if the signatures of the paths around it are equal. Trails do not decide
    /// that exactly: a signature depends on more than the hits, and not on lights too faint for the
    /// formats.
    fn bends(&self) -> [Option<([Vector; 2], bool)>; 4] {
        let [first, last] = [self.start, self.start + self.stride].map(|it| self.bend(it));
        let one = |bend: Vector| ([bend; 2], self.allows(bend, 2.0));
        let both = |(first, last)| ([first, last], self.allows(last - first, 1.0));
        [
            first.zip(last).map(both),
            first.map(one),
            last.map(one),
            Some(([Vector::ZERO; 2], false)),
        ]
    }

    /// Returns the colour at a column of the cubic through both ends of the stretch, with these second
    /// differences at the ends.
    fn curve(&self, [first, last]: [Vector; 2], column: usize) -> Vector {
        let way = (column - self.start) as f64 / self.stride as f64;
        let ends = [self.start, self.start + self.stride];
        let [start, end] = ends.map(|column| Vector(self.row[column].color));
        let sag = way * (1.0 - way) / 6.0;
        let bend = first * (2.0 - way) + last * (1.0 + way);
        start + (end - start) * way - bend * sag
    }
}
