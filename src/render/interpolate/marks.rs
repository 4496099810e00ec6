//! Floor 7: what the paths of a chunk's pixels met, for frames with smooth edges. Other frames keep nothing.

use crate::accel::Beside;
use crate::camera::PixelSides;
use crate::ray::{PathMark, PathSignature};
use crate::render::smooth::CHUNK;

/// What a row keeps of the paths of a chunk's pixels.
pub(crate) trait Marks {
    /// Nothing is kept yet.
    const NONE: Self;

    /// Keeps what the paths of `count` pixels from a column on met.
    fn fill(&mut self, column: u32, count: u32, path: PathSignature);

    /// Returns what rays beside the centres of pixels can hit, if there are such rays.
    fn beside(&mut self) -> Option<&mut Beside>;

    /// Returns the sides of pixels, if the cells of checkers are mixed in them.
    fn pixel(&self) -> Option<&PixelSides>;
}

/// Nothing is kept.
pub(crate) struct Unmarked;

impl Marks for Unmarked {
    const NONE: Self = Self;

    #[inline(always)]
    fn fill(&mut self, _: u32, _: u32, _: PathSignature) {}

    #[inline(always)]
    fn beside(&mut self) -> Option<&mut Beside> {
        None
    }

    #[inline(always)]
    fn pixel(&self) -> Option<&PixelSides> {
        None
    }
}

/// The mark of each path, and what rays beside the centres of pixels can hit.
pub(crate) struct Marked {
    pub(crate) paths: [PathMark; CHUNK as usize],
    /// A bit for each path that meets cells less than two pixels wide.
    pub(crate) fine: u32,
    pub(crate) pixel: Option<PixelSides>,
    beside: Beside,
}

impl Marks for Marked {
    const NONE: Self = Self {
        paths: [PathMark::NONE; CHUNK as usize],
        fine: 0,
        pixel: None,
        beside: Beside::NONE,
    };

    fn fill(&mut self, column: u32, count: u32, path: PathSignature) {
        let place = (column % CHUNK) as usize;
        let marks = self.paths.iter_mut().skip(place).take(count as usize);
        marks.for_each(|mark| *mark = path.mark());
        if path.is_fine() {
            let end = (column % CHUNK + count).min(CHUNK);
            self.fine |= (u32::MAX >> (CHUNK - end)) & (u32::MAX << place);
        }
    }

    fn beside(&mut self) -> Option<&mut Beside> {
        Some(&mut self.beside)
    }

    fn pixel(&self) -> Option<&PixelSides> {
        self.pixel.as_ref()
    }
}
