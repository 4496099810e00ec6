//! Floor 7: hands out the colours of a row, one by one or into a slice. It does not know how they are
//! found.

use super::{Colors, Marks, SHORT, UNREAD};
use crate::accel::World;
use crate::color::Sum;
use crate::number::to_u32;
use crate::ray::PathSignature;
use crate::render::Quality;
use crate::shade::highlight::sealed::Shading;
use crate::trace::Tracer;

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
        }
        self.colors[Self::place(column)]
    }

    /// Traces the pixel of the next column, in a quality that interpolates none.
    #[inline(always)]
    fn each(&mut self, column: u32) -> Sum {
        if !Tracer::<W, K, Q>::IS_PLAIN && column > self.window.last {
            self.window = self.tracer.advance(column, column + SHORT);
        }
        let traced = self.traced(column, 0);
        self.marks.fill(Self::place(column), 1, traced.signature);
        traced.sum
    }

    /// Returns what the path through the pixel of a column meets. The column comes after the last one that was handed
    /// out.
    pub(crate) fn path_after(&mut self, column: u32) -> PathSignature {
        if self.end.0 == column {
            return self.end.1.traced.signature;
        }
        self.window = self.tracer.advance(column, column + SHORT);
        self.traced(column, UNREAD).signature
    }

    /// Fills `pixels` with the next colours, each converted by `shown`. All pixels must lie in the
    /// picture.
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
            let clear = self.clear_until.saturating_sub(self.column) as usize;
            let place = Self::place(self.column);
            let after = place + (self.until - self.column) as usize;
            let colors = self.colors.get(place..after).unwrap_or(&[]);
            let count = pixels.len().min(match clear {
                0 => colors.len(),
                _ => clear,
            });
            let (now, later) = pixels.split_at_mut(count);
            match clear {
                0 => {
                    for (pixel, color) in now.iter_mut().zip(colors) {
                        *pixel = shown(*color);
                    }
                }
                // All pixels of a clear part have one colour.
                _ => now.fill(shown(self.colors[0])),
            }
            self.column += to_u32(count);
            pixels = later;
        }
    }
}
