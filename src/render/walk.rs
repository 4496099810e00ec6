//! Floor 7: the paths of single pixels of a row, step by step. It draws nothing.

use core::ops::Range;

use super::{Quality, Rows};
use crate::accel::drawable::Drawable;
use crate::accel::shadows::RowShadows;
use crate::shade::Shading;
use crate::trace::{Met, Walked};

impl<S: Drawable, Q: Quality, K: Shading> Rows<'_, S, Q, K> {
    /// Follows the paths of these columns of row `y`. Calls `met` for each surface on a path, then `ended`. Returns
    /// whether it did: if the scene has no shape and no sky, there are no paths.
    ///
    /// A quality that interpolates draws other colours.
    pub(crate) fn walk<T>(
        &self,
        y: u32,
        columns: Range<u32>,
        to: &mut T,
        (met, ended): (impl Fn(&mut T, Met), impl Fn(&mut T, Walked)),
    ) -> bool {
        let Some(generator) = self.generator() else {
            return false;
        };
        let directions = generator.row(y);
        let mut shadows = RowShadows::NONE;
        let mut tracer = self.tracer((generator, &directions), y, &mut shadows);
        for column in columns {
            let window = tracer.advance(column, column);
            let direction = directions.of(column);
            let walked = tracer.walk((&window, column), direction, |step| met(to, step));
            ended(to, walked);
        }
        true
    }
}
