//! Floor 7: the pixels of a chunk, from the corners above and below them.

use super::cell::Cell;
use super::corner::{Corner, Line, Side};
use super::places::{CENTER, PIXEL, Place, enough};
use super::walker::Walker;
use super::{CHUNK, ChunkColors};
use crate::accel::World;
use crate::color::Mixture;
use crate::number::{low_word, to_u8, to_u32};
use crate::qualities::Quality;
use crate::render::interpolate::fill;
use crate::shade::highlight::sealed::Shading;

/// Largest change of the components' sum along a pixel that takes no sample: 40 levels, in steps of 1/256.
const STEEP: i32 = 40 << 8;

/// A chunk of a row of pixels, or of the part of the row between two lines.
pub(super) struct Chunk<'c> {
    /// Column of the first pixel.
    first: u32,
    /// Number of pixels.
    count: u32,
    upper: &'c Line,
    lower: &'c Line,
    /// The sides between the corners of both lines, from the left one of the first pixel on.
    uprights: [Side; CHUNK as usize + 1],
}

impl<'c> Chunk<'c> {
    /// Creates a chunk of `count` pixels from column `first` on, between two lines.
    pub(super) fn new([first, count]: [u32; 2], [upper, lower]: [&'c Line; 2]) -> Self {
        Self {
            first,
            count,
            upper,
            lower,
            uprights: [Side::WHOLE; CHUNK as usize + 1],
        }
    }

    /// Computes the colours of all pixels.
    #[inline]
    pub(super) fn paint<W: World, K: Shading, Q: Quality>(
        &mut self,
        walker: &mut Walker<'_, '_, W, K, Q>,
        colors: &mut ChunkColors,
    ) {
        if self.upper.is_flat_with(self.lower) {
            return fill(colors, self.upper.corners[0].color);
        }
        let (crossed, tiled) = self.stand(walker);
        let busy = (self.plain(colors) | crossed | tiled) & u32::MAX >> (CHUNK - self.count);
        if busy != 0 {
            self.mix(walker, colors, (busy, tiled));
        }
    }

    /// Finds where edges cross the sides between both lines. Returns a bit for each pixel that an edge crosses, and one for each
    /// that may show several cells of a checker.
    #[inline(always)]
    fn stand<W: World, K: Shading, Q: Quality>(
        &mut self,
        walker: &mut Walker<'_, '_, W, K, Q>,
    ) -> (u32, u32) {
        if self.upper.is_one_with(self.lower) {
            return (0, 0);
        }
        let mut crossed = self.upper.crossed | self.lower.crossed;
        let mut tiled = self.upper.tiled | self.lower.tiled;
        let corners = self.upper.corners.iter().zip(&self.lower.corners);
        for (place, ((upper, lower), side)) in (0..).zip(corners.zip(&mut self.uprights)) {
            // The pixel to the left of the side, and the one to the right.
            let both = low_word(3 << place >> 1);
            if upper.path == lower.path {
            } else if W::NEEDS.checkers && upper.path.meets_same(lower.path) {
                tiled |= both;
            } else {
                let start = [self.first + place, self.upper.line()];
                *side = walker.divided(start, walker.down(), [upper, lower]);
                crossed |= both;
            }
        }
        (crossed, tiled)
    }

    /// Gives each pixel the mean of its corners' colours. Returns a bit for each pixel whose colour is steep.
    #[inline(always)]
    fn plain(&self, colors: &mut ChunkColors) -> u32 {
        let mut corners = self.upper.corners.iter().zip(&self.lower.corners);
        let Some((upper, lower)) = corners.next() else {
            return 0;
        };
        let mut left = Cell::sum([upper, lower]);
        let mut left_light = left.brightness();
        let (mut steep, mut bit) = (0, 1);
        for ((upper, lower), color) in corners.zip(colors) {
            let right = Cell::sum([upper, lower]);
            *color = left.with(right).mean(4);
            let right_light = right.brightness();
            let across = left_light - right_light;
            // That of the upper corner less that of the lower one.
            let down = 2 * upper.color.brightness() - right_light;
            if across.abs() > 2 * STEEP || down.abs() > STEEP {
                steep |= bit;
            }
            bit <<= 1;
            (left, left_light) = (right, right_light);
        }
        steep
    }

    /// Returns a pixel of the chunk.
    fn cell(&self, place: u32) -> Option<Cell> {
        let from = place as usize;
        let pair = |line: &Line| {
            let corners = line.corners.get(from..)?.first_chunk::<2>()?;
            Some((*corners, *line.sides.get(from)?))
        };
        let (([a, b], top), ([d, c], bottom)) = (pair(self.upper)?, pair(self.lower)?);
        let [left, right] = *self.uprights.get(from..)?.first_chunk()?;
        Some(Cell {
            corners: [a, b, c, d],
            sides: [top, right, bottom, left],
        })
    }

    /// Computes the colours of pixels that an edge crosses, or whose colour is steep: those that have a bit in `busy`. Corners
    /// have their areas as weights, or samples are traced.
    #[inline(never)]
    fn mix<W: World, K: Shading, Q: Quality>(
        &self,
        walker: &mut Walker<'_, '_, W, K, Q>,
        colors: &mut ChunkColors,
        (mut busy, tiled): (u32, u32),
    ) {
        let mut news = News([0; CHUNK as usize]);
        while busy != 0 {
            let place = busy.trailing_zeros();
            busy &= busy - 1;
            let (Some(mut cell), Some(color)) = (self.cell(place), colors.get_mut(place as usize))
            else {
                break;
            };
            let (told, is_whole) = (news.of(place), cell.is_whole());
            let is_tiled = W::NEEDS.checkers && tiled >> place & 1 != 0;
            if is_whole && is_tiled && told == 0 {
                let start = [self.first + place, self.upper.line()];
                *color = walker.sample(start, CENTER[0], 0).color;
                continue;
            }
            if is_tiled && !cell.is_tangled() {
                self.mix_corners(walker, place, &mut cell);
            }
            let contrast = cell.contrast().max(told);
            *color = cell.color();
            if contrast == 0 && !is_whole {
                continue;
            }
            let places = if is_whole && told == 0 {
                CENTER
            } else {
                enough(contrast, walker.tolerance())
            };
            let parts = u32::from(places.len() >= 4) + u32::from(places.len() >= 16);
            // What the corners tell by their areas has the weight of one sample.
            let mut mixture = Mixture::NONE;
            mixture.add(*color, 1);
            for at in places {
                let start = [self.first + place, self.upper.line()];
                let sample = walker.sample(start, *at, parts);
                mixture.add(sample.color, 1);
                busy |= news.tell(self, (place, at), &sample);
            }
            *color = mixture.mean(1 + to_u32(places.len()));
        }
    }

    /// Gives the corners of a pixel the colours of the areas around them, where they may show several cells of a checker.
    #[inline(never)]
    fn mix_corners<W: World, K: Shading, Q: Quality>(
        &self,
        walker: &mut Walker<'_, '_, W, K, Q>,
        place: u32,
        cell: &mut Cell,
    ) {
        let start = [self.first + place, self.upper.line()];
        let places = [[0, 0], [PIXEL, 0], [PIXEL, PIXEL], [0, PIXEL]];
        for (corner, at) in cell.corners.iter_mut().zip(places) {
            corner.color = walker.sample(start, at, 1).color;
        }
    }
}

/// For each pixel of a chunk, the contrast between its corners and what a sample of the pixel beside it hit, if none of the
/// corners hit that; otherwise 0. Such a pixel is sampled, too, so a wire thinner than a pixel is followed along the row.
struct News([u8; CHUNK as usize]);

impl News {
    /// Returns the contrast that is noted for a pixel, in 8-bit levels; 0 if none is.
    fn of(&self, place: u32) -> u32 {
        self.0.get(place as usize).copied().unwrap_or(0).into()
    }

    /// Notes the contrast of a sample for the pixel beside its own, on the side where the sample lies, if no edge crosses that
    /// pixel and nothing is noted yet. Returns the bit of that pixel if something is noted now.
    fn tell(&mut self, chunk: &Chunk<'_>, (place, at): (u32, &Place), sample: &Corner) -> u32 {
        let next = if at[0] > PIXEL / 2 { Some(place + 1) } else { place.checked_sub(1) };
        let Some(next) = next.filter(|next| *next < chunk.count) else {
            return 0;
        };
        let (Some(told @ 0), Some(cell)) = (self.0.get_mut(next as usize), chunk.cell(next)) else {
            return 0;
        };
        if cell.is_whole() && at != &CENTER[0] {
            *told = to_u8(cell.contrast_to(sample));
        }
        u32::from(*told > 0) << next
    }
}
