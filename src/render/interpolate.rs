//! Floor 7: the colours of a row of pixels. Some pixels are traced, most are interpolated.
//!
//! A row is divided into blocks of columns. The pixels at both ends of a block are traced. If all paths
//! between two traced pixels surely meet the same shapes, lit by the same lights, the colours between them
//! are smooth, and a parabola gives them. It goes through the pixel half way, which is traced, too. If the
//! parabola may be further off than the quality's tolerance, both halves are treated in the same way. So they are
//! if it is not sure what lies between, but then the block is divided at a border if one is known (Akimoto, Mase,
//! Suenaga, "Pixel-Selected Ray Tracing", IEEE Computer Graphics and Applications 11(4), 1991, without guesses).
//! Every pixel between two traced ones is traced as well if they are at most eight columns apart, or if both show
//! something in a curved mirror and no border is known between them.
//!
//! Blocks are aligned, and a block's colours depend on its own pixels only. So a part of a row has the
//! colours that it has in the whole row.

mod between;
mod marks;
mod output;
mod sink;
mod tiles;

pub(crate) use marks::{Marked, Marks, Unmarked};
pub(super) use output::fill;
pub(crate) use sink::Buffer;

use crate::accel::{LONGEST_BLOCK, Window, World};
use crate::camera::RowDirections;
use crate::number::{Unit, to_u32};
use crate::qualities::Quality;
use crate::render::smooth::CHUNK;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Footprint, Pixel, Progress, Stops, Traced, Tracer};
use crate::vector::Direction;
use sink::Sink;

/// Returns the number of columns of a block in a picture of `width` columns. The wider the picture, the less
/// changes from one pixel to the next. Where borders lie close together, it `is_dense`, and blocks are half as long.
pub(crate) const fn block_of(width: u32, is_dense: bool) -> u32 {
    let most = LONGEST_BLOCK / if width < 160 { 2 } else { 1 };
    if is_dense { most / 2 } else { most }
}

/// Number of columns of a window if every pixel is traced.
const SHORT: u32 = 8;

/// Length of the shortest stretch of which it is found out what lies between: in shorter ones, that would take longer
/// than to trace what is left.
const SHORTEST: u32 = 8;

/// How many proofs are tried in a block, if none succeeds, before the rest of it is traced. A proof that fails takes as long
/// as a few pixels.
const CREDIT: u32 = 4;

/// How many more are tried for each that succeeds.
const EARNED: u32 = 3;

/// Number of traced pixels whose hits are stored: 0 and 1 are the ends of a block, then those of its parts; the last is
/// [`UNREAD`].
const SLOTS: usize = 6;

/// The slot of a traced pixel whose hits are never read. No hit is stored there.
const UNREAD: usize = SLOTS - 1;

/// The same slot for hits that are read before another pixel is traced.
const SCRATCH: usize = SLOTS;

/// A traced pixel.
#[derive(Clone, Copy)]
struct End {
    traced: Traced,
    /// Where its hits are stored.
    slot: usize,
}

impl End {
    /// No pixel.
    const NONE: Self = Self {
        traced: Traced::NONE,
        slot: 0,
    };
}

/// The colours of a row of pixels, computed from one column on to the right.
pub(crate) struct Colors<'s, 'a, W: World, K, Q, M = Unmarked> {
    tracer: &'s mut Tracer<'a, W, K, Q>,
    directions: RowDirections,
    /// The columns that the tracer has advanced to. Rays are traced through these only.
    window: Window,
    /// Column of the next colour.
    column: u32,
    /// Column from which on colours are not known yet.
    until: u32,
    /// Last column of the picture. The last block ends there.
    last: u32,
    /// Number of columns of a block.
    block: u32,
    /// The traced pixel after the block, and its column.
    end: (u32, End),
    /// What the paths of the traced pixels hit.
    stops: [Stops; SLOTS],
    /// A bit for each slot that is free.
    free: u32,
    /// How many more proofs are tried in the block, if none of them succeeds.
    credit: u32,
    /// Column before which no path hits anything, if it is to the right of `until`.
    clear_until: u32,
    /// What the paths of the chunk's pixels met.
    pub(super) marks: M,
}

/// Tests whether a number is within 0 to 1.
const fn is_share(number: Unit) -> bool {
    number.to_bits() >= 0 && number.to_bits() <= Unit::ONE.to_bits()
}

impl<'s, 'a, W: World, K: Shading, Q: Quality, M: Marks> Colors<'s, 'a, W, K, Q, M> {
    /// Tolerance of interpolated colours, in steps of a [`Sum`].
    const TOLERANCE: i32 = Q::TOLERANCE.to_bits() >> 6;

    /// Compile-time check of a quality: its shares and its number of rows.
    const IS_SOUND: () = {
        assert!(
            is_share(Q::TOLERANCE) && is_share(Q::SMALLEST_WEIGHT),
            "the TOLERANCE and the SMALLEST_WEIGHT of a quality are 0 to 1"
        );
        assert!(
            matches!(Q::SMOOTHNESS, 1 | 2 | 4),
            "the SMOOTHNESS of a quality is 1, 2 or 4"
        );
    };

    /// Returns the number of columns of a block in a picture of `width` columns: 1 if every pixel is traced.
    #[inline(always)]
    fn block(tracer: &Tracer<'a, W, K, Q>, width: u32) -> u32 {
        if !Tracer::<W, K, Q>::IS_INTERPOLATED || !tracer.is_near() {
            return 1;
        }
        // Many shapes have borders that lie close together.
        let is_dense = width / 12 < to_u32(tracer.world.parts().bounded());
        // Smooth edges ask what the paths of a chunk met.
        let most = match Q::SMOOTHNESS {
            1 => LONGEST_BLOCK,
            _ => CHUNK,
        };
        block_of(width, is_dense).min(most)
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
        let block = Self::block(tracer, width);
        let first = column & !(block - 1);
        Self {
            window: tracer.advance(first, first + block.max(SHORT)),
            tracer,
            directions,
            column,
            until: first,
            last: width - 1,
            block,
            end: (u32::MAX, End::NONE),
            stops: [Stops::NONE; SLOTS],
            free: 0,
            credit: 0,
            clear_until: 0,
            marks: M::NONE,
        }
    }

    /// Computes the colours of the block that begins at column `first`. If no path there hits a shape, it moves
    /// `clear_until` behind the block instead.
    #[inline(never)]
    fn follow(&mut self, first: u32, sink: &mut impl Sink) {
        // With the constant, other qualities do not compile what follows.
        if !Tracer::<W, K, Q>::IS_INTERPOLATED || self.block == 1 {
            self.window = self.tracer.advance(first, first + SHORT);
            self.until = (first + SHORT).min(self.last + 1);
            return self.trace_each(first, self.until, sink);
        }
        let next = first + self.block;
        self.window = self.tracer.advance(first, next);
        if let Some(until) = self.tracer.clear_until(&self.window) {
            self.clear_until = (until & !(self.block - 1)).max(next);
            return;
        }
        self.until = next;
        let last = next.min(self.last);
        let start = match self.end {
            (column, end) if column == first => end,
            _ => self.trace(first, 0),
        };
        self.set(first, start.traced, sink);
        if last - first < SHORTEST {
            return self.trace_each(first + 1, last + 1, sink);
        }
        // The two ends of a block take turns.
        let end = self.trace(last, 1 - start.slot);
        self.end = (last, end);
        self.free = (1 << UNREAD) - 1 - 0b11;
        self.credit = CREDIT;
        self.between([first, last], [&start, &end], Progress::NONE, sink);
        if last < next {
            self.set(last, end.traced, sink);
        }
    }

    /// Traces each pixel from column `first` to the one before `end`. Nothing is interpolated.
    fn trace_each(&mut self, first: u32, end: u32, sink: &mut impl Sink) {
        for column in first..end {
            let traced = self.trace(column, UNREAD).traced;
            self.set(column, traced, sink);
        }
    }

    /// Sets the colour of a column, and what its path met.
    #[inline(always)]
    fn set(&mut self, column: u32, traced: Traced, sink: &mut impl Sink) {
        sink.set(column, traced.sum);
        self.marks.fill(column, 1, traced.signature);
    }

    /// Traces the pixel of a column, out of line.
    #[inline(never)]
    fn trace(&mut self, column: u32, slot: usize) -> End {
        let traced = self.traced(column, slot);
        End { traced, slot }
    }

    /// Traces the pixel of a column, inlined into the caller.
    #[inline(always)]
    fn traced(&mut self, column: u32, slot: usize) -> Traced {
        let direction = self.directions.of(column);
        match Q::SMOOTHNESS {
            1 => {
                let stops = (&mut self.stops[slot.min(UNREAD)], slot != UNREAD);
                let pixel = Pixel::Center(&self.window, column);
                self.tracer.trace(pixel, (direction, None), stops)
            }
            // The further samples of a smooth picture share the code.
            _ => self.along((true, column), (direction, None), slot),
        }
    }

    /// Traces a path through a pixel of a column, out of line: through its centre if `is_center`. If there are `parts`, the
    /// path shows that part of the pixel, as [`Footprint::new`] says; else it shows a point.
    #[inline(never)]
    fn along(
        &mut self,
        (is_center, column): (bool, u32),
        (direction, parts): (Direction, Option<[u32; 2]>),
        slot: usize,
    ) -> Traced {
        let pixel = self.marks.pixel().filter(|_| W::NEEDS.checkers);
        let footprint = pixel.map(|pixel| Footprint::new(pixel, direction, parts));
        let pixel = match self.marks.beside() {
            Some(known) if !is_center => Pixel::Beside(known, column),
            _ => Pixel::Center(&self.window, column),
        };
        let stops = (&mut self.stops[slot.min(UNREAD)], slot != UNREAD);
        self.tracer.trace(pixel, (direction, footprint), stops)
    }
}
