//! Floor 7: hands out the colours of a row, one by one or into a slice. It does not know how they are
//! found.

use super::sink::Pixels;
use super::{Buffer, Colors, Marks, SHORT, Sink, UNREAD};
use crate::accel::World;
use crate::camera::RayGenerator;
use crate::color::{Parabola, Sum};
use crate::number::to_u32;
use crate::qualities::Quality;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Traced, Tracer};
use crate::vector::Direction;

impl<W: World, K: Shading, Q: Quality, M: Marks> Colors<'_, '_, W, K, Q, M> {
    /// Returns the colour of the next column, which must lie in the picture. `buffer` holds the colours that are computed
    /// together with it; it must be the same for the whole row.
    #[inline(always)]
    pub(crate) fn next_color(&mut self, buffer: &mut Buffer) -> Sum {
        if !Tracer::<W, K, Q>::IS_INTERPOLATED {
            return self.each();
        }
        let column = self.column;
        self.column = column + 1;
        while column >= self.until {
            self.step(Buffer::end(column), buffer);
        }
        buffer.color_of(column)
    }

    /// Computes the next colours, but none from column `end` on if no path hits a shape.
    #[inline(never)]
    fn step(&mut self, end: u32, sink: &mut impl Sink) {
        let first = self.until;
        if first >= self.clear_until {
            self.follow(first, sink);
        }
        if first < self.clear_until {
            self.until = self.clear_until.min(end);
            let (count, missed) = (self.until - first, self.tracer.missed());
            self.marks.fill(first, count, missed.signature);
            sink.set_curve(first, count, Parabola::constant(missed.sum));
        }
    }

    /// Traces the pixel of the next column, in a quality that interpolates none.
    #[inline(always)]
    fn each(&mut self) -> Sum {
        let column = self.column;
        self.column = column + 1;
        if !Tracer::<W, K, Q>::IS_PLAIN && column > self.window.last {
            self.window = self.tracer.advance(column, column + SHORT);
        }
        let traced = self.traced(column, 0);
        self.marks.fill(column, 1, traced.signature);
        traced.sum
    }

    /// Turns to the rays through points `down` below the centres of row `y`, in 64ths of a pixel, and goes to column `first`,
    /// the first of a chunk.
    pub(crate) fn turn(&mut self, generator: &RayGenerator, (y, down): (u32, i32), first: u32) {
        let plane = generator.row_plane_below((y, down), self.tracer.visibility.from.point);
        self.directions = generator.row_below(y, down);
        self.tracer.turn(y, (plane, &self.directions));
        self.window = self.tracer.advance(first, first + self.block.max(SHORT));
        (self.column, self.until, self.end.0, self.clear_until) = (first, first, u32::MAX, 0);
    }

    /// Returns the result of a path that goes through a pixel of a column, but not through its centre. If there are `parts`, it
    /// shows that part of the pixel, as [`Footprint::new`](crate::trace::Footprint::new) says.
    pub(crate) fn beside(
        &mut self,
        column: u32,
        direction: Direction,
        parts: Option<[u32; 2]>,
    ) -> Traced {
        self.along((false, column), (direction, parts), UNREAD)
    }

    /// Fills `pixels` as [`Colors::fill`] does, unless no path hits anything up to column `last`. Then the next column is
    /// `last`, and the result of these paths is returned. The next column must be the first of a block.
    pub(crate) fn fill_or_miss<C: Copy>(
        &mut self,
        last: u32,
        pixels: &mut [C],
        shown: impl Fn(Sum) -> C,
    ) -> Option<Traced> {
        let first = self.column;
        if first >= self.clear_until && self.block > 1 {
            self.follow(first, &mut Pixels::new(first, pixels, &shown));
        }
        if last < self.clear_until {
            (self.column, self.until) = (last, last);
            return Some(self.tracer.missed());
        }
        self.fill(pixels, shown);
        None
    }

    /// Returns the result of the path through the pixel of a column, which comes after the last one that was handed out.
    pub(crate) fn after(&mut self, column: u32) -> Traced {
        if self.end.0 == column {
            return self.end.1.traced;
        }
        // The window of the block that begins there.
        let last = column + self.block.max(SHORT);
        self.window = self.tracer.advance(column, last);
        self.trace(column, UNREAD).traced
    }

    /// Fills `pixels` with the next colours, each converted by `shown`. All pixels must lie in the picture.
    /// The rest of the last parabola is dropped, so the row must not be asked for any further colour.
    #[inline(always)]
    pub(crate) fn fill<C: Copy>(&mut self, pixels: &mut [C], shown: impl Fn(Sum) -> C) {
        if !Tracer::<W, K, Q>::IS_INTERPOLATED {
            for pixel in pixels {
                *pixel = shown(self.each());
            }
            return;
        }
        let first = self.column;
        self.column = first + to_u32(pixels.len());
        let mut sink = Pixels::new(first, pixels, &shown);
        while self.until < self.column {
            self.step(self.column, &mut sink);
        }
    }
}

/// Fills pixels with one colour. Inlined, it would make the compiler unroll its caller's loops.
#[inline(never)]
pub(in crate::render) fn fill<C: Copy>(pixels: &mut [C], color: C) {
    pixels.fill(color);
}
