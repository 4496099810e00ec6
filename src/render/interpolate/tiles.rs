//! Floor 7: the colours of a stretch that shows several cells of a plane's checker. Each of the checker's two colours is
//! interpolated over the whole stretch, and each pixel shows that of its cell.

use super::between::hits;
use super::{Colors, End, Marks, SCRATCH, Sink};
use crate::accel::World;
use crate::color::{Bend, Parabola, Sum};
use crate::qualities::Quality;
use crate::ray::PathSignature;
use crate::shade::Samples;
use crate::shade::highlight::sealed::Shading;
use crate::trace::Cells;

/// What all pixels of such a stretch have in common.
struct Tiles {
    cells: Cells,
    /// The hit that shows the checker.
    level: usize,
    /// Whether the first column shows the checker's colour, and its path.
    start: (bool, PathSignature),
}

impl<W: World, K: Shading, Q: Quality, M: Marks> Colors<'_, '_, W, K, Q, M> {
    /// Sets the colours between two traced pixels whose paths surely meet the same, but for the cells of a checker at this
    /// hit. `samples` says how many have to be traced at least.
    #[inline(never)]
    pub(super) fn tiles(
        &mut self,
        columns: [u32; 2],
        ends: [&End; 2],
        (level, samples): (usize, Samples),
        sink: &mut impl Sink,
    ) {
        let cells = self.tracer.cells(columns, hits(&self.stops, ends), level);
        let (start, both) = (ends[0], ends.map(|end| self.both(end, level)));
        let (Some(cells), [Some((holds, one)), Some((_, other))]) = (cells, both) else {
            return self.trace_each(columns[0] + 1, columns[1], sink);
        };
        let tiles = Tiles {
            cells,
            level,
            start: (holds, start.traced.signature),
        };
        let expected = ([Bend::ZERO; 2], samples);
        self.tile(&tiles, columns, [one, other], expected, sink);
    }

    /// Sets the colours between two traced pixels from those that the two have in both kinds of cells. The second
    /// differences of the three are expected to be these. Returns whether one parabola for each kind gives them all.
    fn tile(
        &mut self,
        tiles: &Tiles,
        [first, last]: [u32; 2],
        [start, end]: [[Sum; 2]; 2],
        (expected, samples): ([Bend; 2], Samples),
        sink: &mut impl Sink,
    ) -> bool {
        let (length, half) = (last - first, (last - first) / 2);
        if length < 2 {
            return true;
        }
        let traced = self.trace(first + half, SCRATCH);
        let Some((_, middle)) = self.both(&traced, tiles.level) else {
            self.trace_each(first + 1, last, sink);
            return true;
        };
        let curve =
            |kind: usize| Parabola::through([start[kind], middle[kind], end[kind]], half, length);
        let curves = [curve(0), curve(1)];
        // Between its three traced pixels, a parabola over so many columns may be further off.
        let most = Self::TOLERANCE * if length > 32 { 2 } else { 4 };
        let is_close = |kind: usize| {
            let bend = curves[kind].bend(half);
            bend.less(expected[kind]).is_within(most)
        };
        if samples == Samples::Three && is_close(0) && is_close(1) {
            self.show(tiles, [first, length], curves, sink);
            return true;
        }
        let bends =
            [half, length - half].map(|length| curves.map(|it| it.bend((length / 2).max(1))));
        let column = first + half;
        let (before, after) = ([first, column], [column, last]);
        let (one, other) = ([start, middle], [middle, end]);
        let is_even = self.tile(tiles, before, one, (bends[0], Samples::Three), sink);
        self.set(column, traced.traced, sink);
        // As in `interpolate`.
        let samples = if is_even { Samples::Three } else { Samples::Five };
        let is_other = self.tile(tiles, after, other, (bends[1], samples), sink);
        if is_even && !is_other {
            self.tile(tiles, before, one, (bends[0], Samples::Five), sink);
        }
        false
    }

    /// Sets the colours of `length` columns from the first on. Each is on the parabola of its cell.
    fn show(
        &mut self,
        tiles: &Tiles,
        [first, length]: [u32; 2],
        curves: [Parabola; 2],
        sink: &mut impl Sink,
    ) {
        let mut column = 0;
        while column < length {
            let ([holds, is_aside], count) =
                tiles
                    .cells
                    .run(first + column, length - column, Q::SMOOTHNESS > 1);
            let (held, path) = tiles.start;
            let path = path.across([holds != held, is_aside]);
            self.marks.fill(first + column, count, path);
            let curve = curves[usize::from(holds)].after(column);
            sink.set_curve(first + column, count, curve);
            column += count;
        }
    }

    /// Returns whether a traced pixel shows the checker's colour at a hit, and its colours in cells without and with it.
    fn both(&self, end: &End, level: usize) -> Option<(bool, [Sum; 2])> {
        let own = end.traced.sum;
        let [stops, _] = hits(&self.stops, [end, end]);
        let cell = self.tracer.cell(stops, level)?;
        let other = own.less(cell.change);
        Some((
            cell.holds,
            if cell.holds { [other, own] } else { [own, other] },
        ))
    }
}
