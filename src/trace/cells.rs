//! The cells of a checker that the columns of a stretch show.

use super::plane_line::PlaneLine;
use super::stops::Stop;
use super::{Stops, Tracer};
use crate::accel::World;
use crate::checker::{PLACES, PreparedChecker};
use crate::color::Sum;
use crate::number::{Unit, share};
use crate::qualities::Quality;
use crate::scene::Surface;
use crate::scene::surface::checker_of;
use crate::shade::highlight::sealed::Shading;

/// The cells that the columns of a stretch show.
#[derive(Clone, Copy)]
pub(crate) struct Cells {
    first: u32,
    /// A bit for each column from `first` on. It is set where the checker's colour is seen.
    bits: u64,
    /// A bit for each column from `first` on. It is set where an odd number of borders along [`PreparedChecker::axis_aside`] lies
    /// between the first column and this one. In a frame without smooth edges all are 0.
    aside: u64,
}

/// Largest number of borders of cells in a stretch.
const MOST_BORDERS: i64 = 511;

impl Cells {
    /// Returns the cells along a line. `None` if there are more than [`MOST_BORDERS`] borders. The borders along the axis
    /// `aside` are counted by themselves, too.
    fn new(line: &PlaneLine<'_>, checker: &PreparedChecker, aside: Option<usize>) -> Option<Self> {
        let [start, end] = line.ends.map(|stop| checker.places(stop.place));
        let first = line.columns[0];
        let mut cells = Self {
            first,
            bits: 0,
            aside: 0,
        };
        for (axis, (from, to)) in start.into_iter().zip(end).enumerate() {
            let [from_cell, low, high] = [from, from.min(to), from.max(to)].map(|it| it >> PLACES);
            if high - low > MOST_BORDERS {
                return None;
            }
            if from_cell & 1 != 0 {
                cells.bits = !cells.bits;
            }
            for cell in low + 1..=high {
                let border = cell << PLACES;
                let parts = [from, to].map(|end| end.abs_diff(border));
                let columns = line.columns_before(parts, from < to);
                let beyond = u64::MAX.checked_shl(columns).unwrap_or(0);
                cells.bits ^= beyond;
                if aside == Some(axis) {
                    cells.aside ^= beyond;
                }
            }
        }
        Some(cells)
    }

    /// Returns the bits of a column: whether it shows the checker's colour, and, if the frame `is_smooth`, its bit in `aside`. Also
    /// returns how many columns from there on have the same bits: at most `most`, up to the end of the stretch.
    #[inline(always)]
    pub(crate) fn run(self, column: u32, most: u32, is_smooth: bool) -> ([bool; 2], u32) {
        let from = |bits: u64| {
            let bits = bits >> ((column - self.first) & 63);
            let is_set = bits & 1 != 0;
            (is_set, if is_set { !bits } else { bits })
        };
        let (holds, other) = from(self.bits);
        let (is_aside, aside) = if is_smooth { from(self.aside) } else { (false, 0) };
        let count = (other | aside).trailing_zeros();
        ([holds, is_aside], count.min(most))
    }
}

/// The two colours of a path that meets a checker at a known hit.
#[derive(Clone, Copy)]
pub(crate) struct Cell {
    /// Whether it shows the checker's colour there.
    pub(crate) holds: bool,
    /// By how much more light comes along the path than if it showed a cell of the other kind.
    pub(crate) change: Sum,
}

impl<W: World, K: Shading, Q: Quality> Tracer<'_, W, K, Q> {
    /// Returns both colours of a path that hits a plane with a checker at this level, after flat mirrors.
    #[inline(never)]
    pub(crate) fn cell(&self, path: &Stops, level: usize) -> Option<Cell> {
        let (world, parts) = (self.world, self.world.parts());
        let (mut from, mut weight) = (self.visibility.from, Unit::ONE);
        let (before, after) = path.all().split_at_checked(level)?;
        for stop in before {
            let mirror = parts.plane(stop.shape)?;
            weight = share(weight, parts.material(mirror.material).mirror);
            from = stop.place;
        }
        let stop = after.first()?;
        let plane = (parts.plane(stop.shape)?, stop.shape, stop.is_inside);
        let (view, _) = from.to(stop.place).0.normalised();
        let surface = Surface::flat(&parts, plane, stop.place).seen_along(view);
        let weight = weight - Self::reflected(world, &surface, weight);
        let lit = self.shade(&surface);
        let (holds, other) = lit.cell?;
        let [own, other] = [lit.color, other].map(|color| {
            let mut sum = Sum::ZERO;
            sum.add(weight, color);
            sum
        });
        let change = own.less(other);
        Some(Cell { holds, change })
    }

    /// Returns which cells of a plane's checker are seen from the first of two columns to the one before the last. The two
    /// paths hit the plane at this level, and all between do so. `None` if there are too many.
    #[inline(never)]
    pub(crate) fn cells(
        &mut self,
        columns: [u32; 2],
        ends: [&Stops; 2],
        level: usize,
    ) -> Option<Cells> {
        let paths = ends.map(Stops::all);
        let checker = checker_of(self.world, paths[0].get(level)?.shape)?;
        let parts = self.world.parts();
        // A place is epsilon above the hit.
        let hit = |stop: &Stop| match parts.plane(stop.shape) {
            Some(plane) => {
                let below = plane.normal.reversed_if(!stop.is_inside);
                stop.place.lifted(below, parts.epsilon)
            }
            None => stop.place,
        };
        let plane = parts.plane(paths[0].get(level)?.shape);
        let plane = plane.filter(|_| Q::SMOOTHNESS > 1);
        let aside = plane.map(|plane| PreparedChecker::axis_aside(plane.normal));
        let line = PlaneLine::new(self.culling.ahead()?, columns, (paths, level), &hit)?;
        Cells::new(&line, checker, aside)
    }
}
