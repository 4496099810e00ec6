//! Floor 7: the colours of a row of pixels, most of them between two that were traced.
//!
//! Every second or fourth pixel of a row is traced. Where the paths of two that follow each other
//! met the same shapes in the same order, each lit by the same lights, what lies between them is taken
//! from their colours (Akimoto, Mase, Suenaga, "Pixel-Selected Ray Tracing", IEEE Computer Graphics
//! and Applications 11(4), 1991): from the cubic through them and the two beside, if their paths went
//! alike, too. Where that is not exact to the quality's tolerance, or may not be, the pixel half way
//! is traced, and then the others. Stretches in which nothing can be met are not traced at all.
//!
//! Which pixels are traced depends on their columns alone, so a part of a row has the colours that it
//! has in the whole.

mod output;

use crate::accel::{LONGEST_STRIDE, Window, World};
use crate::camera::RowDirections;
use crate::color::{Bend, Sum};
use crate::number::Unit;
use crate::render::Quality;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Traced, Tracer};

/// The colours of a row from one column on, in the order they are asked for.
pub(crate) struct Colors<'s, 'a, W: World, K, Q> {
    tracer: &'s mut Tracer<'a, W, K, Q>,
    directions: RowDirections,
    /// The columns that the tracer has advanced to.
    window: Window,
    /// The column of the next colour.
    column: u32,
    /// The last column that may be traced: some beyond the picture, unless it is so narrow that their
    /// rays would leave the formats.
    last: u32,
    /// The colours of the stretch that the column lies in.
    stretch: [Sum; LONGEST_STRIDE as usize],
    /// The first pixels of the next stretch and of the one behind it.
    ends: [Traced; 2],
    /// How much the colours bend at the first of them, if the paths around it went alike.
    bend: Option<Bend>,
    /// All of these are of paths that meet nothing, and so are all pixels before this column.
    clear_until: u32,
}

impl<'s, 'a, W: World, K: Shading, Q: Quality> Colors<'s, 'a, W, K, Q> {
    /// How far colours may be from where they are expected, in steps of a [`Sum`].
    const TOLERANCE: i32 = Q::TOLERANCE.to_bits() >> 6;

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

    /// How many columns lie from one pixel that is always traced to the next.
    ///
    /// What all planes together show is cut into convex parts, one for each sequence of planes that a
    /// path can meet, and no plane throws a shadow. So nothing lies between two pixels whose paths
    /// went alike.
    #[inline(always)]
    fn stride(tracer: &Tracer<'a, W, K, Q>) -> u32 {
        match Q::STRIDE > 1 && !tracer.has_bounded() {
            true => LONGEST_STRIDE,
            false => Q::STRIDE,
        }
    }

    /// From `column` on, in a picture so wide.
    #[inline(always)]
    pub(crate) fn new(
        tracer: &'s mut Tracer<'a, W, K, Q>,
        directions: RowDirections,
        column: u32,
        width: u32,
    ) -> Self {
        const { Self::IS_SOUND };
        let stride = Self::stride(tracer);
        // As when the row begins before it; how much the colours bend is known from the stretch before.
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

    /// Makes ready for a row that begins inside of a stretch.
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

    /// Takes all for clear if nothing is met in the columns that it has turned to, from the stretch
    /// on that begins at the first of them.
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

    /// What lies at the end of a stretch; nothing beyond the last column.
    #[inline(always)]
    fn end(&mut self, column: u32) -> Traced {
        match column <= self.last {
            true => self.trace(column),
            false => Traced::BEYOND,
        }
    }

    /// How much the colours bend from a pixel to the two ends after it, if the paths went alike.
    #[inline(always)]
    fn bend_after(&self, start: &Traced) -> Option<Bend> {
        let [middle, end] = &self.ends;
        let is_alike = start.signature == middle.signature && middle.signature == end.signature;
        is_alike.then(|| Bend::of(start.sum, middle.sum, end.sum))
    }

    /// Goes on to the stretch that begins at a column.
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
        // Much is seen in a round mirror in little room.
        if is_exact && !start.signature.is_bent() {
            return;
        }
        self.add_middle(first, &start, &end);
    }

    /// Traces a stretch that no pixel is taken from another in, up to the last column.
    #[inline(always)]
    fn trace_each(&mut self, first: u32, stride: u32) {
        for place in 0..stride {
            if first + place <= self.last {
                self.stretch[place as usize] = self.trace(first + place).sum;
            }
        }
    }

    /// Traces the pixel in the middle of a stretch of four, and those beside it if the colours that the
    /// stretch has are not exact.
    #[inline(always)]
    fn add_middle(&mut self, first: u32, start: &Traced, end: &Traced) {
        let middle = self.trace(first + 2);
        if start.signature == end.signature && middle.signature == start.signature {
            let miss = middle.sum.less(self.stretch[2]);
            if miss.is_within(Self::TOLERANCE) {
                // What misses a curve half way misses it by about three quarters of that at the
                // quarters: a line by 3/4, a cubic by 35/48.
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

    /// The colour of the one pixel between two.
    #[inline(always)]
    fn between(&mut self, start: &Traced, end: &Traced, column: u32) -> Sum {
        let way = end.sum.less(start.sum);
        if start.signature == end.signature && way.is_within(3 * Self::TOLERANCE) {
            return start.sum.half_way(end.sum, [Bend::ZERO; 2]);
        }
        self.trace(column).sum
    }

    /// The colour of the one pixel between the middle and the end of a stretch, behind which another ends.
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

    #[inline(never)]
    fn trace(&mut self, column: u32) -> Traced {
        self.traced(column)
    }

    #[inline(always)]
    fn traced(&mut self, column: u32) -> Traced {
        let direction = self.directions.of(column);
        self.tracer.trace((&self.window, column), direction)
    }
}
