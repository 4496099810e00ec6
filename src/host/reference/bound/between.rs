//! Bounds the error of interpolated pixels, if the colours of the traced pixels were exact. This file
//! knows one row of colours and no paths.
//!
//! A row is divided into aligned blocks. A block is halved until all paths of a part surely meet the same.
//! A part of four or more pixels is then a parabola through its start, middle and end. The middle of a
//! part of two pixels is half way between both ends, or moved by the bend of the part around.

use super::{Stage, Vector, largest};

/// Returns the largest interpolation error that the pixel in column `x` of a row may have. Returns `None`
/// if rounding may decide whether the paths around meet the same.
pub(super) fn error(row: &[&Stage], x: usize, block: usize, tolerance: f64) -> Option<f64> {
    let mut worst: f64 = 0.0;
    let mut around = None;
    for bits in (1..=block.max(1).ilog2()).rev() {
        let length = 1 << bits;
        let start = x - x % length;
        // The start of a part is traced or belongs to a longer part. Beyond the row, all is traced.
        if start == x || start + length >= row.len() {
            continue;
        }
        let part = Part {
            row,
            start,
            length,
            tolerance,
            around,
        };
        match part.sameness(x) {
            Sameness::Other => around = None,
            Sameness::Unsure => return None,
            Sameness::Same => {
                worst = worst.max(part.error(x));
                around = Some(part.bend());
            }
        }
    }
    Some(worst)
}

/// A part of a block: the columns from one traced pixel to another, a power of two.
struct Part<'a> {
    row: &'a [&'a Stage],
    start: usize,
    length: usize,
    tolerance: f64,
    /// The second difference of the part that is twice as long, if all its paths meet the same.
    around: Option<Vector>,
}

/// Whether all paths of a part meet the same as one of them.
enum Sameness {
    Same,
    /// They do, but for some paths rounding decides what they meet.
    Unsure,
    Other,
}

impl Part<'_> {
    /// Returns whether all paths of the part meet the same as that of pixel `x`.
    fn sameness(&self, x: usize) -> Sameness {
        let part = &self.row[self.start..=self.start + self.length];
        let is_alike = |it: &&Stage| it.trail == self.row[x].trail;
        if !part.iter().all(|it| it.is_unsure || is_alike(it)) {
            return Sameness::Other;
        }
        match part.iter().any(|it| it.is_unsure) {
            true => Sameness::Unsure,
            false => Sameness::Same,
        }
    }

    /// Returns the colour of a column.
    fn color(&self, column: usize) -> Vector {
        Vector(self.row[column].color)
    }

    /// Returns the colours at the start, in the middle and at the end.
    fn colors(&self) -> [Vector; 3] {
        [0, 1, 2].map(|half| self.color(self.start + half * self.length / 2))
    }

    /// Returns the second difference of these three colours.
    fn bend(&self) -> Vector {
        let [start, middle, end] = self.colors();
        (end - middle) - (middle - start)
    }

    /// Returns the largest error of pixel `x` if it is interpolated from this part, 0 if it cannot be.
    fn error(&self, x: usize) -> f64 {
        let [start, middle, end] = self.colors();
        let expected = self.around.map(|bend| bend * 0.25);
        let miss = |color: Vector| largest(color - self.color(x)) + self.slack();
        if self.length > 2 {
            let way = (x - self.start) as f64 / self.length as f64;
            let curve = start + (end - start) * way - self.bend() * (2.0 * way * (1.0 - way));
            let is_exact = |expected: Vector| self.allows(self.bend() - expected, 4.0);
            let is_taken = is_exact(Vector::ZERO) || expected.is_some_and(is_exact);
            return if is_taken { miss(curve) } else { 0.0 };
        }
        let half_way = |bend: Vector| (start + end) * 0.5 - bend * 0.5;
        debug_assert!(middle == self.color(x));
        let is_even = self.allows(end - start, 3.0);
        let line = if is_even {
            miss(half_way(Vector::ZERO))
        } else {
            0.0
        };
        match expected {
            Some(bend) if is_even || self.allows(bend, 4.0) => line.max(miss(half_way(bend))),
            _ => line,
        }
    }

    /// Returns a bound of the difference between a combination of colours in exact numbers and in fixed
    /// point: eight times the largest rounding error of the colours around, and 2⁻¹⁶.
    fn slack(&self) -> f64 {
        let first = self.start.saturating_sub(self.length);
        let last = (self.start + 2 * self.length).min(self.row.len() - 1);
        let rounding = self.row[first..=last].iter().map(|it| it.rounding);
        8.0 * rounding.fold(0.0, f64::max) + f64::exp2(-16.0)
    }

    /// Tests whether fixed point may take `difference` for at most `tolerances` times the tolerance. It
    /// compares with sums of colours, which are 255/256 of the colours.
    fn allows(&self, difference: Vector, tolerances: f64) -> bool {
        largest(difference) <= tolerances * self.tolerance * (256.0 / 255.0) + self.slack()
    }
}
