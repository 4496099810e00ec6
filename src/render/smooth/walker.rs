//! Floor 7: traces what pixels with smooth edges need: lines of corners, points of sides, and samples.

use super::CHUNK;
use super::corner::{Corner, Line, Side};
use super::places::{PIXEL, Place};
use crate::accel::World;
use crate::camera::RayGenerator;
use crate::color::Levels;
use crate::number::{signed, to_u8, unsigned};
use crate::render::Quality;
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
}

impl<W: World, K: Shading, Q: Quality> Walker<'_, '_, W, K, Q> {
    /// Largest contrast that an edge may be off by, and that a sample may stand for, in 8-bit levels.
    pub(super) const TOLERANCE: u32 = match Q::SMOOTHNESS {
        2 => 24,
        _ => 12,
    };

    /// Number of lines of corners for each row of pixels.
    pub(super) const LINES: u32 = if Q::SMOOTHNESS == 4 { 2 } else { 1 };

    /// Returns the line above the row of pixels.
    pub(super) fn first_line(&self) -> u32 {
        self.y * Self::LINES
    }

    /// Returns the row of pixels that a line lies in, and how far below its upper edges, in 64ths of a pixel.
    fn place(line: u32) -> (u32, i32) {
        let below = line % Self::LINES;
        (
            line / Self::LINES,
            signed(below) * (PIXEL / signed(Self::LINES)),
        )
    }

    /// Makes `found` the corners on one line of the chunk that begins at column `first`.
    #[inline(never)]
    pub(super) fn walk(&mut self, line: u32, first: u32, found: &mut Line) {
        if self.line != line {
            self.line = line;
            self.row.turn(self.generator, Self::place(line), first);
        }
        found.begin(line, first);
        let last = (first + CHUNK).min(self.width);
        if let Some(all) = self.row.missed_until(first, last).map(Corner::of) {
            found.corners = [all; CHUNK as usize + 1];
            (found.is_flat, found.is_one) = (true, true);
            return;
        }
        let [walked @ .., after] = &mut found.corners;
        let count = CHUNK.min(self.width + 1 - first);
        let pixels = walked.get_mut(..count as usize).unwrap_or_default();
        self.row.fill(pixels, |sum| Corner {
            color: Levels::of(sum),
            ..Corner::NONE
        });
        let paths = &self.row.marks.paths;
        let one = paths[0];
        let mut is_one = true;
        for (corner, path) in pixels.iter_mut().zip(paths) {
            corner.path = *path;
            is_one &= *path == one;
        }
        *after = Corner::NONE;
        if first + CHUNK <= self.width {
            *after = Corner::of(self.row.after(first + CHUNK));
            is_one &= after.path == one;
        }
        // Beyond the picture no edge crosses a side.
        let beyond = walked.get_mut(count as usize..).unwrap_or_default();
        beyond.fill(Corner::NONE);
        found.is_one = is_one;
        if is_one {
            return;
        }
        let pairs = found.corners.iter().zip(found.corners.iter().skip(1));
        let columns = first..self.width;
        for (column, ((start, end), side)) in columns.zip(pairs.zip(&mut found.sides)) {
            if start.path != end.path {
                *side = self.divided([column, line], Self::ACROSS, [start, end]);
                found.crossed |= 1 << (column % CHUNK);
            }
        }
    }

    /// A step along a side to the right, in 64ths of a pixel.
    const ACROSS: Place = [PIXEL / Side::LENGTH, 0];

    /// A step along a side to the next line.
    pub(super) const DOWN: Place = [0, PIXEL / Side::LENGTH / signed(Self::LINES)];

    /// Finds where an edge crosses the side between two corners that meet something else. It begins at the corner in a
    /// column of a line, and goes on by this step.
    #[inline(never)]
    pub(super) fn divided(&mut self, start: [u32; 2], along: Place, ends: [&Corner; 2]) -> Side {
        let mut contrast = ends[0].contrast(ends[1]);
        let mut step = Side::LENGTH / 2;
        let mut at = step;
        while contrast > Self::TOLERANCE && step > 1 {
            contrast /= 2;
            step /= 2;
            let path = self.point(start, along.map(|part| part * at)).path;
            at += match ends.map(|end| end.path == path) {
                [true, _] => step,
                [_, true] => -step,
                _ => return Side::tangled(to_u8(unsigned(at))),
            };
        }
        Side::divided(to_u8(unsigned(at)))
    }

    /// Traces a sample of the pixel, or of the part of one between two lines, below the corner in a column of a line.
    pub(super) fn sample(&mut self, start: [u32; 2], [right, down]: Place) -> Corner {
        self.point(start, [right, down / signed(Self::LINES)])
    }

    /// Traces the path through the point at a place from the corner in a column of a line.
    #[inline(never)]
    fn point(&mut self, [column, line]: [u32; 2], [right, down]: Place) -> Corner {
        let (y, below) = Self::place(line);
        let directions = self.generator.row_below(y, below + down);
        Corner::of(self.row.beside(column, directions.beside(column, right)))
    }
}
