//! Floor 6: the colours of a row of pixels, most of them between two that were traced.
//!
//! Every fourth pixel of a row is traced. Where the paths of two that follow each other met the
//! same shapes in the same order, each lit by the same lights, what lies between them is taken from
//! their colours (Akimoto, Mase, Suenaga, "Pixel-Selected Ray Tracing", IEEE Computer Graphics and
//! Applications 11(4), 1991), unless the colours bend too much. Else the pixel half way is traced,
//! and so on down to single pixels.
//!
//! Which pixels are traced depends on their columns alone, so a part of a row has the colours that it
//! has in the whole.

use crate::camera::RowDirections;
use crate::color::{Bend, Sum};
use crate::quality::{Quality, STRIDE};
use crate::scene::World;
use crate::shade::sealed::Shading;
use crate::trace::{Traced, Tracer};

/// The colours of a row from one column on, in the order they are asked for.
pub(crate) struct Colors<'s, 'a, W: World, K, Q> {
    tracer: &'s mut Tracer<'a, W, K, Q>,
    directions: RowDirections,
    /// The column of the next colour.
    column: u32,
    /// The last column that may be traced: some beyond the picture, unless it is so narrow that their
    /// rays would leave the formats.
    last: u32,
    /// The colours of the stretch that the column lies in.
    stretch: [Sum; STRIDE as usize],
    /// The first pixel of the stretch before.
    before: Option<Traced>,
    /// The first pixel of the next stretch.
    next: Traced,
}

impl<'s, 'a, W: World, K: Shading, Q: Quality> Colors<'s, 'a, W, K, Q> {
    /// From `column` on, in a picture so wide.
    #[inline(always)]
    pub(crate) fn new(
        tracer: &'s mut Tracer<'a, W, K, Q>,
        directions: RowDirections,
        column: u32,
        width: u32,
    ) -> Self {
        let mut colors = Self {
            tracer,
            directions,
            column,
            last: match width >= 2 * STRIDE {
                true => width + STRIDE - 1,
                false => width - 1,
            },
            stretch: [Sum::ZERO; STRIDE as usize],
            before: None,
            next: Traced::NONE,
        };
        if Q::INTERPOLATES {
            colors.start();
        } else {
            colors.tracer.turn_to(column, column + STRIDE);
        }
        colors
    }

    /// The colour of the next column, which lies inside of the picture.
    #[inline(always)]
    pub(crate) fn next_color(&mut self) -> Sum {
        let column = self.column;
        self.column += 1;
        let place = column % STRIDE;
        if !Q::INTERPOLATES {
            if place == 0 {
                self.tracer.turn_to(column, column + STRIDE);
            }
            return self.trace(column).sum;
        }
        if place == 0 {
            self.follow(column);
        }
        self.stretch[place as usize]
    }

    /// Makes ready for a row that begins inside of a stretch.
    #[inline(never)]
    fn start(&mut self) {
        let first = self.column - self.column % STRIDE;
        // How much the colours bend is known from the stretch before.
        let before = first.saturating_sub(STRIDE);
        self.tracer.turn_to(before, before + STRIDE);
        if before < first {
            self.before = Some(self.trace(before));
        }
        self.next = self.trace(first);
        if first < self.column {
            self.follow(first);
        }
    }

    /// Goes on to the stretch that begins at a column.
    #[inline(never)]
    fn follow(&mut self, first: u32) {
        let end = first + STRIDE;
        self.tracer.turn_to(first, end);
        let start = self.next;
        let [.., second, third, fourth] = [0, 1, 2, 3].map(|place| first + place);
        self.stretch[0] = start.sum;
        if end > self.last {
            for place in 1..STRIDE {
                if first + place <= self.last {
                    self.stretch[place as usize] = self.trace(first + place).sum;
                }
            }
            return;
        }
        let before = self.before.replace(start);
        let next = self.trace(end);
        self.next = next;
        let is_alike = start.trail == next.trail;
        if let Some(before) = before.filter(|it| is_alike && it.trail == start.trail) {
            let bend = Bend::of(before.sum, start.sum, next.sum);
            if bend.is_small() {
                self.stretch = start.sum.towards(next.sum, bend);
                return;
            }
        }
        let middle = self.trace(third);
        self.stretch[2] = middle.sum;
        if is_alike && middle.trail == start.trail {
            let bend = Bend::of(start.sum, middle.sum, next.sum);
            if bend.is_small() {
                self.stretch[1] = start.sum.half_way(middle.sum, bend);
                self.stretch[3] = middle.sum.half_way(next.sum, bend);
                return;
            }
        }
        self.stretch[1] = self.between(&start, &middle, second);
        self.stretch[3] = self.between(&middle, &next, fourth);
    }

    /// The colour of the one pixel between two.
    #[inline(always)]
    fn between(&mut self, start: &Traced, end: &Traced, column: u32) -> Sum {
        if start.trail == end.trail {
            let bend = Bend::of(start.sum, start.sum, end.sum);
            if bend.is_small() {
                return start.sum.half_way(end.sum, Bend::NONE);
            }
        }
        self.trace(column).sum
    }

    #[inline(never)]
    fn trace(&mut self, column: u32) -> Traced {
        self.tracer.trace(column, self.directions.of(column))
    }
}
