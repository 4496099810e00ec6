//! Floor 7: the colours of a block's pixels: single ones, and parabolas that stand for several. It does not
//! know how they are found.

use core::hint::black_box;

use super::output::fill;
use crate::accel::LONGEST_BLOCK;
use crate::color::{Parabola, Sum};
use crate::number::to_u32;

/// Colours of the pixels of a block. A place is the column within [`LONGEST_BLOCK`] columns.
///
/// A parabola is stored in the first three of its places.
pub(super) struct Pieces {
    sums: [Sum; LONGEST_BLOCK as usize],
    /// A bit for each place of a parabola after its first.
    inner: u32,
}

impl Pieces {
    /// No parabola.
    pub(super) const NONE: Self = Self {
        sums: [Sum::ZERO; LONGEST_BLOCK as usize],
        inner: 0,
    };

    /// Removes all parabolas.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.inner = 0;
    }

    /// Sets the colour of one place, which is in no parabola.
    #[inline(always)]
    pub(super) fn set(&mut self, place: usize, sum: Sum) {
        self.sums[place] = sum;
    }

    /// Sets the colours of `count` places from `place` on, 3 to [`LONGEST_BLOCK`], to those of a parabola.
    #[inline(always)]
    pub(super) fn set_curve(&mut self, place: usize, count: u32, curve: Parabola) {
        if let Some(sums) = self
            .sums
            .get_mut(place..)
            .and_then(|sums| sums.first_chunk_mut())
        {
            *sums = curve.to_sums();
            self.inner |= after_first(place, count);
        }
    }

    /// Returns the sums of the parabola that begins at a place, and its number of places; `None` if there is none.
    #[inline(always)]
    fn curve(&self, place: usize) -> Option<(&[Sum; 3], usize)> {
        let more = (self.inner >> place >> 1).trailing_ones();
        let sums = self.sums.get(place..)?.first_chunk()?;
        (more > 0).then_some((sums, more as usize + 1))
    }

    /// Returns the colours from `place` up to the next parabola.
    #[inline(always)]
    fn singles(&self, place: usize) -> &[Sum] {
        let count = (self.inner >> place >> 1).trailing_zeros() as usize;
        let sums = self.sums.get(place..).unwrap_or(&[]);
        sums.get(..count).unwrap_or(sums)
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
        if let Some((sums, count)) = self.curve(place) {
            let count = count.min(pixels.len());
            fill_curve(sums, pixels.split_at_mut(count).0, shown);
            return count;
        }
        let singles = self.singles(place);
        for (pixel, sum) in pixels.iter_mut().zip(singles) {
            *pixel = shown(*sum);
            // Keeps the compiler from unrolling the loop: most pixels are in parabolas.
            black_box(());
        }
        singles.len().min(pixels.len())
    }

    /// Returns the colour of a place. It is in no parabola, or the first of one.
    #[inline(always)]
    pub(super) fn color_of(&self, place: usize) -> Sum {
        self.sums[place]
    }

    /// Replaces all parabolas by their colours.
    #[inline(never)]
    pub(super) fn expand(&mut self) {
        while self.inner != 0 {
            let after = self.inner.trailing_zeros();
            let place = (after as usize).saturating_sub(1);
            let Some((&sums, count)) = self.curve(place) else {
                return;
            };
            let places = self.sums.get_mut(place..).unwrap_or_default();
            Parabola::from_sums(sums).fill(places.iter_mut().take(count), |sum| sum);
            self.inner &= !after_first(place, to_u32(count));
        }
    }
}

/// Returns a bit for each of `count` places after the first, `place`. There are 2 to [`LONGEST_BLOCK`].
#[inline(always)]
fn after_first(place: usize, count: u32) -> u32 {
    u32::MAX >> (LONGEST_BLOCK + 1 - count) << place << 1
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
    use crate::number::{Brightness, Unit};

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
        pieces.set_curve(14, 18, curve);
        let mut filled = [Sum::ZERO; LONGEST_BLOCK as usize];
        let mut place = 0;
        while place < filled.len() {
            place += pieces.fill(place, &mut filled[place..], |sum| sum);
        }
        pieces.expand();
        assert_eq!((filled, pieces.inner), (pieces.sums, 0));
        assert_eq!((filled[1], filled[14]), (grey(1 << 20), grey(1 << 20)));
        assert_eq!([filled[10], filled[11], filled[12]], [grey(1 << 22); 3]);
    }

    #[test]
    fn parabola_of_a_whole_block_is_expanded() {
        let mut pieces = Pieces::NONE;
        pieces.set_curve(0, LONGEST_BLOCK, Parabola::constant(grey(1 << 22)));
        pieces.expand();
        assert_eq!(pieces.sums, [grey(1 << 22); LONGEST_BLOCK as usize]);
    }
}
