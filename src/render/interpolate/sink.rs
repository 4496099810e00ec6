//! Floor 7: where the colours of a row go: into a slice of pixels, or into a buffer, from which they are handed out one
//! by one. It does not know how they are found.

use super::output::fill;
use crate::color::{LONGEST, Parabola, Sum};
use crate::number::to_u32;

/// Takes the colours of a row's columns, in any order. Colours of columns that nobody asked for may be among them.
pub(crate) trait Sink {
    /// Takes the colour of one column.
    fn set(&mut self, column: u32, sum: Sum);

    /// Takes the colours of `count` columns from `column` on: those of a parabola.
    fn set_curve(&mut self, column: u32, count: u32, curve: Parabola);
}

/// The pixels of a row from column `first` on. `shown` converts a colour to that of a pixel. Colours of other columns are
/// dropped.
pub(super) struct Pixels<'p, C, F> {
    first: u32,
    pixels: &'p mut [C],
    shown: &'p F,
}

impl<'p, C, F> Pixels<'p, C, F> {
    /// Starts with the pixel of column `first`.
    #[inline(always)]
    pub(super) fn new(first: u32, pixels: &'p mut [C], shown: &'p F) -> Self {
        Self {
            first,
            pixels,
            shown,
        }
    }
}

impl<C: Copy, F: Fn(Sum) -> C> Sink for Pixels<'_, C, F> {
    #[inline(always)]
    fn set(&mut self, column: u32, sum: Sum) {
        let place = column.checked_sub(self.first);
        if let Some(pixel) = place.and_then(|it| self.pixels.get_mut(it as usize)) {
            *pixel = (self.shown)(sum);
        }
    }

    /// Not inlined, so that the loop has all registers.
    #[inline(never)]
    fn set_curve(&mut self, column: u32, count: u32, curve: Parabola) {
        let [from, to] = [column, column + count].map(|it| it.saturating_sub(self.first));
        let to = to.min(to_u32(self.pixels.len()));
        let curve = curve.after(self.first.saturating_sub(column));
        let pixels = self.pixels.get_mut(from as usize..to as usize);
        let pixels = pixels.unwrap_or_default();
        match curve.as_constant() {
            Some(sum) => fill(pixels, (self.shown)(sum)),
            None => curve.fill(pixels.iter_mut(), self.shown),
        }
    }
}

/// The colours of [`LONGEST`] columns. The first of them is a multiple of that number.
pub(crate) struct Buffer([Sum; LONGEST]);

impl Buffer {
    /// No colours.
    pub(crate) const NONE: Self = Self([Sum::ZERO; LONGEST]);

    /// Returns the column after those that the buffer holds together with `column`.
    pub(super) fn end(column: u32) -> u32 {
        let last = to_u32(LONGEST) - 1;
        (column | last) + 1
    }

    /// Returns the colour of a column.
    #[inline(always)]
    pub(super) fn color_of(&self, column: u32) -> Sum {
        self.0[column as usize % LONGEST]
    }
}

impl Sink for Buffer {
    #[inline(always)]
    fn set(&mut self, column: u32, sum: Sum) {
        self.0[column as usize % LONGEST] = sum;
    }

    #[inline(never)]
    fn set_curve(&mut self, column: u32, count: u32, curve: Parabola) {
        let (_, sums) = self.0.split_at_mut(column as usize % LONGEST);
        curve.fill(sums.iter_mut().take(count as usize), |sum| sum);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Color;
    use crate::number::{Brightness, Unit};

    /// Returns the sum of a path that shows a grey.
    fn grey(bits: i32) -> Sum {
        let mut sum = Sum::DARK;
        sum.add(Unit::ONE, Color::grey(Brightness::from_bits(bits)));
        sum
    }

    /// Gives a sink the colours of columns 128 to 191.
    fn draw(sink: &mut impl Sink) {
        let curve = Parabola::through([grey(1 << 20), grey(1 << 23), grey(1 << 24)], 4, 9);
        sink.set_curve(142, 50, curve);
        sink.set(128, grey(1 << 21));
        sink.set_curve(129, 9, curve);
        sink.set_curve(138, 3, Parabola::constant(grey(1 << 22)));
        sink.set(141, grey(1 << 19));
    }

    #[test]
    fn pixels_are_those_of_the_buffer_wherever_they_begin_and_end() {
        let mut buffer = Buffer::NONE;
        draw(&mut buffer);
        let colors = [grey(1 << 21), grey(1 << 20), grey(1 << 22), grey(1 << 19)];
        assert_eq!([128, 129, 140, 141].map(|it| buffer.color_of(it)), colors);
        for first in 120..192 {
            for end in first..200 {
                let mut pixels = [Sum::ZERO; 80];
                let pixels = &mut pixels[..end - first];
                draw(&mut Pixels::new(to_u32(first), pixels, &|sum| sum));
                for (column, pixel) in (first..).zip(pixels) {
                    let expected = buffer.color_of(to_u32(column));
                    let is_drawn = (128..192).contains(&column);
                    let expected = if is_drawn { expected } else { Sum::ZERO };
                    assert_eq!(*pixel, expected, "{column} from {first} to {end}");
                }
            }
        }
    }
}
