//! What pixels that are taken from their neighbours' colours are off by, were those exact; it knows
//! one row, and no path.
//!
//! A stretch goes from one pixel that is traced to the next, two or four further on. Of four, the
//! pixel half way may be traced, and then the two at the quarters may be moved by three quarters of
//! what the curve misses it by, or taken for the middle of a line, or be traced themselves.

use super::{Stage, Vector, largest};

/// The most that the pixel `x` may be off by.
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
    // The middle of a line, between two pixels beside it.
    let (left, right) = (color(x - 1), color(x + 1));
    let is_line = stride == 2 || place != 2;
    if is_line && row[x - 1].trail == row[x + 1].trail {
        let way = right - left;
        if stretch.allows(way, 3.0) {
            worst = worst.max(miss(left + way * 0.5));
        }
        if let (3, 4, Some(beyond)) = (place, stride, row.get(end + stride)) {
            // `Bend::of_uneven`, of which the pixel is moved by an eighth.
            let far = Vector(beyond.color) - right;
            let bend = (far - way * 2.0) * 0.3125;
            if row[x + 1].trail == beyond.trail && stretch.allows(bend, 4.0) {
                worst = worst.max(miss(left + way * 0.5 + bend * -0.125));
            }
        }
    }
    worst + stretch.slack()
}

/// A stretch of a row.
struct Stretch<'a> {
    row: &'a [&'a Stage],
    start: usize,
    stride: usize,
    tolerance: f64,
}

impl Stretch<'_> {
    /// How far apart exact colours and those of fixed point may be when they are put together.
    fn slack(&self) -> f64 {
        let first = self.start.saturating_sub(self.stride);
        let last = (self.start + 2 * self.stride).min(self.row.len() - 1);
        let rounding = self.row[first..=last].iter().map(|it| it.rounding);
        8.0 * rounding.fold(0.0, f64::max) + f64::exp2(-18.0)
    }

    /// Whether so much may pass for no more than so many tolerances.
    fn allows(&self, difference: Vector, tolerances: f64) -> bool {
        largest(difference) <= tolerances * self.tolerance + self.slack()
    }

    /// How much the colours bend at a column, if there are any before and behind.
    fn bend(&self, column: usize) -> Option<Vector> {
        let color = |column: usize| Some(Vector(self.row.get(column)?.color));
        let before = color(column.checked_sub(self.stride)?)?;
        let (middle, after) = (color(column)?, color(column + self.stride)?);
        Some((after - middle) - (middle - before))
    }

    /// By which bends the curve may be laid, and whether it may then pass without a look half way.
    ///
    /// Fixed point knows a bend where the paths around it went alike. That is not quite known here: it
    /// tells paths apart by more than what they met, and does not by lights too faint for its formats.
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

    /// The cubic through both ends that bends so at each, at a column.
    fn curve(&self, [first, last]: [Vector; 2], column: usize) -> Vector {
        let way = (column - self.start) as f64 / self.stride as f64;
        let ends = [self.start, self.start + self.stride];
        let [start, end] = ends.map(|column| Vector(self.row[column].color));
        let sag = way * (1.0 - way) / 6.0;
        let bend = first * (2.0 - way) + last * (1.0 + way);
        start + (end - start) * way - bend * sag
    }
}
