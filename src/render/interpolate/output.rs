//! Floor 7: hands out the colours of a row, one by one or into a slice. It does not know how they are
//! found.

use super::{Colors, Marks, SHORT, UNREAD};
use crate::accel::World;
use crate::camera::RayGenerator;
use crate::color::Sum;
use crate::number::to_u32;
use crate::render::Quality;
use crate::shade::highlight::sealed::Shading;
use crate::trace::{Traced, Tracer};
use crate::vector::Direction;

impl<W: World, K: Shading, Q: Quality, M: Marks> Colors<'_, '_, W, K, Q, M> {
    /// Returns the colour of the next column, which must lie in the picture.
    #[inline(always)]
    pub(crate) fn next_color(&mut self) -> Sum {
        let column = self.column;
        self.column = column + 1;
        if !Tracer::<W, K, Q>::IS_INTERPOLATED {
            return self.each(column);
        }
        if column >= self.until {
            self.follow(column);
            self.colors.expand();
        }
        self.colors.color_of(self.place(column))
    }

    /// Traces the pixel of the next column, in a quality that interpolates none.
    #[inline(always)]
    fn each(&mut self, column: u32) -> Sum {
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

    /// Returns the result of a path that goes through a pixel of a column, but not through its centre.
    pub(crate) fn beside(&mut self, column: u32, direction: Direction) -> Traced {
        self.along((false, column), direction, UNREAD)
    }

    /// Returns the result of the paths of the columns from `first` to `last`, if no path hits anything; the next column then
    /// is `last`. Otherwise the next column stays `first`, which must be the first of a block.
    pub(crate) fn missed_until(&mut self, first: u32, last: u32) -> Option<Traced> {
        if first >= self.clear_until && self.block > 1 {
            self.follow(first);
        }
        (last < self.clear_until).then(|| {
            (self.column, self.until) = (last, last);
            self.tracer.missed()
        })
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

    /// Fills `pixels` with the next colours, each converted by `shown`. All pixels must lie in the
    /// picture. They may end within a parabola, so no further colour of the row may be asked for.
    #[inline(always)]
    pub(crate) fn fill<C: Copy>(&mut self, mut pixels: &mut [C], shown: impl Fn(Sum) -> C) {
        if !Tracer::<W, K, Q>::IS_INTERPOLATED {
            for pixel in pixels {
                *pixel = shown(self.next_color());
            }
            return;
        }
        while !pixels.is_empty() {
            if self.column >= self.until {
                self.follow(self.column);
            }
            let clear = self.clear_until.saturating_sub(self.column);
            let known = match clear {
                0 => self.until - self.column,
                _ => clear,
            };
            let (now, _) = pixels.split_at_mut(pixels.len().min(known as usize));
            let count = match clear {
                0 => self.colors.fill(self.place(self.column), now, &shown),
                // All pixels of a clear part have one colour.
                _ => {
                    if M::ARE_KEPT {
                        let path = self.tracer.missed().signature;
                        self.marks.fill(self.column, to_u32(now.len()), path);
                    }
                    fill(now, shown(self.colors.color_of(0)));
                    now.len()
                }
            };
            self.column += to_u32(count);
            pixels = pixels.get_mut(count..).unwrap_or_default();
        }
    }
}

/// Fills pixels with one colour. Inlined, it would make the compiler unroll its caller's loops.
#[inline(never)]
pub(in crate::render) fn fill<C: Copy>(pixels: &mut [C], color: C) {
    pixels.fill(color);
}
