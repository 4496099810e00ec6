//! Floor 7: the paths of single pixels of a row, step by step. It draws nothing.

use alloc::vec::Vec;
use core::ops::Range;

use super::Rows;
use crate::accel::any_scene::AnyScene;
use crate::qualities::Quality;
use crate::shade::Shading;
use crate::trace::{Pixel, Walked};

impl<S: AnyScene, Q: Quality, K: Shading> Rows<'_, S, Q, K> {
    /// Follows the paths of these columns of row `y`. Returns `None` if the scene has no shape and no sky: there are
    /// no paths then.
    ///
    /// A quality that interpolates draws other colours.
    pub(crate) fn walk(&self, y: u32, columns: Range<u32>) -> Option<Vec<Walked>> {
        let generator = self.generator()?;
        let directions = generator.row(y);
        let mut tracer = self.tracer((generator, &directions), y);
        let paths = columns.map(|column| {
            let window = tracer.advance(column, column);
            tracer.walk(Pixel::Center(&window, column), directions.of(column))
        });
        Some(paths.collect())
    }
}
