//! Floor 7: hands out the colours of a row, one by one or into a slice. It does not know how they are
//! found.

use super::Colors;
use crate::accel::World;
use crate::color::Sum;
use crate::number::to_u32;
use crate::render::Quality;
use crate::shade::highlight::sealed::Shading;
use crate::trace::Tracer;

impl<W: World, K: Shading, Q: Quality> Colors<'_, '_, W, K, Q> {
    /// Returns the colour of the next column, which must lie in the picture.
    #[inline(always)]
    pub(crate) fn next_color(&mut self) -> Sum {
        let column = self.column;
        self.column += 1;
        if Tracer::<W, K, Q>::IS_PLAIN {
            return self.traced(column).sum;
        }
        let place = column % Self::stride(self.tracer);
        if place == 0 {
            self.follow(column);
        }
        self.stretch[place as usize]
    }

    /// Fills `pixels` with the next colours, each converted by `shown`. All pixels must lie in the
    /// picture.
    #[inline(always)]
    pub(crate) fn fill<C: Copy>(&mut self, mut pixels: &mut [C], shown: impl Fn(Sum) -> C) {
        if Tracer::<W, K, Q>::IS_PLAIN {
            for pixel in pixels {
                *pixel = shown(self.next_color());
            }
            return;
        }
        let stride = Self::stride(self.tracer);
        while !pixels.is_empty() {
            let place = self.column % stride;
            if place == 0 {
                self.follow(self.column);
            }
            let clear = self.clear_until.saturating_sub(self.column) as usize;
            let whole = match clear > 0 || place > 0 {
                true => 0,
                false => stride,
            };
            let (count, later) = match (whole, pixels) {
                (4, [a, b, c, d, later @ ..]) => {
                    [*a, *b, *c, *d] = self.stretch.map(&shown);
                    (4, later)
                }
                (2, [a, b, later @ ..]) => {
                    let [first, second, ..] = self.stretch;
                    [*a, *b] = [first, second].map(&shown);
                    (2, later)
                }
                (_, pixels) => {
                    // All pixels of a clear part have one colour. Else write one pixel of a stretch.
                    let count = pixels.len().min(clear.max(1));
                    let (now, later) = pixels.split_at_mut(count);
                    now.fill(shown(self.stretch[place as usize]));
                    (count, later)
                }
            };
            self.column += to_u32(count);
            pixels = later;
        }
    }
}
