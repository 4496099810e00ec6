//! Which spheres and cylinders the rays of one row of pixels can meet in the columns it has come to:
//! those whose rectangles ([`super::extent`]) the row cuts there, from left to right.

use core::hint::black_box;

use heapless::Vec;

use super::World;
use super::extent::{Covered, Extent};
use super::nearest::{Nearest, nearest_bounded};
use super::query::{Hit, ShapeId};
use crate::number::{Length, difference_modulo_2_32, to_u16, to_u32};
use crate::quality::LONGEST_STRIDE;
use crate::ray::{PathSignature, Ray};
use crate::shape::cylinder::{CylinderFromPoint, PreparedCylinder};
use crate::shape::sphere::{PreparedSphere, SphereFromPoint};
use crate::vector::{Direction, Point};

/// A shape that can be met in the columns a row has come to, as its rays see it.
#[derive(Clone, Copy, Debug)]
struct Open<'a, T, S> {
    seen: T,
    shape: &'a S,
    /// Which of its kind it is.
    index: u16,
    /// Its columns, the last one included.
    left: u16,
    right: u16,
    /// The one in the middle of what is thin in this row; beyond all columns for any other.
    middle: u16,
}

impl<T, S> Open<'_, T, S> {
    /// Whether the shape can be met in a column.
    #[inline(always)]
    fn has_column(&self, column: u32) -> bool {
        let left = u32::from(self.left);
        difference_modulo_2_32(column, left) <= difference_modulo_2_32(self.right.into(), left)
    }

    /// Whether it is thin here, and the rays of a column pass it on its right.
    #[inline(always)]
    fn is_left_of(&self, column: u32) -> bool {
        column > u32::from(self.middle)
    }

    /// Whether it has ended before the first pixel left of a column that is traced for sure.
    #[inline(always)]
    fn has_ended_before(&self, column: u32) -> bool {
        column > u32::from(self.right) + LONGEST_STRIDE
    }
}

/// The shapes of one kind.
#[derive(Debug)]
struct Kind<'a, T, S, const ROOM: usize> {
    open: Vec<Open<'a, T, S>, ROOM>,
    /// The first extent that has not been looked at.
    next: usize,
    /// What all rays have noted that pass on the right of the thin ones that have been closed; asked
    /// of spheres only.
    passed: u32,
}

impl<'a, T: Copy, S: Copy, const ROOM: usize> Kind<'a, T, S, ROOM> {
    #[inline(always)]
    fn new<const USED: bool>() -> Self {
        Self {
            open: Vec::new(),
            // Hidden from the compiler, or it clears the whole list along with this.
            next: if USED { black_box(0) } else { 0 },
            passed: 0,
        }
    }

    /// Opens nothing yet.
    fn begin(&mut self) {
        (self.next, self.passed) = (0, 0);
        self.open.clear();
    }

    /// Closes what has ended before the first column, and opens what begins up to the last, in an
    /// order from front to back; says for which columns that will not change, or `None` where there
    /// is no room.
    #[inline(always)]
    fn turn_to(
        &mut self,
        extents: &[Extent],
        y: u16,
        (first, last): (u32, u32),
        see: impl Fn(usize) -> Option<(T, &'a S)>,
        is_in_front: impl Fn(&T, &T) -> bool,
    ) -> Option<u32> {
        let passed = &mut self.passed;
        self.open.retain(|open| {
            let stays = u32::from(open.right) >= first;
            if !stays && open.middle < u16::MAX {
                *passed ^= ShapeId::of_sphere(open.index.into()).passed();
            }
            stays
        });
        let mut until = u32::MAX;
        while let Some(extent) = extents.get(self.next) {
            if extent.has_row(y) {
                if u32::from(extent.left) > last {
                    // As many columns are asked for each time.
                    until = u32::from(extent.left) - (last - first);
                    break;
                }
                if u32::from(extent.right) >= first {
                    if let Some((seen, shape)) = see(extent.shape()) {
                        let open = Open {
                            seen,
                            shape,
                            index: to_u16(to_u32(extent.shape())),
                            left: extent.left,
                            right: extent.right,
                            middle: extent.middle(y),
                        };
                        self.open.push(open).ok()?;
                        let mut rest = self.open.as_mut_slice();
                        while let [.., before, place] = rest {
                            if !is_in_front(&open.seen, &before.seen) {
                                break;
                            }
                            *place = *before;
                            rest = rest.split_last_mut().map_or(&mut [], |(_, rest)| rest);
                        }
                        if let Some(place) = rest.last_mut() {
                            *place = open;
                        }
                    }
                }
            }
            self.next += 1;
        }
        Some(until)
    }
}

/// How many spheres can be met in the columns a row has come to.
const SPHERES: usize = 16;

/// How many cylinders can be met there.
const CYLINDERS: usize = 8;

/// The shapes that can be met in the columns a row has come to.
///
/// Where there are too many for the room, every ray asks every shape.
#[derive(Debug)]
pub(crate) struct Row<'a> {
    /// Where its rays come from.
    origin: Point,
    /// What is open stays the same for columns that begin before this one.
    until: u32,
    spheres: Kind<'a, SphereFromPoint, PreparedSphere, SPHERES>,
    cylinders: Kind<'a, CylinderFromPoint, PreparedCylinder, CYLINDERS>,
    /// Whether every shape is in every column.
    is_full: bool,
}

/// The extents that a row is about.
#[derive(Clone, Copy)]
pub(crate) struct Cut<'a> {
    pub(super) covered: Covered<'a>,
    /// Which row of pixels it is.
    pub(super) y: u16,
}

impl<'a> Row<'a> {
    /// Every shape in every column; `USED` unless nobody is going to ask.
    #[inline(always)]
    pub(crate) fn of_everything<const USED: bool>(origin: Point) -> Self {
        Self {
            origin,
            until: u32::MAX,
            spheres: Kind::new::<USED>(),
            cylinders: Kind::new::<USED>(),
            is_full: true,
        }
    }

    /// Turns into every shape in every column, seen from another point.
    pub(crate) fn look_from(&mut self, origin: Point) {
        self.origin = origin;
        (self.is_full, self.until) = (true, u32::MAX);
    }

    /// How far along a ray its start lies from where all rays of the row seem to come from; a few steps
    /// off, and below zero by as many where both are one.
    #[inline(always)]
    pub(crate) fn distance(&self, ray: &Ray) -> Length {
        Length::from_bits(self.origin.to(ray.origin).dot(ray.direction))
    }

    /// Turns into what can be met in one row, from its first column on.
    pub(crate) fn see(&mut self) {
        (self.is_full, self.until) = (false, 0);
        self.spheres.begin();
        self.cylinders.begin();
    }

    /// If nothing is open from a column on, to which it has been turned, the first that is not known
    /// of.
    pub(crate) fn clear_until<W: World>(&self, first: u32) -> Option<u32> {
        fn has_ended<T, S>(open: &Open<'_, T, S>, first: u32) -> bool {
            u32::from(open.right) < first
        }
        let is_clear = !self.is_full
            && (!W::NEEDS.spheres || self.spheres.open.iter().all(|it| has_ended(it, first)))
            && (!W::NEEDS.cylinders || self.cylinders.open.iter().all(|it| has_ended(it, first)));
        is_clear.then_some(self.until)
    }

    /// The nearest shape further than `start` along a ray of the column; the distance is from there.
    /// Notes on which side of thin shapes the ray passes.
    #[inline(always)]
    pub(crate) fn meet<W: World>(
        &self,
        world: &W,
        column: u32,
        (direction, start): (&Direction, Length),
        signature: &mut PathSignature,
    ) -> Hit {
        if self.is_full {
            return self.nearest_of_all(world, column, (direction, start), signature);
        }
        self.nearest(world, column, (direction, start), signature)
    }

    /// The nearest of all shapes.
    #[cold]
    #[inline(never)]
    fn nearest_of_all<W: World>(
        &self,
        world: &W,
        column: u32,
        (direction, start): (&Direction, Length),
        signature: &mut PathSignature,
    ) -> Hit {
        // It is not known what is thin: no other ray has been alike.
        signature.note(column);
        let ray = Ray {
            origin: self.origin,
            direction: *direction,
        };
        nearest_bounded::<W, false>(world, &ray, start, ShapeId::NONE, signature)
    }

    /// Goes on to some columns, which do not begin before the last ones.
    #[inline(always)]
    pub(crate) fn turn_to<'c, W: World>(
        &mut self,
        world: &'a W,
        cut: impl FnOnce() -> Cut<'c>,
        columns: (u32, u32),
    ) {
        if columns.0 >= self.until {
            self.open(world, cut(), columns);
        }
    }

    /// Turns to what can be met there.
    #[inline(never)]
    fn open<W: World>(&mut self, world: &'a W, cut: Cut<'_>, columns: (u32, u32)) {
        let (parts, origin) = (world.parts(), self.origin);
        let Cut { covered, y } = cut;
        let spheres = match W::NEEDS.spheres {
            true => self.spheres.turn_to(
                covered.spheres,
                y,
                columns,
                |index| {
                    let sphere = parts.spheres.get(index)?;
                    Some((sphere.surely_seen_from(origin), sphere))
                },
                SphereFromPoint::is_in_front_of,
            ),
            false => Some(u32::MAX),
        };
        let cylinders = match W::NEEDS.cylinders {
            true => self.cylinders.turn_to(
                covered.cylinders,
                y,
                columns,
                |index| {
                    let cylinder = parts.cylinders.get(index)?;
                    Some((cylinder.seen_from(origin), cylinder))
                },
                |_, _| false,
            ),
            false => Some(u32::MAX),
        };
        match (spheres, cylinders) {
            (Some(spheres), Some(cylinders)) => {
                (self.is_full, self.until) = (false, spheres.min(cylinders));
            }
            _ => {
                // All anew for the next columns: what is open must not depend on where a row began.
                self.see();
                (self.is_full, self.until) = (true, columns.0 + 1);
            }
        }
    }

    /// The nearest of the shapes that are open.
    #[inline(never)]
    fn nearest<W: World>(
        &self,
        world: &W,
        column: u32,
        (direction, start): (&Direction, Length),
        signature: &mut PathSignature,
    ) -> Hit {
        let mut nearest = Nearest::beyond(start);
        if W::NEEDS.spheres {
            nearest.pass(self.spheres.passed);
            self.meet_spheres(column, *direction, &mut nearest);
        }
        if W::NEEDS.cylinders {
            self.meet_cylinders(world, column, direction, &mut nearest);
        }
        nearest.hit(signature)
    }

    #[inline(always)]
    fn meet_spheres(&self, column: u32, direction: Direction, nearest: &mut Nearest) {
        for open in &self.spheres.open {
            let number = ShapeId::of_sphere(open.index.into());
            if open.has_column(column)
                && open.seen.may_be_met(open.seen.nearest_approach(direction))
                && nearest.meet_sphere(open.shape, open.seen.way(), direction, number)
            {
                continue;
            }
            // Whether it may be seen matters beside it only, so that it does not matter further on
            // when it is closed.
            if open.is_left_of(column)
                && (open.has_ended_before(column) || nearest.may_see(&open.seen))
            {
                nearest.pass(number.passed());
            }
        }
    }

    #[inline(always)]
    fn meet_cylinders<W: World>(
        &self,
        world: &W,
        column: u32,
        direction: &Direction,
        nearest: &mut Nearest,
    ) {
        let parts = world.parts();
        for open in &self.cylinders.open {
            if !open.has_column(column) {
                continue;
            }
            let is_thin = open.middle < u16::MAX;
            let number = parts.cylinder_number(open.index.into());
            nearest.meet_cylinder::<false>(open.shape, (&open.seen, is_thin), direction, number);
        }
    }
}
