//! Floor 7: what the paths of a block's pixels met, for frames with smooth edges. Other frames keep nothing.

use crate::accel::LONGEST_BLOCK;
use crate::ray::PathSignature;

/// What a row keeps of the paths of a block's pixels.
pub(crate) trait Marks {
    /// Nothing is kept yet.
    const NONE: Self;

    /// Keeps what the paths of `count` pixels from `place` on met.
    fn fill(&mut self, place: usize, count: usize, path: PathSignature);
}

/// Nothing is kept.
pub(crate) struct Unmarked;

impl Marks for Unmarked {
    const NONE: Self = Self;

    #[inline(always)]
    fn fill(&mut self, _: usize, _: usize, _: PathSignature) {}
}

/// The signature of each path.
pub(crate) struct Marked(pub(crate) [PathSignature; LONGEST_BLOCK as usize]);

impl Marks for Marked {
    const NONE: Self = Self([PathSignature::new(); LONGEST_BLOCK as usize]);

    fn fill(&mut self, place: usize, count: usize, path: PathSignature) {
        let marks = self.0.get_mut(place..).unwrap_or_default();
        marks.iter_mut().take(count).for_each(|mark| *mark = path);
    }
}
