//! Bounds the error of interpolated pixels, if the colours of the traced pixels were exact. This file
//! knows one row of colours and no paths.
//!
//! A row is divided into aligned blocks. A block is divided until all paths of a part surely meet the same: at a
//! border that is known, or else in halves. A part of three or more pixels is then a parabola through its start,
//! middle and end. The middle of a part of two pixels is half way between both ends, or moved by the bend of the part
//! around. Where borders lie is not known here. So the bound is the largest over all parts into which a block may be
//! divided.

use std::{vec, vec::Vec};

use super::{Ending, Stage, Vector, largest};

/// Length of the shortest part of which it is found out what lies between; of a block of 8, it is half the block.
/// Halves of a part are shorter.
const SHORTEST: usize = 8;

/// Returns `slacks[length][start]` for all parts of a row up to the length of a block: a bound of the difference between a
/// combination of the part's colours in exact numbers and in fixed point. It is eight times the largest rounding error
/// of the columns from one length before the part to one length after it, and 2⁻¹⁶.
pub(super) fn slacks(row: &[&Stage], block: usize) -> Vec<Vec<f64>> {
    let slack = |column: usize| 8.0 * row[column.min(row.len() - 1)].rounding + f64::exp2(-16.0);
    let mut slacks = vec![(0..row.len()).map(slack).collect::<Vec<_>>()];
    for length in 1..=block {
        // The columns around a part that is one column shorter, and the three that are added.
        let widened = slacks[length - 1].iter().enumerate().map(|(start, most)| {
            let end = start + 2 * length;
            let added = [start.saturating_sub(length), end - 1, end].map(slack);
            added.into_iter().fold(*most, f64::max)
        });
        slacks.push(widened.collect());
    }
    slacks
}

/// Returns the largest interpolation error that the pixel in column `x` of a row may have, and
/// whether rounding may decide what the paths around meet.
pub(super) fn error(
    (row, slacks): (&[&Stage], &[Vec<f64>]),
    x: usize,
    ending: &Ending,
) -> (f64, bool) {
    let block = ending.block as usize;
    let start = x - x % block.max(1);
    let end = (start + block).min(row.len() - 1);
    // Both ends of a block are traced.
    if start == x || end <= x {
        return (0.0, false);
    }
    let is_alike = |at: &usize| row[*at].is_unsure || row[*at].open_trail == row[x].open_trail;
    let first = (start..x).rev().take_while(is_alike).last().unwrap_or(x);
    let last = (x + 1..=end).take_while(is_alike).last().unwrap_or(x);
    if first == x || last == x {
        return (0.0, false);
    }
    let is_unsure = row[first..=last].iter().any(|it| it.is_unsure);
    let colors: Vec<_> = row[..=last].iter().map(|it| it.color_in(row[x])).collect();
    let shortest = SHORTEST.min(block / 2);
    let mut worst: f64 = 0.0;
    for start in first..x {
        for end in (x + 1).max(start + shortest)..=last {
            let part = Part {
                colors: &colors,
                slacks,
                x,
                start,
                length: end - start,
                tolerance: ending.tolerance,
                expected: None,
            };
            worst = worst.max(part.worst());
        }
    }
    (worst, is_unsure)
}

impl Stage {
    /// Returns the colour that this path would have if it met checkers in the same kinds of cells as the path `cells`.
    fn color_in(&self, cells: &Self) -> Vector {
        let pairs = self.cells.iter().zip(&cells.cells);
        let other = pairs.filter(|((kind, _), (wanted, _))| kind != wanted);
        other.fold(Vector(self.color), |color, ((_, change), _)| {
            color - *change
        })
    }
}

/// A part of a block: the columns from one traced pixel to another. All its paths meet the same.
struct Part<'a> {
    /// The colours that the columns have in the cells of checkers that the asked column shows.
    colors: &'a [Vector],
    slacks: &'a [Vec<f64>],
    /// The column of which the error is asked.
    x: usize,
    start: usize,
    length: usize,
    tolerance: f64,
    /// The second difference at a distance of half the length, as the part around has it, of which this is a half.
    expected: Option<Vector>,
}

impl Part<'_> {
    /// Returns the largest error of the column if it is interpolated from this part or from a half of it, a half of
    /// that, and so on.
    fn worst(self) -> f64 {
        let (x, own) = (self.x, self.error());
        let half = self.length / 2;
        let middle = self.start + half;
        if self.length == 2 || x == middle {
            return own;
        }
        let (start, length) =
            if x < middle { (self.start, half) } else { (middle, self.length - half) };
        let part = Self {
            start,
            length,
            expected: Some(self.bend_at((length / 2).max(1))),
            ..self
        };
        own.max(part.worst())
    }

    /// Returns the colours at the start, in the middle and at the end.
    fn colors(&self) -> [Vector; 3] {
        [0, self.length / 2, self.length].map(|place| self.colors[self.start + place])
    }

    /// Returns the slope up to the middle, and by how much the slope after it differs, for each column.
    fn slopes(&self) -> [Vector; 2] {
        let [start, middle, end] = self.colors();
        let half = self.length / 2;
        let before = (middle - start) * (1.0 / half as f64);
        let after = (end - middle) * (1.0 / (self.length - half) as f64);
        [before, (after - before) * (1.0 / self.length as f64)]
    }

    /// Returns the second difference at this distance.
    fn bend_at(&self, distance: usize) -> Vector {
        let distance = distance as f64;
        self.slopes()[1] * (2.0 * distance * distance)
    }

    /// Returns the largest error of the column if it is interpolated from this part, 0 if it cannot be.
    fn error(&self) -> f64 {
        let (x, [start, middle, end]) = (self.x, self.colors());
        let miss = |color: Vector| largest(color - self.colors[x]) + self.slack();
        if self.length > 2 {
            let (way, half) = ((x - self.start) as f64, (self.length / 2) as f64);
            let [slope, change] = self.slopes();
            let curve = start + slope * way + change * (way * (way - half));
            let is_exact =
                |expected: Vector| self.allows(self.bend_at(self.length / 2) - expected, 4.0);
            let is_taken = is_exact(Vector::ZERO) || self.expected.is_some_and(is_exact);
            return if is_taken { miss(curve) } else { 0.0 };
        }
        let half_way = |bend: Vector| (start + end) * 0.5 - bend * 0.5;
        debug_assert!(middle == self.colors[x]);
        let is_even = self.allows(end - start, 3.0);
        let line = if is_even { miss(half_way(Vector::ZERO)) } else { 0.0 };
        match self.expected {
            Some(bend) if is_even || self.allows(bend, 4.0) => line.max(miss(half_way(bend))),
            _ => line,
        }
    }

    /// Returns by how much rounding may move a combination of the part's colours; see [`slacks`].
    fn slack(&self) -> f64 {
        self.slacks[self.length][self.start]
    }

    /// Tests whether fixed point may take `difference` for at most `tolerances` times the tolerance. It
    /// compares with sums of colours, which are 255/256 of the colours.
    fn allows(&self, difference: Vector, tolerances: f64) -> bool {
        largest(difference) <= tolerances * self.tolerance * (256.0 / 255.0) + self.slack()
    }
}
