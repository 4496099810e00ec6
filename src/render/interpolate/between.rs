//! Floor 7: the colours between two traced pixels of a block: interpolated, or divided further.

use super::{Colors, EARNED, End, Marks, SHORTEST, SLOTS, Sink, UNREAD};
use crate::accel::World;
use crate::color::{Bend, Parabola};
use crate::qualities::Quality;
use crate::shade::Samples;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Progress, Stops};

impl<W: World, K: Shading, Q: Quality, M: Marks> Colors<'_, '_, W, K, Q, M> {
    /// Sets the colours of all columns between two. `ends` are the traced pixels at these two columns, whose own colours
    /// the caller sets.
    pub(super) fn between(
        &mut self,
        [mut first, last]: [u32; 2],
        [outer, end]: [&End; 2],
        mut proved: Progress,
        sink: &mut impl Sink,
    ) {
        let mut start = *outer;
        while first + 1 < last {
            let ends = [&start, end];
            if self.is_steady([first, last], ends, &mut proved) {
                let samples = proved.samples;
                match proved.cells {
                    Some(level) if W::NEEDS.checkers => {
                        self.tiles([first, last], ends, (level, samples), sink);
                    }
                    _ => {
                        self.interpolate([first, last], ends, (Bend::ZERO, samples), sink);
                    }
                }
                break;
            }
            let Some([before, after]) = self.border([first, last], ends, &proved) else {
                self.trace_all([first, last], ends, sink);
                break;
            };
            let mut middle = start;
            if first < before {
                middle = self.traced_end(before, sink);
                self.between([first, before], [&start, &middle], proved, sink);
                self.release(&start, outer);
            }
            if before < after {
                self.release(&middle, outer);
                if after == last {
                    return;
                }
                middle = self.traced_end(after, sink);
            }
            (first, start) = (after, middle);
        }
        self.release(&start, outer);
    }

    /// Traces each pixel between two traced ones. If all of them surely show one ball first, their rays are tested against
    /// that ball only.
    #[inline(always)]
    fn trace_all(&mut self, [first, last]: [u32; 2], ends: [&End; 2], sink: &mut impl Sink) {
        if self.tracer.finds_balls() && last - first >= SHORTEST {
            let between = (&self.window, [first, last]);
            self.tracer.find_ball(between, hits(&self.stops, ends));
        }
        self.trace_each(first + 1, last, sink);
        self.tracer.forget_ball();
    }

    /// Tests whether all paths between two traced pixels surely meet the same shapes, lit by the same lights. Returns
    /// `false` without a proof if there are few pixels between, or if too many proofs have failed in the block.
    #[inline(always)]
    fn is_steady(&mut self, columns: [u32; 2], ends: [&End; 2], proved: &mut Progress) -> bool {
        let (between, stops) = ((&self.window, columns), hits(&self.stops, ends));
        let is_long = columns[1] - columns[0] >= SHORTEST;
        if !is_long || self.credit == 0 || !is_alike(ends) {
            return false;
        }
        self.credit -= 1;
        let is_steady = self.tracer.is_steady(between, stops, proved);
        self.credit += EARNED * u32::from(is_steady);
        is_steady
    }

    /// Returns where to divide the pixels between two traced ones that do not surely show the same: the columns before and
    /// after a border if one is known, else the middle twice. `None` if each pixel has to be traced.
    #[inline(always)]
    fn border(
        &mut self,
        columns: [u32; 2],
        ends: [&End; 2],
        proved: &Progress,
    ) -> Option<[u32; 2]> {
        let [first, last] = columns;
        // Parts of it would be too short to prove anything, or nothing more is proved.
        if last - first <= SHORTEST || self.free == 0 || self.credit == 0 {
            return None;
        }
        let (between, stops) = ((&self.window, columns), hits(&self.stops, ends));
        if let Some(before) = self.tracer.border(between, stops, proved) {
            return Some([before, before + 1]);
        }
        let may_prove = ends.iter().any(|end| end.traced.signature.is_bounded());
        may_prove.then_some([first + (last - first) / 2; 2])
    }

    /// Traces the pixel of a column, sets its colour, and stores its hits in a free slot. There is one.
    #[inline(never)]
    fn traced_end(&mut self, column: u32, sink: &mut impl Sink) -> End {
        let slot = self.free.trailing_zeros();
        self.free &= !(1 << slot);
        let end = self.trace(column, slot as usize);
        self.set(column, end.traced, sink);
        end
    }

    /// Frees the slot of a traced pixel, unless the pixel is `outer`, whose slot the caller frees.
    #[inline(always)]
    fn release(&mut self, end: &End, outer: &End) {
        if end.slot != outer.slot {
            self.free |= 1 << end.slot;
        }
    }

    /// Computes the colours between two traced pixels of one path, or of paths that differ in what cannot be seen. The
    /// second difference of the three is expected to be this. `samples` says how many have to be traced at least. Returns
    /// whether one parabola gives them all.
    fn interpolate(
        &mut self,
        [first, last]: [u32; 2],
        ends: [&End; 2],
        (expected, samples): (Bend, Samples),
        sink: &mut impl Sink,
    ) -> bool {
        let ([start, end], length) = (ends, last - first);
        let is_smooth = is_alike(ends) && samples == Samples::Three;
        if length < 2 {
            return true;
        }
        if length == 2 {
            // Traced, if the expected second difference is more than four times the tolerance.
            let mut middle = start.traced;
            if is_smooth && expected.is_within(4 * Self::TOLERANCE) {
                middle.sum = middle.sum.half_way(end.traced.sum, expected)
            } else {
                middle = self.trace(first + 1, UNREAD).traced
            }
            self.set(first + 1, middle, sink);
            return true;
        }
        let half = length / 2;
        let middle = self.trace(first + half, UNREAD);
        let sums = [start, &middle, end].map(|it| it.traced.sum);
        let curve = Parabola::through(sums, half, length);
        let off = curve.bend(half).less(expected);
        // Between its three traced pixels, a parabola over so many columns may be further off.
        let most = if length > 32 { 2 } else { 4 };
        if is_smooth && off.is_within(most * Self::TOLERANCE) {
            self.marks.fill(first, length, start.traced.signature);
            sink.set_curve(first, length, curve);
            return true;
        }
        // Four columns that bend so far off say nothing of those between, which are traced.
        let is_rough = length <= 4 && !off.is_within(8 * Self::TOLERANCE);
        let least = if is_rough { Samples::Five } else { Samples::Three };
        let bends = [half, length - half].map(|length| curve.bend((length / 2).max(1)));
        let (before, after) = ([first, first + half], [first + half, last]);
        let (one, other) = ([start, &middle], [&middle, end]);
        let is_even = self.interpolate(before, one, (bends[0], least), sink);
        self.set(first + half, middle.traced, sink);
        // A half may bend as expected by chance. So it is divided once more if the other one does not.
        let samples = if is_even { least } else { Samples::Five };
        let is_other = self.interpolate(after, other, (bends[1], samples), sink);
        if is_even && !is_other {
            self.interpolate(before, one, (bends[0], Samples::Five), sink);
        }
        false
    }
}

/// Tests whether the paths of two traced pixels hit the same shapes and lights, and have known bounds.
#[inline(always)]
fn is_alike([start, end]: [&End; 2]) -> bool {
    start.traced.signature.is_same_as(end.traced.signature)
}

/// Returns what the paths of two traced pixels hit.
#[inline(always)]
pub(super) fn hits<'a>(stops: &'a [Stops; SLOTS], ends: [&End; 2]) -> [&'a Stops; 2] {
    ends.map(|end| &stops[end.slot.min(UNREAD)])
}
