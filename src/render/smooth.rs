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
use crate::accel::{LONGEST_BLOCK, Window};
use crate::camera::RayGenerator;
use crate::color::{Mean, Sum};
use crate::number::to_u32;
use crate::ray::PathSignature;
use crate::shade::Shading;
use crate::trace::Stops;

/// Number of columns of a chunk. An edge is a bit of a word.
const CHUNK: u32 = LONGEST_BLOCK;

/// Where the rows lie in a row of pixels, in sixteenths of a pixel below its centre, and where a pixel at an edge takes its
/// further samples: to the right of the centre, and below it.
struct Places {
    rows: &'static [i32],
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
        [-1, -7],
        [5, -7],
        [-4, -4],
        [1, -3],
        [-7, -5],
        [7, 5],
        [-1, 3],
        [4, 4],
        [-5, 7],
        [1, 7],
    ],
};

/// The colours of a row of pixels with smooth edges, computed from one column on to the right.
pub(crate) struct SmoothColors<'r, 'a, S: Drawable, Q, K> {
    rows: &'r Rows<'a, S, Q, K>,
    generator: &'r RayGenerator,
    y: u32,
    /// Column of the next colour.
    column: u32,
    /// Column from which on colours are not known yet.
    until: u32,
    /// Colours of the chunk that `column` lies in.
    colors: [Sum; CHUNK as usize],
    /// Whether an edge lies between the chunk and the next one.
    has_edge: bool,
    /// The report on all chunks so far.
    pub(crate) report: Report,
}

impl<'r, 'a, S: Drawable, Q: Quality, K: Shading> SmoothColors<'r, 'a, S, Q, K> {
    const PLACES: Places = match Q::ROWS {
        4 => FOUR,
        _ => TWO,
    };

    /// Starts at a pixel of the picture.
    pub(crate) fn new(
        rows: &'r Rows<'a, S, Q, K>,
        generator: &'r RayGenerator,
        [x, y]: [u32; 2],
    ) -> Self {
        let first = x & !(CHUNK - 1);
        let mut colors = Self {
            rows,
            generator,
            y,
            column: x,
            until: first,
            colors: [Sum::ZERO; CHUNK as usize],
            has_edge: false,
            report: Report::NONE,
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
    pub(crate) fn next_color(&mut self) -> Sum {
        let column = self.column;
        self.column = column + 1;
        if column >= self.until {
            self.follow(column);
        }
        self.colors[(column % CHUNK) as usize]
    }

    /// Computes the colours of the chunk that begins at column `first`.
    #[inline(never)]
    fn follow(&mut self, first: u32) {
        let [width, _] = self.rows.sides();
        let count = CHUNK.min(width - first) as usize;
        let mut means = [Mean::NONE; CHUNK as usize];
        let mut edges = u32::from(self.has_edge);
        self.has_edge = false;
        let mut above = None;
        for &down in Self::PLACES.rows {
            let (paths, after) = self.row(first, down, means.get_mut(..count).unwrap_or_default());
            edges |= changes(&paths, above.as_ref());
            let last = paths.get(count - 1);
            if after.zip(last).is_some_and(|(after, last)| !after.is_like(*last)) {
                edges |= 1 << (count - 1);
                self.has_edge = true;
            }
            above = Some(paths);
        }
        for (index, mean) in means.iter_mut().take(count).enumerate() {
            if edges >> index & 1 == 1 {
                self.refine(first + to_u32(index), mean);
            }
        }
        self.colors = means.map(Mean::sum);
        self.until = first + CHUNK;
    }

    /// Adds a sample to each pixel of a chunk: those of a row below the centres. Returns what their paths met, and what the
    /// path of the pixel after them met.
    #[inline(never)]
    fn row(
        &mut self,
        first: u32,
        down: i32,
        means: &mut [Mean],
    ) -> (Paths, Option<PathSignature>) {
        let [width, _] = self.rows.sides();
        let directions = self.generator.row_below(self.y, down);
        let plane = self.generator.row_plane_below((self.y, down), self.rows.eye());
        let mut shadows = RowShadows::NONE;
        let mut tracer = self.rows.tracer_of((plane, &directions), self.y, &mut shadows);
        let mut colors = Colors::<_, _, _, Marked>::new(&mut tracer, directions, first, width);
        let mut paths = [PathSignature::new(); CHUNK as usize];
        for (index, mean) in means.iter_mut().enumerate() {
            mean.add(colors.next_color());
            paths[index % CHUNK as usize] = colors.marks.0[index % CHUNK as usize];
        }
        let after = first + to_u32(means.len());
        let last = paths.get(means.len().saturating_sub(1)).copied();
        paths.iter_mut().skip(means.len()).zip(last.into_iter().cycle()).for_each(|(path, last)| *path = last);
        let after = (after < width).then(|| colors.path_after(after));
        self.report = self.report.merge(Report::of(&tracer));
        (paths, after)
    }

    /// Adds the further samples of a pixel at an edge.
    #[inline(never)]
    fn refine(&mut self, column: u32, mean: &mut Mean) {
        for &[right, down] in Self::PLACES.more {
            let directions = self.generator.row_below(self.y, down);
            let plane = self.generator.row_plane_below((self.y, down), self.rows.eye());
            let mut shadows = RowShadows::NONE;
            let mut tracer = self.rows.tracer_of((plane, &directions), self.y, &mut shadows);
            let direction = directions.beside(column, right);
            let mut stops = Stops::NONE;
            let traced = tracer.trace(None::<(&Window, u32)>, direction, (&mut stops, false));
            mean.add(traced.sum);
            self.report = self.report.merge(Report::of(&tracer));
        }
    }
}

/// What the paths of the pixels of a chunk met.
type Paths = [PathSignature; CHUNK as usize];

/// Returns a bit for each pixel whose path met something else than that of a neighbour in the row, or than that of the
/// same pixel in the row above.
fn changes(paths: &Paths, above: Option<&Paths>) -> u32 {
    let beside = paths.windows(2).enumerate().filter(|(_, pair)| !pair[0].is_like(pair[1]));
    let edges = beside.fold(0, |edges, (index, _)| edges | 3 << index);
    let below = above.into_iter().flat_map(|above| paths.iter().zip(above)).enumerate();
    let below = below.filter(|(_, (path, above))| !path.is_like(**above));
    below.fold(edges, |edges, (index, _)| edges | 1 << index)
}
