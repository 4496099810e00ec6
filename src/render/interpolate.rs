//! Floor 7: the colours of a row of pixels. Some pixels are traced, most are interpolated.
//!
//! Every second or fourth pixel of a row is traced. If the paths of two traced neighbours hit the same
//! shapes in the same order, each lit by the same lights, the colours between them are interpolated
//! (Akimoto, Mase, Suenaga, "Pixel-Selected Ray Tracing", IEEE Computer Graphics and Applications
//! 11(4), 1991). The cubic goes through the two and the traced pixels beside them, if their paths have
//! the same signature, too. If the cubic may be further off than the quality's tolerance, the pixel
//! half way is traced, and then the others if necessary. Stretches in which no path hits anything are
//! not traced.
//!
//! Which pixels are traced depends on their columns alone. So a part of a row has the colours that it
//! has in the whole row.

mod output;

use crate::accel::{LONGEST_STRIDE, Window, World};
use crate::camera::RowDirections;
use crate::color::{Bend, Sum};
use crate::number::Unit;
use crate::render::Quality;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Traced, Tracer};

/// The colours of a row of pixels, computed from one column on to the right.
pub(crate) struct Colors<'s, 'a, W: World, K, Q> {
    tracer: &'s mut Tracer<'a, W, K, Q>,
    directions: RowDirections,
    /// The columns that the tracer has advanced to. Rays are traced through these only.
    window: Window,
    /// Column of the next colour.
    column: u32,
    /// Last column that may be traced. It lies up to a stride beyond the picture; in a picture narrower
    /// than two strides it is the last column, because rays beyond it would exceed the formats.
    last: u32,
    /// Colours of the stretch that `column` lies in. A stretch begins at a traced pixel and ends before
    /// the next.
    stretch: [Sum; LONGEST_STRIDE as usize],
    /// The traced pixels at the starts of the next two stretches.
    ends: [Traced; 2],
    /// Second difference of the colours at the first of `ends`, if the three paths around it have equal
    /// signatures.
    bend: Option<Bend>,
    /// Column before which no path hits anything, if it is to the right of `column`. The colours in
    /// `stretch` and `ends` then are those of such paths.
    clear_until: u32,
}

impl<'s, 'a, W: World, K: Shading, Q: Quality> Colors<'s, 'a, W, K, Q> {
    /// Tolerance of interpolated colours, in steps of a [`Sum`].
    const TOLERANCE: i32 = Q::TOLERANCE.to_bits() >> 6;

    /// Compile-time check of a quality: its stride is 1, 2 or 4, and its tolerance is 0 to 1.
    const IS_SOUND: () = {
        assert!(
            matches!(Q::STRIDE, 1 | 2 | 4),
            "a quality has a stride of 1, 2 or 4"
        );
        assert!(
            Q::TOLERANCE.to_bits() >= 0 && Q::TOLERANCE.to_bits() <= Unit::ONE.to_bits(),
            "a quality has a tolerance of 0 to 1"
        );
    };

    /// Returns the distance in columns between two pixels that are always traced: 1, 2 or 4.
    ///
    /// A scene of planes alone uses the longest stride. All planes together show convex parts, one for
    /// each sequence of planes that a path can hit, and no plane throws a shadow. So nothing lies
    /// between two pixels whose paths have equal signatures.
    #[inline(always)]
    fn stride(tracer: &Tracer<'a, W, K, Q>) -> u32 {
        match Q::STRIDE > 1 && !tracer.has_bounded() {
            true => LONGEST_STRIDE,
            false => Q::STRIDE,
        }
    }

    /// Starts at `column` of a row, in a picture of `width` columns.
    #[inline(always)]
    pub(crate) fn new(
        tracer: &'s mut Tracer<'a, W, K, Q>,
        directions: RowDirections,
        column: u32,
        width: u32,
    ) -> Self {
        const { Self::IS_SOUND };
        let stride = Self::stride(tracer);
        // Begin three strides earlier, as a longer part of the row would: the second difference at the
        // start comes from the stretch before.
        let window = (column - column % stride).saturating_sub(3 * stride);
        let mut colors = Self {
            window: tracer.advance(window, window + 2 * stride),
            tracer,
            directions,
            column,
            last: match width >= 2 * stride {
                true => (width + stride - 1).min(u16::MAX.into()),
                false => width - 1,
            },
            stretch: [Sum::ZERO; LONGEST_STRIDE as usize],
            ends: [Traced::NONE; 2],
            bend: None,
            clear_until: 0,
        };
        if stride > 1 && !Tracer::<W, K, Q>::IS_PLAIN {
            colors.start();
        }
        colors
    }

    /// Prepares the stretch that `column` lies in: traces its start, its end and the pixel a stride
    /// before.
    ///
    /// The first column may lie inside of the stretch.
    #[inline(never)]
    fn start(&mut self) {
        let stride = Self::stride(self.tracer);
        let first = self.column - self.column % stride;
        let before = first.saturating_sub(stride);
        let turn_to = |colors: &mut Self, column: u32| {
            let window = column.saturating_sub(2 * stride);
            colors.window = colors.tracer.advance(window, window + 2 * stride);
        };
        if self.tracer.notes_what_is_thin() && !(before == 0 && self.clear(before)) {
            let before = (before < first).then(|| self.trace(before));
            turn_to(self, first);
            let start = self.trace(first);
            turn_to(self, first + stride);
            self.ends = [start, self.end(first + stride)];
            self.bend = before.and_then(|before| self.bend_after(&before));
        }
        if first < self.column {
            self.follow(first);
        }
    }

    /// Takes a stretch as clear if no path in the current window hits a shape. Returns whether it is.
    ///
    /// The stretch begins at `first`. Sets `clear_until`, and fills the stretch with the background.
    #[inline(always)]
    fn clear(&mut self, first: u32) -> bool {
        let Some(until) = self.tracer.clear_until(&self.window) else {
            return false;
        };
        let stride = Self::stride(self.tracer);
        self.clear_until = (until - until % stride).max(first + stride);
        let missed = self.tracer.missed();
        self.stretch = [missed.sum; LONGEST_STRIDE as usize];
        (self.ends, self.bend) = ([missed; 2], Some(Bend::ZERO));
        true
    }

    /// Traces the end of a stretch. Returns [`Traced::BEYOND`] for a column after the last.
    #[inline(always)]
    fn end(&mut self, column: u32) -> Traced {
        match column <= self.last {
            true => self.trace(column),
            false => Traced::BEYOND,
        }
    }

    /// Returns the second difference of the colours of `start` and the two ends after it, if the three
    /// paths have equal signatures.
    #[inline(always)]
    fn bend_after(&self, start: &Traced) -> Option<Bend> {
        let [middle, end] = &self.ends;
        let is_alike = start.signature == middle.signature && middle.signature == end.signature;
        is_alike.then(|| Bend::of(start.sum, middle.sum, end.sum))
    }

    /// Computes the colours of the stretch that begins at column `first`.
    #[inline(never)]
    fn follow(&mut self, first: u32) {
        if first < self.clear_until {
            return;
        }
        let stride = Self::stride(self.tracer);
        self.window = self.tracer.advance(first, first + 2 * stride);
        if stride == 1 {
            self.stretch[0] = self.trace(first).sum;
            return;
        }
        if self.clear(first) {
            return;
        }
        if first + stride > self.last || !self.tracer.notes_what_is_thin() {
            self.trace_each(first, stride);
            return;
        }
        let [start, end] = self.ends;
        self.ends = [end, self.end(first + 2 * stride)];
        let before = self.bend;
        self.bend = self.bend_after(&start);
        let (bends, is_exact) = match (before, self.bend) {
            (Some(first), Some(last)) => {
                ([first, last], last.less(first).is_within(Self::TOLERANCE))
            }
            (Some(bend), None) | (None, Some(bend)) => {
                ([bend; 2], bend.is_within(2 * Self::TOLERANCE))
            }
            (None, None) => ([Bend::ZERO; 2], false),
        };
        if stride == 2 {
            self.stretch[0] = start.sum;
            self.stretch[1] = match is_exact {
                true => start.sum.half_way(end.sum, bends),
                false => self.between(&start, &end, first + 1),
            };
            return;
        }
        self.stretch = start.sum.towards(end.sum, bends);
        // A round mirror shows a lot in a small area, so trace the middle in any case.
        if is_exact && !start.signature.is_bent() {
            return;
        }
        self.add_middle(first, &start, &end);
    }

    /// Traces each pixel of a stretch up to the last column. Nothing is interpolated.
    #[inline(always)]
    fn trace_each(&mut self, first: u32, stride: u32) {
        for place in 0..stride {
            if first + place <= self.last {
                self.stretch[place as usize] = self.trace(first + place).sum;
            }
        }
    }

    /// Traces the middle pixel of a stretch of four, and corrects the pixels beside it.
    ///
    /// If the middle pixel shows that the interpolated colours are exact enough, they are corrected by
    /// its error. Otherwise they are traced or interpolated anew.
    #[inline(always)]
    fn add_middle(&mut self, first: u32, start: &Traced, end: &Traced) {
        let middle = self.trace(first + 2);
        if start.signature == end.signature && middle.signature == start.signature {
            let miss = middle.sum.less(self.stretch[2]);
            if miss.is_within(Self::TOLERANCE) {
                // A curve that is off by m half way is off by about 3/4 m at the quarters: a line by
                // 3/4, a cubic by 35/48.
                self.stretch[1] = self.stretch[1].with_most_of(miss);
                self.stretch[2] = middle.sum;
                self.stretch[3] = self.stretch[3].with_most_of(miss);
                return;
            }
        }
        self.stretch[1] = self.between(start, &middle, first + 1);
        self.stretch[2] = middle.sum;
        self.stretch[3] = self.last(&middle, end, first + 3);
    }

    /// Returns the colour of the one pixel between two traced pixels.
    ///
    /// It is interpolated if the paths have equal signatures and the colours differ by at most three
    /// times the tolerance; else it is traced.
    #[inline(always)]
    fn between(&mut self, start: &Traced, end: &Traced, column: u32) -> Sum {
        let way = end.sum.less(start.sum);
        if start.signature == end.signature && way.is_within(3 * Self::TOLERANCE) {
            return start.sum.half_way(end.sum, [Bend::ZERO; 2]);
        }
        self.trace(column).sum
    }

    /// Returns the colour of the one pixel between the middle and the end of a stretch.
    ///
    /// The pixel one stride after the end helps: if all three paths have equal signatures, the second
    /// difference of their colours tells how exact the interpolation is.
    #[inline(always)]
    fn last(&mut self, middle: &Traced, end: &Traced, column: u32) -> Sum {
        let beyond = &self.ends[1];
        if middle.signature == end.signature && end.signature == beyond.signature {
            let bend = Bend::of_uneven(beyond.sum, end.sum, middle.sum);
            if bend.is_within(4 * Self::TOLERANCE) {
                return middle.sum.half_way(end.sum, [bend; 2]);
            }
        }
        self.between(middle, end, column)
    }

    /// Traces the pixel of a column, out of line.
    #[inline(never)]
    fn trace(&mut self, column: u32) -> Traced {
        self.traced(column)
    }

    /// Traces the pixel of a column, inlined into the caller.
    #[inline(always)]
    fn traced(&mut self, column: u32) -> Traced {
        let direction = self.directions.of(column);
        self.tracer.trace((&self.window, column), direction)
    }
}
