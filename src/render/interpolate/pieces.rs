//! Floor 7: the colours of a block's pixels: single ones, and parabolas that stand for several. It does not
//! know how they are found.

use core::hint::black_box;

use super::output::fill;
use crate::color::{LONGEST, Parabola, Sum};
use crate::number::to_u8;

/// Colours of the pixels of a block. A place is a column of the block.
///
/// A parabola is stored in the first three of its places.
pub(super) struct Pieces {
    sums: [Sum; LONGEST],
    /// A bit for each place at which a parabola begins.
    curves: u64,
    /// Number of columns of the parabola that begins at a place.
    lengths: [u8; LONGEST],
}

impl Pieces {
    /// No parabola.
    pub(super) const NONE: Self = Self {
        sums: [Sum::ZERO; LONGEST],
        curves: 0,
        lengths: [0; LONGEST],
    };

    /// Removes all parabolas.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.curves = 0;
    }

    /// Sets the colour of one place, which is in no parabola.
    #[inline(always)]
    pub(super) fn set(&mut self, place: usize, sum: Sum) {
        self.sums[place % LONGEST] = sum;
    }

    /// Sets the colours of `count` places from `place` on, 3 to [`LONGEST`], to those of a parabola.
    #[inline(always)]
    pub(super) fn set_curve(&mut self, place: usize, count: u32, curve: Parabola) {
        let place = place % LONGEST;
        if let Some(sums) = self.sums.split_at_mut(place).1.first_chunk_mut() {
            *sums = curve.to_sums();
            self.lengths[place] = to_u8(count);
            self.curves |= 1 << place;
        }
    }

    /// Fills the first of `pixels` with the colours from `place` on, each converted by `shown`: up to the end of a
    /// parabola, or to the beginning of the next one. Returns how many are filled. The place is not within a parabola.
    #[inline(always)]
    pub(super) fn fill<C: Copy>(
        &self,
        place: usize,
        pixels: &mut [C],
        shown: impl Fn(Sum) -> C,
    ) -> usize {
        let place = place % LONGEST;
        let (_, sums) = self.sums.split_at(place);
        let singles = (self.curves >> place).trailing_zeros() as usize;
        if let (0, Some(curve)) = (singles, sums.first_chunk()) {
            let count = pixels.len().min(self.lengths[place].into());
            fill_curve(curve, pixels.split_at_mut(count).0, shown);
            return count;
        }
        let count = pixels.len().min(singles).min(sums.len());
        for (pixel, sum) in pixels.iter_mut().zip(sums.split_at(count).0) {
            *pixel = shown(*sum);
            // Keeps the compiler from unrolling the loop: most pixels are in parabolas.
            black_box(());
        }
        count
    }

    /// Returns the colour of a place. It is in no parabola, or the first of one.
    #[inline(always)]
    pub(super) fn color_of(&self, place: usize) -> Sum {
        self.sums[place % LONGEST]
    }

    /// Replaces all parabolas by their colours.
    #[inline(never)]
    pub(super) fn expand(&mut self) {
        while self.curves != 0 {
            let place = self.curves.trailing_zeros() as usize % LONGEST;
            let (_, sums) = self.sums.split_at_mut(place);
            if let Some(&curve) = sums.first_chunk() {
                let sums = sums.iter_mut().take(self.lengths[place].into());
                Parabola::from_sums(curve).fill(sums, |sum| sum);
            }
            self.curves &= self.curves - 1;
        }
    }
}

/// Fills pixels with the colours of a parabola. Not inlined, so that the loop has all registers.
#[inline(never)]
fn fill_curve<C: Copy>(sums: &[Sum; 3], pixels: &mut [C], shown: impl Fn(Sum) -> C) {
    let curve = Parabola::from_sums(*sums);
    match curve.as_constant() {
        Some(sum) => fill(pixels, shown(sum)),
        None => curve.fill(pixels.iter_mut(), shown),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Color;
    use crate::number::{Brightness, Unit, to_u32};

    #[test]
    fn block_of_one_colour_stays_one_however_often_it_is_expanded() {
        let mut pieces = Pieces::NONE;
        pieces.set_curve(0, 16, Parabola::constant(grey(1 << 22)));
        for _ in 0..2 {
            pieces.expand();
            assert_eq!(pieces.sums[..16], [grey(1 << 22); 16]);
        }
    }

    /// Returns the sum of a path that shows a grey.
    fn grey(bits: i32) -> Sum {
        let mut sum = Sum::DARK;
        sum.add(Unit::ONE, Color::grey(Brightness::from_bits(bits)));
        sum
    }

    #[test]
    fn pixels_are_filled_with_the_colours_that_expanding_gives() {
        let curve = Parabola::through([grey(1 << 20), grey(1 << 23), grey(1 << 24)], 4, 9);
        let flat = Parabola::constant(grey(1 << 22));
        let mut pieces = Pieces::NONE;
        pieces.set(0, grey(1 << 21));
        pieces.set_curve(1, 9, curve);
        pieces.set_curve(10, 3, flat);
        pieces.set(13, grey(1 << 19));
        pieces.set_curve(14, 50, curve);
        let mut filled = [Sum::ZERO; LONGEST];
        let mut place = 0;
        while place < filled.len() {
            place += pieces.fill(place, &mut filled[place..], |sum| sum);
        }
        pieces.expand();
        assert_eq!((filled, pieces.curves), (pieces.sums, 0));
        assert_eq!((filled[1], filled[14]), (grey(1 << 20), grey(1 << 20)));
        assert_eq!([filled[10], filled[11], filled[12]], [grey(1 << 22); 3]);
    }

    #[test]
    fn parabola_of_a_whole_block_is_expanded() {
        let mut pieces = Pieces::NONE;
        pieces.set_curve(0, to_u32(LONGEST), Parabola::constant(grey(1 << 22)));
        pieces.expand();
        assert_eq!(pieces.sums, [grey(1 << 22); LONGEST]);
    }
}
