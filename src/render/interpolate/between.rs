//! Floor 7: the colours between two traced pixels of a block: interpolated, or divided further.

use super::{Colors, End, Marks, SHORTEST, SLOTS, UNREAD};
use crate::accel::World;
use crate::color::{Bend, Parabola};
use crate::render::Quality;
use crate::shade::Samples;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Progress, Stops};

/// Number of times that a block is divided at most before what is left of it is traced.
pub(super) const DIVISIONS: usize = 2;

impl<W: World, K: Shading, Q: Quality, M: Marks> Colors<'_, '_, W, K, Q, M> {
    /// Computes the colours of `length` pixels from the traced pixel at column `first` up to the traced pixel after
    /// the last. `ends` are these two.
    pub(super) fn between(
        &mut self,
        (first, length): (u32, u32),
        ends: [&End; 2],
        mut known: Known,
    ) {
        let [start, end] = ends;
        self.set(first, start.traced.sum, start.traced.signature);
        if length == 1 {
            return;
        }
        let is_alike = start.traced.signature.is_same_as(end.traced.signature);
        let columns = [first, first + length];
        if let (Known::Part(proved, _), true) = (&mut known, is_alike && length >= SHORTEST) {
            let stops = hits(&self.stops, ends);
            let between = (&self.window, columns);
            if self.tracer.is_steady(between, stops, proved) {
                known = Known::Steady(Bend::ZERO, proved.samples);
            }
        }
        match known {
            Known::Part(proved, divisions) => {
                // Parts of it would be too short to prove anything.
                if length <= SHORTEST || divisions == DIVISIONS {
                    return self.trace_each(first + 1, first + length);
                }
                self.divide(columns, ends, (proved, divisions));
            }
            Known::Steady(expected, samples) => {
                self.interpolate((first, length), ends, is_alike, (expected, samples));
            }
        }
    }

    /// Computes the colours between two traced pixels that do not show the same: up to a border between them, if
    /// one is known, and from there on; else of both halves.
    #[inline(always)]
    fn divide(
        &mut self,
        [first, last]: [u32; 2],
        [start, end]: [&End; 2],
        (proved, divisions): (Progress, usize),
    ) {
        let known = Known::Part(proved, divisions + 1);
        let slot = 2 + divisions;
        let stops = hits(&self.stops, [start, end]);
        let between = (&self.window, [first, last]);
        let Some(before) = self.tracer.border(between, stops, &proved) else {
            let half = (last - first) / 2;
            let middle = self.trace(first + half, slot);
            self.between((first, half), [start, &middle], known);
            return self.between((first + half, last - first - half), [&middle, end], known);
        };
        if first < before {
            let middle = self.trace(before, slot);
            self.between((first, before - first), [start, &middle], known);
            self.set(before, middle.traced.sum, middle.traced.signature);
        }
        if before + 1 < last {
            let middle = self.trace(before + 1, slot);
            self.between((before + 1, last - before - 1), [&middle, end], known);
        }
    }

    /// Computes the colours between two traced pixels of one path, or, unless `is_alike`, of paths that differ in
    /// what cannot be seen. The second difference of the three is expected to be this. `samples` says how
    /// many have to be traced at least.
    #[inline(always)]
    fn interpolate(
        &mut self,
        (first, length): (u32, u32),
        ends: [&End; 2],
        is_alike: bool,
        (expected, samples): (Bend, Samples),
    ) {
        let [start, end] = ends;
        let is_smooth = is_alike && samples == Samples::Three;
        if length == 2 {
            // Traced, if the expected second difference is more than four times the tolerance.
            let is_flat = expected.is_within(4 * Self::TOLERANCE);
            let (sum, path) = match is_smooth && is_flat {
                true => (
                    start.traced.sum.half_way(end.traced.sum, expected),
                    start.traced.signature,
                ),
                false => {
                    let traced = self.trace(first + 1, UNREAD).traced;
                    (traced.sum, traced.signature)
                }
            };
            return self.set(first + 1, sum, path);
        }
        let half = length / 2;
        let middle = self.trace(first + half, UNREAD);
        let sums = [start, &middle, end].map(|it| it.traced.sum);
        let curve = Parabola::through(sums, half, length);
        let bend = curve.bend(half);
        if is_smooth && bend.less(expected).is_within(4 * Self::TOLERANCE) {
            let place = Self::place(first);
            self.marks
                .fill(place, length as usize, start.traced.signature);
            return self.colors.set_curve(place, length, curve);
        }
        for (first, length, ends) in [
            (first, half, [start, &middle]),
            (first + half, length - half, [&middle, end]),
        ] {
            let expected = curve.bend((length / 2).max(1));
            self.between(
                (first, length),
                ends,
                Known::Steady(expected, Samples::Three),
            );
        }
    }
}

/// Returns what the paths of two traced pixels hit.
#[inline(always)]
fn hits<'a>(stops: &'a [Stops; SLOTS], ends: [&End; 2]) -> [&'a Stops; 2] {
    ends.map(|end| &stops[end.slot.min(UNREAD)])
}

/// What is known of the paths between two traced ones.
#[derive(Clone, Copy)]
pub(super) enum Known {
    /// Not all of it, after so many divisions of the block.
    Part(Progress, usize),
    /// All surely meet the same. The second difference of three traced pixels is expected to be this. At least so
    /// many pixels are traced.
    Steady(Bend, Samples),
}

impl Known {
    /// Nothing is known of a block.
    pub(super) const NOTHING: Self = Self::Part(Progress::NONE, 0);
}
