//! Floor 7: the colours of a block's pixels: single ones, and parabolas that stand for several. It does not
//! know how they are found.

use crate::accel::LONGEST_BLOCK;
use crate::color::{Parabola, Sum};

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
        if let Some(sums) = self.stored(place) {
            *sums = curve.to_sums();
            self.inner |= (u32::MAX >> (LONGEST_BLOCK + 1 - count)) << place << 1;
        }
    }

    /// Returns the three sums from `place` on.
    #[inline(always)]
    fn stored(&mut self, place: usize) -> Option<&mut [Sum; 3]> {
        self.sums.get_mut(place..)?.first_chunk_mut()
    }

    /// Returns the parabola that begins at a place, and its number of places; `None` if there is none.
    #[inline(always)]
    pub(super) fn curve(&mut self, place: usize) -> Option<(Parabola, usize)> {
        let more = (self.inner >> place >> 1).trailing_ones();
        let sums = self.stored(place).filter(|_| more > 0)?;
        Some((Parabola::from_sums(*sums), more as usize + 1))
    }

    /// Returns the colours from `place` up to the next parabola, at most `most`.
    #[inline(always)]
    pub(super) fn singles(&self, place: usize, most: usize) -> &[Sum] {
        let count = (self.inner >> place >> 1).trailing_zeros() as usize;
        let sums = self.sums.get(place..).unwrap_or(&[]);
        sums.get(..count.min(most)).unwrap_or(sums)
    }

    /// Returns the colour of a place. It is in no parabola, or the first of one.
    #[inline(always)]
    pub(super) fn first(&self, place: usize) -> Sum {
        self.sums[place]
    }

    /// Replaces all parabolas by their colours.
    #[inline(never)]
    pub(super) fn expand(&mut self) {
        while self.inner != 0 {
            let after = self.inner.trailing_zeros();
            let place = (after as usize).saturating_sub(1);
            let Some((curve, count)) = self.curve(place) else {
                return;
            };
            let sums = self.sums.get_mut(place..).unwrap_or_default();
            curve.fill(sums.iter_mut().take(count), |sum| sum);
            // Adding the lowest bit carries through the lowest bits that are set in a row.
            self.inner &= self.inner.wrapping_add(1 << after);
        }
    }
}
