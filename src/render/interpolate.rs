//! Floor 7: the colours of a row of pixels. Some pixels are traced, most are interpolated.
//!
//! A row is divided into blocks of columns. The pixels at both ends of a block are traced. If all paths
//! between two traced pixels surely meet the same shapes, lit by the same lights, the colours between them
//! are smooth, and a parabola gives them. It goes through the pixel half way, which is traced, too. If the
//! parabola may be further off than the quality's tolerance, or if it is not sure what lies between, both
//! halves are treated in the same way (Akimoto, Mase, Suenaga, "Pixel-Selected Ray Tracing", IEEE Computer
//! Graphics and Applications 11(4), 1991, without guesses).
//!
//! Blocks are aligned, and a block's colours depend on its own pixels only. So a part of a row has the
//! colours that it has in the whole row.

mod output;

use crate::accel::{LONGEST_STRIDE, Window, World};
use crate::camera::RowDirections;
use crate::color::{Bend, Sum};
use crate::number::Unit;
use crate::render::Quality;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Traced, Tracer};

/// Number of columns below which a picture has blocks of eight columns.
const SMALL: u32 = 128;

/// The colours of a row of pixels, computed from one column on to the right.
pub(crate) struct Colors<'s, 'a, W: World, K, Q> {
    tracer: &'s mut Tracer<'a, W, K, Q>,
    directions: RowDirections,
    /// The columns that the tracer has advanced to. Rays are traced through these only.
    window: Window,
    /// Column of the next colour.
    column: u32,
    /// Last column that may be traced. It lies up to a block beyond the picture; in a picture narrower
    /// than two blocks it is the last column, because rays beyond it would exceed the formats.
    last: u32,
    /// Number of columns of a block.
    block: u32,
    /// Colours of the block that `column` lies in.
    colors: [Sum; LONGEST_STRIDE as usize],
    /// The traced pixel after the block, at this column.
    end: (u32, Traced),
    /// Column before which no path hits anything, if it is to the right of `column`. The colours in
    /// `colors` then are those of such paths.
    clear_until: u32,
}

impl<'s, 'a, W: World, K: Shading, Q: Quality> Colors<'s, 'a, W, K, Q> {
    /// Tolerance of interpolated colours, in steps of a [`Sum`].
    const TOLERANCE: i32 = Q::TOLERANCE.to_bits() >> 6;

    /// Compile-time check of a quality: its tolerance is 0 to 1.
    const IS_SOUND: () = {
        assert!(
            Q::TOLERANCE.to_bits() >= 0 && Q::TOLERANCE.to_bits() <= Unit::ONE.to_bits(),
            "a quality has a tolerance of 0 to 1"
        );
    };

    /// Returns the number of columns of a block in a picture of `width` columns: 1 if every pixel is
    /// traced. The wider the picture, the less changes from one pixel to the next.
    #[inline(always)]
    fn block(tracer: &Tracer<'a, W, K, Q>, width: u32) -> u32 {
        match Tracer::<W, K, Q>::IS_INTERPOLATED && tracer.is_near() {
            false => 1,
            true if width < SMALL => 8,
            true => LONGEST_STRIDE,
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
        let block = Self::block(tracer, width);
        let first = column - column % block;
        let mut colors = Self {
            window: tracer.advance(first, first + block),
            tracer,
            directions,
            column,
            last: match width >= 2 * block {
                true => (width + block - 1).min(u16::MAX.into()),
                false => width - 1,
            },
            block,
            colors: [Sum::ZERO; LONGEST_STRIDE as usize],
            end: (u32::MAX, Traced::NONE),
            clear_until: 0,
        };
        if first < column && !Tracer::<W, K, Q>::IS_PLAIN {
            colors.follow(first);
        }
        colors
    }

    /// Computes the colours of the block that begins at column `first`.
    #[inline(never)]
    fn follow(&mut self, first: u32) {
        if first < self.clear_until {
            return;
        }
        let block = self.block;
        self.window = self.tracer.advance(first, first + block);
        if block == 1 {
            self.colors[0] = self.trace(first).sum;
            return;
        }
        if self.clear(first) {
            return;
        }
        if first + block > self.last {
            self.trace_each(first);
            return;
        }
        let start = match self.end {
            (column, end) if column == first => end,
            _ => self.trace(first),
        };
        let end = self.trace(first + block);
        self.end = (first + block, end);
        self.between((first, block), [&start, &end], None);
    }

    /// Takes a block as clear if no path in the current window hits a shape. Returns whether it is.
    ///
    /// The block begins at `first`. Sets `clear_until`, and fills the block with the background.
    #[inline(always)]
    fn clear(&mut self, first: u32) -> bool {
        let Some(until) = self.tracer.clear_until(&self.window) else {
            return false;
        };
        self.clear_until = (until - until % self.block).max(first + self.block);
        self.colors = [self.tracer.missed().sum; LONGEST_STRIDE as usize];
        true
    }

    /// Traces each pixel of a block up to the last column. Nothing is interpolated.
    #[inline(always)]
    fn trace_each(&mut self, first: u32) {
        for place in 0..self.block {
            if first + place <= self.last {
                self.colors[place as usize] = self.trace(first + place).sum;
            }
        }
    }

    /// Computes the colours of `length` pixels, a power of two, from the traced pixel at column `first` up
    /// to the traced pixel after the last. `ends` are these two.
    ///
    /// If it is known that all paths between meet the same, `expected` is the second difference that a
    /// parabola through pixels further away has here.
    fn between(&mut self, (first, length): (u32, u32), ends: [&Traced; 2], expected: Option<Bend>) {
        let [start, end] = ends;
        let place = (first % self.block) as usize;
        self.colors[place] = start.sum;
        if length == 1 {
            return;
        }
        let is_steady = expected.is_some() || self.is_steady((first, length), ends);
        if length == 2 {
            self.colors[place + 1] = match is_steady && Self::is_even(ends, expected) {
                true => start.sum.half_way(end.sum, expected.unwrap_or(Bend::ZERO)),
                false => self.trace(first + 1).sum,
            };
            return;
        }
        let half = length / 2;
        let middle = self.trace(first + half);
        let bend = Bend::of(start.sum, middle.sum, end.sum);
        let mut expected_of_halves = None;
        if is_steady {
            if bend
                .less(expected.unwrap_or(Bend::ZERO))
                .is_within(4 * Self::TOLERANCE)
            {
                let sums = [start.sum, middle.sum, end.sum];
                Sum::parabola(sums, half, &mut self.colors[place..]);
                return;
            }
            expected_of_halves = Some(bend.quarter());
        }
        self.between((first, half), [start, &middle], expected_of_halves);
        self.between((first + half, half), [&middle, end], expected_of_halves);
    }

    /// Tests whether all paths between two traced pixels surely meet the same. Paths without known bounds
    /// count as such only if a single pixel lies between.
    fn is_steady(&mut self, (first, length): (u32, u32), ends: [&Traced; 2]) -> bool {
        let [start, end] = ends;
        start.signature == end.signature
            && (length == 2 || !start.signature.is_coarse())
            && self
                .tracer
                .is_steady((&self.window, [first, first + length]), ends)
    }

    /// Tests whether the one pixel between two is exact enough if it is interpolated: their colours differ
    /// by at most three times the tolerance, or the expected second difference is at most four times the
    /// tolerance.
    fn is_even([start, end]: [&Traced; 2], expected: Option<Bend>) -> bool {
        end.sum.less(start.sum).is_within(3 * Self::TOLERANCE)
            || expected.is_some_and(|bend| bend.is_within(4 * Self::TOLERANCE))
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
