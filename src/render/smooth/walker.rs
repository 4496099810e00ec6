//! Floor 7: traces what pixels with smooth edges need: lines of corners, points of sides, and samples.

use super::CHUNK;
use super::cell::UNEVEN;
use super::corner::{Corner, Line, Side};
use super::places::{PIXEL, Place};
use crate::accel::World;
use crate::camera::RayGenerator;
use crate::color::Levels;
use crate::number::{signed, to_u8, unsigned};
use crate::qualities::Quality;
use crate::render::interpolate::{Colors, Marked};
use crate::shade::highlight::sealed::Shading;

/// Traces the rays through the corners of a row of pixels, and through other points of its pixels.
pub(super) struct Walker<'s, 'a, W: World, K, Q> {
    /// The colours of the corners on one line.
    pub(super) row: Colors<'s, 'a, W, K, Q, Marked>,
    /// Number of the line of corners that `row` computes, counted from the top of the picture.
    pub(super) line: u32,
    pub(super) generator: &'s RayGenerator,
    /// The row of pixels.
    pub(super) y: u32,
    /// Number of columns of the picture.
    pub(super) width: u32,
    /// Whether a line of corners divides the row of pixels into two parts.
    pub(super) is_divided: bool,
    /// Whether the latest point lies among small cells of a checker.
    pub(super) is_fine: bool,
}

impl<W: World, K: Shading, Q: Quality> Walker<'_, '_, W, K, Q> {
    /// Returns into how many parts lines of corners divide the row of pixels.
    pub(super) fn parts(&self) -> u32 {
        1 + u32::from(self.is_divided)
    }

    /// Returns by how many 8-bit levels the colour of a pixel may be off in a row, or in one of its two parts. An edge adds
    /// its contrast times how far it may lie from its true place, in sides of a pixel. A sample adds the pixel's contrast
    /// over the number of samples.
    pub(super) fn tolerance(&self) -> u32 {
        match Q::SMOOTHNESS {
            2 if self.is_divided => 16,
            2 => 32,
            _ if self.is_divided => 12,
            _ => 5,
        }
    }

    /// Returns the row of pixels that a line lies in, and how far below its upper edges, in 64ths of a pixel. Lines are numbered
    /// from the top, two for each row.
    fn place(line: u32) -> (u32, i32) {
        (line / 2, signed(line % 2) * (PIXEL / 2))
    }

    /// Number of a line less that of the one above it.
    pub(super) fn step(&self) -> u32 {
        2 / self.parts()
    }

    /// Makes `found` the corners on one line of the chunk that begins at column `first`.
    #[inline(never)]
    pub(super) fn walk(&mut self, line: u32, first: u32, found: &mut Line) {
        if self.line != line {
            self.line = line;
            self.row.turn(self.generator, Self::place(line), first);
        }
        found.begin([line, first], self.is_divided);
        self.row.marks.fine = 0;
        let last = (first + CHUNK).min(self.width);
        let [walked @ .., after] = &mut found.corners;
        let count = CHUNK.min(self.width + 1 - first);
        let pixels = walked.get_mut(..count as usize).unwrap_or_default();
        let missed = self.row.fill_or_miss(last, pixels, |sum| Corner {
            color: Levels::of(sum),
            ..Corner::NONE
        });
        if let Some(all) = missed.map(Corner::of) {
            return found.flatten(all);
        }
        let paths = &self.row.marks.paths;
        let fine = if W::NEEDS.checkers { self.row.marks.fine } else { 0 };
        let one = paths[0];
        let mut is_one = fine == 0;
        found.tiled = fine | fine >> 1;
        for (corner, path) in pixels.iter_mut().zip(paths) {
            corner.path = *path;
            is_one &= *path == one;
        }
        *after = Corner::NONE;
        if first + CHUNK <= self.width {
            let traced = self.row.after(first + CHUNK);
            *after = Corner::of(traced);
            let is_fine = W::NEEDS.checkers && traced.signature.is_fine();
            is_one &= after.path == one && !is_fine;
            found.tiled |= u32::from(is_fine) << (CHUNK - 1);
        }
        // Beyond the picture no edge crosses a side.
        let beyond = walked.get_mut(count as usize..).unwrap_or_default();
        beyond.fill(Corner::NONE);
        if is_one {
            return found.unite();
        }
        self.divide(line, first, found);
    }

    /// Finds where edges cross the sides of a line of the chunk that begins at column `first`.
    #[inline(always)]
    fn divide(&mut self, line: u32, first: u32, found: &mut Line) {
        let pairs = found.corners.iter().zip(found.corners.iter().skip(1));
        let columns = first..self.width;
        for (column, ((start, end), side)) in columns.zip(pairs.zip(&mut found.sides)) {
            let bit = 1 << (column % CHUNK);
            if start.path == end.path {
            } else if W::NEEDS.checkers && start.path.meets_same(end.path) {
                found.tiled |= bit;
            } else {
                *side = self.divided([column, line], Self::ACROSS, [start, end]);
                found.crossed |= bit;
            }
        }
    }

    /// A step along a side to the right, in 64ths of a pixel.
    const ACROSS: Place = [PIXEL / Side::LENGTH, 0];

    /// Returns a step along a side to the next line.
    pub(super) fn down(&self) -> Place {
        [0, PIXEL / Side::LENGTH / signed(self.parts())]
    }

    /// Finds where an edge crosses the side between two corners that meet something else. It begins at the corner in a
    /// column of a line, and goes on by this step. The side counts as tangled, too, where the colour changes much between a
    /// corner and the edge: then the corner does not show what lies between.
    #[inline(never)]
    pub(super) fn divided(&mut self, start: [u32; 2], along: Place, ends: [&Corner; 2]) -> Side {
        let mut contrast = ends[0].contrast(ends[1]);
        let mut step = Side::LENGTH / 2;
        let mut at = step;
        while contrast > self.tolerance() && step > 1 {
            contrast /= 2;
            step /= 2;
            let found = self.point(start, along.map(|part| part * at), None);
            let is_fine = W::NEEDS.checkers && self.is_fine;
            // Small cells are mixed where they meet the edge.
            let is_like = |end: &Corner| {
                end.path.meets_same(found.path) && (end.contrast(&found) <= UNEVEN || is_fine)
            };
            at += match ends.map(is_like) {
                [true, _] => step,
                [_, true] => -step,
                _ => return Side::tangled(to_u8(unsigned(at))),
            };
        }
        Side::divided(to_u8(unsigned(at)))
    }

    /// Traces a sample of the pixel, or of the part of one between two lines, below the corner in a column of a line. It is one
    /// of several that show 2^`parts` parts along each side of the pixel.
    pub(super) fn sample(&mut self, start: [u32; 2], [right, down]: Place, parts: u32) -> Corner {
        let parts = Some([parts, parts + u32::from(self.is_divided)]);
        self.point(start, [right, down / signed(self.parts())], parts)
    }

    /// Traces the path through the point at a place from the corner in a column of a line.
    #[inline(never)]
    fn point(
        &mut self,
        [column, line]: [u32; 2],
        [right, down]: Place,
        parts: Option<[u32; 2]>,
    ) -> Corner {
        let (y, below) = Self::place(line);
        let direction = self.generator.through([column, y], [right, below + down]);
        let traced = self.row.beside(column, direction, parts);
        if W::NEEDS.checkers {
            self.is_fine = traced.signature.is_fine();
        }
        Corner::of(traced)
    }
}
