//! Floor 7: rows with smooth edges.
//!
//! A pixel is known by the paths through its four corners. If all hit the same shapes, lit by the same lights, it has the
//! mean of their colours. If not, an edge crosses the pixel. On each side whose two ends differ, bisection finds the point
//! where the edge crosses it. These points bound an area for each corner, the weight of its colour (Lorensen, Cline,
//! "Marching Cubes", Computer Graphics 21(4), 1987, in two dimensions). Where more than one edge crosses a side, or where a
//! colour changes steeply, samples inside of the pixel are traced instead. The higher the contrast, the finer the bisection,
//! and the more samples.
//!
//! So a picture takes one line of corners for each row of pixels, and one more; a line is computed as any other row. A row
//! that shows thin shapes, or small balls that mirror, takes two lines, and is the mean of the parts between them. A row
//! leaves its last line to the row below ([`Seam`]).
//!
//! A row is computed in chunks of columns at fixed places, so a part of it has the colours that it has in the whole row.

mod cell;
mod chunk;
mod corner;
mod places;
mod walker;

use super::interpolate::Colors;
use super::{Report, Rows};
use crate::accel::World;
use crate::accel::any_scene::AnyScene;
use crate::accel::thin::shows_thin;
use crate::camera::RayGenerator;
use crate::color::{Levels, Sum};
use crate::number::to_u32;
use crate::qualities::Quality;
use crate::scene::access::SceneAccess;
use crate::shade::Shading;
use crate::shade::highlight::sealed;
use chunk::Chunk;
pub(crate) use corner::Line;
pub use corner::Seam;
use walker::Walker;

/// Number of columns of a chunk. A pixel is a bit of a word.
pub(super) const CHUNK: u32 = 32;

/// The colours of a chunk.
type ChunkColors = [Levels; CHUNK as usize];

/// The colours of a row of pixels with smooth edges, computed from one column on to the right.
pub(crate) struct SmoothColors<'s, 'a, W: World, K, Q> {
    walker: Walker<'s, 'a, W, K, Q>,
    /// A line of corners for each chunk: the one above the row of pixels, or, where the colours are computed, the one below.
    seam: &'s mut [Line],
    /// The corners below the chunk.
    lower: Line,
    /// Column of the next colour.
    column: u32,
    /// Column from which on colours are not known yet.
    until: u32,
    /// Colours of the chunk that `column` lies in.
    colors: ChunkColors,
}

impl<W: World, K: sealed::Shading, Q: Quality> SmoothColors<'_, '_, W, K, Q> {
    /// Returns the colour of the next column, which must lie in the picture.
    #[inline(always)]
    pub(crate) fn next_color(&mut self) -> Sum {
        let column = self.column;
        self.column = column + 1;
        if column >= self.until {
            self.follow(column);
        }
        self.colors[(column % CHUNK) as usize].sum()
    }

    /// Fills `pixels` with the next colours, each converted by `shown`. All pixels must lie in the picture.
    pub(super) fn fill<C>(&mut self, mut pixels: &mut [C], shown: impl Fn(Sum) -> C) {
        while !pixels.is_empty() {
            if self.column >= self.until {
                self.follow(self.column);
            }
            let known = self.colors.get((self.column % CHUNK) as usize..);
            let known = known.unwrap_or_default().iter();
            let known = known.take((self.until - self.column) as usize);
            let (now, later) = pixels.split_at_mut(known.len().min(pixels.len()));
            for (pixel, color) in now.iter_mut().zip(known) {
                *pixel = shown(color.sum());
            }
            self.column += to_u32(now.len());
            pixels = later;
        }
    }

    /// Computes the colours of the chunk that begins at column `first`.
    #[inline(never)]
    fn follow(&mut self, first: u32) {
        let Self {
            walker,
            seam,
            lower,
            colors,
            ..
        } = self;
        let count = CHUNK.min(walker.width - first);
        let chunk = (first / CHUNK) as usize;
        let last = seam.len().saturating_sub(1);
        let Some(upper) = seam.get_mut(chunk.min(last)) else {
            return;
        };
        let above = 2 * walker.y;
        if !upper.is_of([above, first], walker.is_divided) {
            walker.walk(above, first, upper);
        }
        for part in 1..=walker.parts() {
            let line = above + part * walker.step();
            walker.walk(line, first, lower);
            let mut chunk = Chunk::new([first, count], [upper, lower]);
            if part == 1 {
                chunk.paint(walker, colors);
            } else {
                let mut painted = [Levels::DARK; CHUNK as usize];
                chunk.paint(walker, &mut painted);
                for (color, part) in colors.iter_mut().zip(painted) {
                    *color = color.half_way(part);
                }
            }
            if upper.is_flat_with(lower) {
                upper.descend(walker.step())
            } else {
                upper.copy(lower)
            }
        }
        self.until = first + count;
    }
}

impl<'a, S: AnyScene, Q: Quality, K: Shading> Rows<'a, S, Q, K> {
    /// Fills pixels inside of the picture with smooth edges. Without a seam the row traces the line above it.
    #[inline(never)]
    pub(super) fn fill_smooth<C: Copy>(
        &self,
        generator: &RayGenerator,
        start: [u32; 2],
        pixels: &mut [C],
        (seam, shown): (Option<&mut [Line]>, impl Fn(Sum) -> C),
    ) -> Report {
        let mut own = [Line::NONE];
        let seam = seam.unwrap_or(&mut own);
        self.in_smooth_row(generator, start, seam, |colors| colors.fill(pixels, shown))
            .1
    }

    /// Does what [`Rows::in_row`] does for a row with smooth edges. `seam` is what the row above has left.
    #[inline(always)]
    pub(crate) fn in_smooth_row<T>(
        &self,
        generator: &RayGenerator,
        [x, y]: [u32; 2],
        seam: &mut [Line],
        draw: impl FnOnce(&mut SmoothColors<'_, '_, S::World<'a>, K, Q>) -> T,
    ) -> (T, Report) {
        let directions = generator.row_below(y, 0);
        let mut tracer = self.tracer((generator, &directions), y);
        let eye = tracer.visibility.from.point;
        let width = self.sides()[0];
        // From a far camera, shapes are small.
        let is_divided = !tracer.is_near()
            || shows_thin(tracer.world, &generator.row_plane_below((y, 0), eye), width);
        let first = x & !(CHUNK - 1);
        let mut colors = SmoothColors {
            walker: Walker {
                row: Colors::new(&mut tracer, directions, first, width + 1),
                line: 2 * y,
                generator,
                y,
                width,
                is_divided,
                is_fine: false,
            },
            seam,
            lower: Line::NONE,
            column: x,
            until: first,
            colors: [Levels::DARK; CHUNK as usize],
        };
        if <S::World<'_> as SceneAccess>::NEEDS.checkers {
            colors.walker.row.marks.pixel = Some(generator.pixel());
        }
        if first < x {
            colors.follow(first);
        }
        let drawn = draw(&mut colors);
        (drawn, Report::of(&tracer))
    }
}

#[cfg(test)]
mod tests;
