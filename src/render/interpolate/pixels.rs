//! Floor 7: the slice of pixels that takes the colours of a row. It does not know how they are found.

use super::output::fill;
use crate::color::{Parabola, Sum};
use crate::number::to_u32;

/// The pixels of a row from column `first` on. They take colours in any order, and drop those of other columns. `shown`
/// converts a colour to that of a pixel.
pub(super) struct Pixels<'p, C, F> {
    first: u32,
    pixels: &'p mut [C],
    shown: &'p F,
}

impl<'p, C: Copy, F: Fn(Sum) -> C> Pixels<'p, C, F> {
    /// Starts with the pixel of column `first`.
    #[inline(always)]
    pub(super) fn new(first: u32, pixels: &'p mut [C], shown: &'p F) -> Self {
        Self {
            first,
            pixels,
            shown,
        }
    }

    /// Takes the colour of one column.
    #[inline(always)]
    pub(super) fn set(&mut self, column: u32, sum: Sum) {
        let place = column.checked_sub(self.first);
        if let Some(pixel) = place.and_then(|it| self.pixels.get_mut(it as usize)) {
            *pixel = (self.shown)(sum);
        }
    }

    /// Takes the colours of `count` columns from `column` on: those of a parabola. Not inlined, so that the loop has all
    /// registers.
    #[inline(never)]
    pub(super) fn set_curve(&mut self, column: u32, count: u32, curve: Parabola) {
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

    /// Gives pixels the colours of columns 128 to 191.
    fn draw<F: Fn(Sum) -> Sum>(mut pixels: Pixels<'_, Sum, F>) {
        let curve = Parabola::through([grey(1 << 20), grey(1 << 23), grey(1 << 24)], 4, 9);
        pixels.set_curve(142, 50, curve);
        pixels.set(128, grey(1 << 21));
        pixels.set_curve(129, 9, curve);
        pixels.set_curve(138, 3, Parabola::constant(grey(1 << 22)));
        pixels.set(141, grey(1 << 19));
    }

    #[test]
    fn pixels_are_the_same_wherever_they_begin_and_end() {
        let mut all = [Sum::ZERO; 80];
        draw(Pixels::new(120, &mut all, &|sum| sum));
        let colors = [grey(1 << 21), grey(1 << 20), grey(1 << 22), grey(1 << 19)];
        assert_eq!([128, 129, 140, 141].map(|it| all[it - 120]), colors);
        for first in 120..192 {
            for end in first..200 {
                let mut pixels = [Sum::ZERO; 80];
                let pixels = &mut pixels[..end - first];
                draw(Pixels::new(to_u32(first), pixels, &|sum| sum));
                for (column, pixel) in (first..).zip(pixels) {
                    assert_eq!(*pixel, all[column - 120], "{column} from {first} to {end}");
                }
            }
        }
    }
}
