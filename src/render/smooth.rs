//! Floor 7: rows with smooth edges.
//!
//! Each row of pixels is the mean of a few rows, which are drawn as any other. Where a pixel's path meets something else
//! than that of its left or right neighbour, or than its own in another of the rows, an edge may cross the pixel. It then
//! takes further samples, at places that are spread evenly in both directions (Cook, "Stochastic sampling in computer
//! graphics", ACM Transactions on Graphics 5(1), 1986, without chance).
//!
//! Pixels are computed by chunks of columns at fixed places, so a part of a row has the colours that it has in the whole
//! row.

use super::interpolate::{Colors, Marked};
use super::{Quality, Report, Rows};
use crate::accel::drawable::Drawable;
use crate::accel::shadows::RowShadows;
use crate::accel::{LONGEST_BLOCK, World};
use crate::camera::RayGenerator;
use crate::color::{Samples, Sum};
use crate::number::to_u32;
use crate::ray::PathSignature;
use crate::shade::Shading;
use crate::shade::highlight::sealed;

/// Number of columns of a chunk. An edge is a bit of a word.
const CHUNK: u32 = LONGEST_BLOCK;

/// Where a row of pixels is sampled. All distances are in sixteenths of a pixel.
struct Places {
    /// The rows: how far each lies below the centres of the pixels.
    rows: &'static [i32],
    /// The further samples of a pixel at an edge: how far each lies to the right of the centre, and below it.
    more: &'static [[i32; 2]],
}

/// The places for two rows.
const TWO: Places = Places {
    rows: &[-6, 6],
    more: &[[5, -2], [-5, 2]],
};

/// The places for four rows.
const FOUR: Places = Places {
    rows: &[-7, -2, 2, 7],
    more: &[
        [3, -6],
        [-5, -5],
        [6, -3],
        [-7, -1],
        [7, 1],
        [-6, 3],
        [5, 5],
        [-3, 6],
    ],
};

/// The colours of a row of pixels with smooth edges, computed from one column on to the right.
pub(crate) struct SmoothColors<'s, 'a, W: World, K, Q> {
    /// The colours of one of the rows.
    row: Colors<'s, 'a, W, K, Q, Marked>,
    generator: &'s RayGenerator,
    y: u32,
    width: u32,
    /// Column of the next colour.
    column: u32,
    /// Column from which on colours are not known yet.
    until: u32,
    /// Samples of the chunk that `column` lies in.
    samples: [Samples; CHUNK as usize],
    /// A bit for each pixel of the chunk that has further samples.
    edges: u32,
    /// Whether an edge lies between the chunk and the next one.
    has_edge: bool,
}

impl<'s, 'a, W: World, K: sealed::Shading, Q: Quality> SmoothColors<'s, 'a, W, K, Q> {
    const PLACES: Places = match Q::ROWS {
        2 => TWO,
        _ => FOUR,
    };

    /// Starts at a pixel of a picture of `width` columns. `row` is that of the pixel.
    pub(super) fn new(
        row: Colors<'s, 'a, W, K, Q, Marked>,
        generator: &'s RayGenerator,
        ([x, y], width): ([u32; 2], u32),
    ) -> Self {
        let first = x & !(CHUNK - 1);
        let mut colors = Self {
            row,
            generator,
            y,
            width,
            column: x,
            until: first,
            samples: [Samples::NONE; CHUNK as usize],
            edges: 0,
            has_edge: false,
        };
        if first > 0 {
            // Whether an edge lies between the two chunks is known from the one before.
            colors.follow(first - CHUNK);
        }
        if first < x {
            colors.follow(first);
        }
        colors
    }

    /// Returns the colour of the next column, which must lie in the picture.
    #[inline(always)]
    pub(crate) fn next_color(&mut self) -> Sum {
        let column = self.column;
        self.column = column + 1;
        if column >= self.until {
            self.follow(column);
        }
        let place = column % CHUNK;
        let count = match self.edges >> place & 1 {
            0 => Self::PLACES.rows.len(),
            _ => Self::PLACES.rows.len() + Self::PLACES.more.len(),
        };
        self.samples[place as usize].mean(to_u32(count))
    }

    /// Fills `pixels` with the next colours, each converted by `shown`. All pixels must lie in the picture.
    pub(super) fn fill<C>(&mut self, pixels: &mut [C], shown: impl Fn(Sum) -> C) {
        for pixel in pixels {
            *pixel = shown(self.next_color());
        }
    }

    /// Takes the samples of the chunk that begins at column `first`.
    #[inline(never)]
    fn follow(&mut self, first: u32) {
        let count = CHUNK.min(self.width - first);
        self.samples = [Samples::NONE; CHUNK as usize];
        self.edges = u32::from(self.has_edge);
        self.has_edge = false;
        self.until = first + CHUNK;
        let mut above = None;
        for &down in Self::PLACES.rows {
            let directions = self.generator.row_below(self.y, down);
            let plane = |from| self.generator.row_plane_below((self.y, down), from);
            self.row.turn(plane, directions, first);
            self.row
                .add_to(self.samples.get_mut(..count as usize).unwrap_or_default());
            let after = first + count;
            let after = (after < self.width).then(|| self.row.path_after(after));
            let paths = self.row.marks.0;
            self.edges |= changes(&paths, above.as_ref()) & u32::MAX >> (CHUNK - count);
            let last = paths.last().filter(|_| count == CHUNK);
            if after
                .zip(last)
                .is_some_and(|(after, last)| !after.is_like(*last))
            {
                self.edges |= 1 << (CHUNK - 1);
                self.has_edge = true;
            }
            above = Some(paths);
        }
        if self.edges != 0 {
            self.refine(first);
        }
    }

    /// Takes the further samples of the pixels at edges.
    #[inline(never)]
    fn refine(&mut self, first: u32) {
        for &[right, down] in Self::PLACES.more {
            let directions = self.generator.row_below(self.y, down);
            let mut edges = self.edges;
            while edges != 0 {
                let place = edges.trailing_zeros();
                edges &= edges - 1;
                let column = first + place;
                let sample = self.row.sample(column, directions.beside(column, right));
                self.samples[(place % CHUNK) as usize].add(sample);
            }
        }
    }
}

impl<'a, S: Drawable, Q: Quality, K: Shading> Rows<'a, S, Q, K> {
    /// Does what [`Rows::in_row`] does for a row with smooth edges.
    #[inline(always)]
    pub(crate) fn in_smooth_row<T>(
        &self,
        generator: &RayGenerator,
        [x, y]: [u32; 2],
        draw: impl FnOnce(&mut SmoothColors<'_, '_, S::World<'a>, K, Q>) -> T,
    ) -> (T, Report) {
        let directions = generator.row(y);
        let mut shadows = RowShadows::NONE;
        let mut tracer = self.tracer((generator, &directions), y, &mut shadows);
        let width = self.sides()[0];
        let row = Colors::new(&mut tracer, directions, 0, width);
        let mut colors = SmoothColors::new(row, generator, ([x, y], width));
        let drawn = draw(&mut colors);
        (drawn, Report::of(&tracer))
    }
}

/// What the paths of the pixels of a chunk met.
type Paths = [PathSignature; CHUNK as usize];

/// Returns a bit for each pixel whose path met something else than that of a neighbour in the row, or than that of the
/// same pixel in the row above.
fn changes(paths: &Paths, above: Option<&Paths>) -> u32 {
    let beside = paths
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| !pair[0].is_like(pair[1]));
    let edges = beside.fold(0, |edges, (index, _)| edges | 3 << index);
    let below = above
        .into_iter()
        .flat_map(|above| paths.iter().zip(above))
        .enumerate();
    let below = below.filter(|(_, (path, above))| !path.is_like(**above));
    below.fold(edges, |edges, (index, _)| edges | 1 << index)
}

#[cfg(test)]
mod tests;
