//! Which spheres and cylinders the rays of one row of pixels can meet, and in which columns: the
//! row of the rectangles in which they can be seen ([`super::extent`]), from left to right.

use heapless::Vec;

use super::World;
use super::extent::Covered;
use super::query::{Hit, Nearest, ShapeNumber, nearest_bounded};
use crate::number::Length;
use crate::ray::{Ray, Trail};
use crate::shape::cylinder::SeenCylinder;
use crate::shape::sphere::SeenSphere;
use crate::vector::{Direction, Point};

/// The columns in which a shape can be met, held to the 16 bits of a picture's side.
#[derive(Clone, Copy, Debug)]
struct Span {
    first: u16,
    last: u16,
    /// Spheres come first, then cylinders.
    shape: u16,
}

/// A shape that can be met in the columns a row has come to, as its rays see it.
#[derive(Clone, Copy, Debug)]
struct Open<T> {
    seen: T,
    /// The last column.
    last: u16,
    /// Which of its kind.
    index: u16,
}

/// How many spans a row holds.
const SPANS: usize = 64;

/// How many spheres can be met in the columns a row has come to.
const SPHERES: usize = 16;

/// How many cylinders can be met there.
const CYLINDERS: usize = 8;

/// The shapes that can be met in each column of a row.
///
/// Where there are too many for the room, every ray of the row asks every shape.
#[derive(Debug)]
pub(crate) struct Row {
    /// Where its rays come from.
    origin: Point,
    /// In rising order of their first columns.
    spans: Vec<Span, SPANS>,
    /// The first span that has not been opened.
    next: usize,
    /// What is open stays the same for columns that begin before this one.
    until: u32,
    spheres: Vec<Open<SeenSphere>, SPHERES>,
    cylinders: Vec<Open<SeenCylinder>, CYLINDERS>,
    /// Whether every shape is in every column.
    is_full: bool,
}

impl Row {
    /// Every shape in every column.
    #[inline(always)]
    pub(crate) fn of_everything(origin: Point) -> Self {
        Self {
            origin,
            spans: Vec::new(),
            next: 0,
            until: u32::MAX,
            spheres: Vec::new(),
            cylinders: Vec::new(),
            is_full: true,
        }
    }

    /// Turns into every shape in every column, seen from another point.
    pub(crate) fn look_from(&mut self, origin: Point) {
        self.origin = origin;
        self.fill_up();
    }

    fn fill_up(&mut self) {
        (self.is_full, self.until) = (true, u32::MAX);
    }

    /// The nearest shape further than `start` along a ray of the column; the distance is from there.
    #[inline(always)]
    pub(crate) fn meet<W: World>(
        &self,
        world: &W,
        direction: Direction,
        start: Length,
        trail: &mut Trail,
    ) -> Hit {
        if self.is_full {
            let origin = self.origin;
            return nearest_bounded(world, &Ray { origin, direction }, start, trail);
        }
        self.nearest(world, direction, start, trail)
    }

    /// Turns into what can be met in the row `y` of the pixels that shapes cover.
    pub(crate) fn see(&mut self, covered: &Covered<'_>, y: u16) {
        (self.is_full, self.until) = (false, 0);
        self.spans.clear();
        self.begin();
        let shapes = covered.spheres.iter().chain(covered.cylinders);
        for (extent, shape) in shapes.zip(0..) {
            if extent.top <= y && y <= extent.bottom {
                self.add(Span {
                    first: extent.left,
                    last: extent.right,
                    shape,
                });
            }
        }
    }

    /// Opens nothing yet.
    fn begin(&mut self) {
        self.next = 0;
        self.spheres.clear();
        self.cylinders.clear();
    }

    fn add(&mut self, span: Span) {
        if self.spans.push(span).is_err() {
            self.fill_up();
        }
        // Sorted by insertion: rows see few shapes.
        let mut rest = self.spans.as_mut_slice();
        while let [earlier @ .., before, span] = rest {
            if before.first <= span.first {
                break;
            }
            core::mem::swap(before, span);
            rest = match earlier {
                [] => break,
                _ => {
                    let end = rest.len() - 1;
                    rest.get_mut(..end).unwrap_or_default()
                }
            };
        }
    }

    /// Goes on to some columns, which do not begin before the last ones.
    #[inline(always)]
    pub(crate) fn turn_to<W: World>(&mut self, world: &W, (first, last): (u32, u32)) {
        if first >= self.until {
            self.open(world, first, last);
        }
    }

    /// Closes what has ended before the first column, and opens what begins up to the last.
    #[inline(never)]
    fn open<W: World>(&mut self, world: &W, first: u32, last: u32) {
        (self.is_full, self.until) = (false, u32::MAX);
        self.spheres.retain(|open| u32::from(open.last) >= first);
        self.cylinders.retain(|open| u32::from(open.last) >= first);
        while let Some(span) = self.spans.get(self.next) {
            if u32::from(span.first) > last {
                // As many columns are asked for each time.
                self.until = u32::from(span.first) - (last - first);
                break;
            }
            let span = *span;
            self.next += 1;
            if u32::from(span.last) >= first && !self.open_span(world, span) {
                // What is open must not depend on where the row began.
                self.begin();
                (self.is_full, self.until) = (true, first + 1);
                return;
            }
        }
        let ends = self.spheres.iter().map(|open| open.last);
        let ends = ends.chain(self.cylinders.iter().map(|open| open.last));
        for last in ends {
            self.until = self.until.min(u32::from(last) + 1);
        }
    }

    /// Opens a span; false where there is no room for it.
    fn open_span<W: World>(&mut self, world: &W, span: Span) -> bool {
        let parts = world.parts();
        let (last, shape) = (span.last, usize::from(span.shape));
        if let Some(sphere) = parts.spheres.get(shape) {
            let seen = sphere.surely_seen_from(self.origin);
            let index = span.shape;
            return self.spheres.push(Open { seen, last, index }).is_ok();
        }
        let index = shape - parts.spheres.len();
        match parts.cylinders.get(index) {
            Some(cylinder) => {
                let seen = cylinder.seen_from(self.origin);
                let index = index as u16;
                self.cylinders.push(Open { seen, last, index }).is_ok()
            }
            None => true,
        }
    }

    /// The nearest of the shapes that are open.
    #[inline(never)]
    fn nearest<W: World>(
        &self,
        world: &W,
        direction: Direction,
        start: Length,
        trail: &mut Trail,
    ) -> Hit {
        let parts = world.parts();
        let mut nearest = Nearest::beyond(start);
        for Open { seen, index, .. } in &self.spheres {
            if !seen.may_be_met(direction) {
                continue;
            }
            let index = usize::from(*index);
            if let Some(sphere) = parts.spheres.get(index) {
                let number = ShapeNumber::of_sphere(index);
                nearest.meet_sphere(sphere, seen.way(), direction, number);
            }
        }
        for Open { seen, index, .. } in &self.cylinders {
            let index = usize::from(*index);
            if let Some(cylinder) = parts.cylinders.get(index) {
                nearest.meet_cylinder(cylinder, seen, direction, parts.cylinder_number(index));
            }
        }
        nearest.hit(trail)
    }
}
