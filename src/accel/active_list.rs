//! The active list of a row: the shapes of one kind whose rectangles ([`super::screen_bounds`]) the row
//! cuts in the columns it has come to, from left to right.
//!
//! Bound: a list holds what the rectangles name. A row that has too many for the room asks every shape.

use core::fmt::Debug;
use core::hint::black_box;
use core::marker::PhantomData;

use heapless::Vec;

use super::LONGEST_STRIDE;
use super::screen_rect::ScreenRect;
use crate::number::{difference_modulo_2_32, to_u16, to_u32};
use crate::ray::spread;
use crate::scene::access::ShapeId;
use crate::scene::nearest::Nearest;
use crate::shape::bounded::Bounded;
use crate::vector::{Direction, Point};

/// The columns that a row has advanced to, the last one included.
#[derive(Debug, Default)]
pub(crate) struct Window {
    pub(super) first: u32,
    pub(super) last: u32,
}

/// A shape that can be met in the columns a row has come to, as its rays see it.
#[derive(Clone, Copy, Debug)]
pub struct ActiveShape<'a, K: Bounded> {
    from: K::FromPoint,
    shape: &'a K,
    /// Which of its kind it is.
    index: u16,
    /// Its columns, the last one included.
    left: u16,
    right: u16,
    /// The one in the middle of what is thin in this row; beyond all columns for any other.
    middle: u16,
}

impl<K: Bounded> ActiveShape<'_, K> {
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

/// The memory of an active list.
pub trait Storage<T>: Default + Debug + AsRef<[T]> + AsMut<[T]> {
    /// Adds an item; `None` where there is no room.
    fn add(&mut self, item: T) -> Option<()>;

    /// Keeps the items for which `stays` is true.
    fn keep(&mut self, stays: impl FnMut(&T) -> bool);

    /// Drops all items.
    fn empty(&mut self);
}

impl<T: Debug, const N: usize> Storage<T> for Vec<T, N> {
    #[inline(always)]
    fn add(&mut self, item: T) -> Option<()> {
        self.push(item).ok()
    }

    #[inline(always)]
    fn keep(&mut self, stays: impl FnMut(&T) -> bool) {
        self.retain(stays);
    }

    #[inline(always)]
    fn empty(&mut self) {
        self.clear();
    }
}

/// The active shapes of one kind, in some storage.
#[derive(Debug)]
pub(super) struct ActiveList<'a, K: Bounded, V> {
    active: V,
    /// The first rectangle that has not been looked at.
    next: usize,
    /// What all rays have noted that pass on the right of the thin balls that have been closed.
    passed: u32,
    kind: PhantomData<&'a K>,
}

impl<'a, K: Bounded, V: Storage<ActiveShape<'a, K>>> ActiveList<'a, K, V> {
    /// An empty list. `USED` is false where the list is never read, so that nothing is stored.
    #[inline(always)]
    pub(super) fn new<const USED: bool>() -> Self {
        Self {
            active: V::default(),
            // Hidden from the compiler, or it clears the whole list along with this.
            next: match USED && size_of::<V>() > size_of::<usize>() {
                true => black_box(0),
                false => 0,
            },
            passed: 0,
            kind: PhantomData,
        }
    }

    /// Goes back to the row's first column.
    pub(super) fn restart(&mut self) {
        (self.next, self.passed) = (0, 0);
        self.active.empty();
    }

    /// Whether no shape reaches a column or those after it.
    pub(super) fn has_ended_before(&self, column: u32) -> bool {
        let mut active = self.active.as_ref().iter();
        active.all(|it| u32::from(it.right) < column)
    }

    /// Drops what has ended before the first column, and takes in what begins up to the last; balls from
    /// front to back. Says up to which column that will not change, or `None` where there is no room.
    #[inline(always)]
    pub(super) fn advance(
        &mut self,
        (shapes, rects): (&'a [K], &[ScreenRect]),
        y: u16,
        (first, last): (u32, u32),
        eye: Point,
    ) -> Option<u32> {
        let passed = &mut self.passed;
        self.active.keep(|it| {
            let stays = u32::from(it.right) >= first;
            if K::IS_BALL && !stays && it.middle < u16::MAX {
                *passed ^= ShapeId::at(it.index.into()).passed();
            }
            stays
        });
        let mut until = u32::MAX;
        while let Some(rect) = rects.get(self.next) {
            if rect.has_row(y) {
                if u32::from(rect.left) > last {
                    // As many columns are asked for each time.
                    until = u32::from(rect.left) - (last - first);
                    break;
                }
                if u32::from(rect.right) >= first {
                    if let Some(shape) = shapes.get(rect.shape()) {
                        self.insert(ActiveShape {
                            from: shape.seen_from_eye(eye),
                            shape,
                            index: to_u16(to_u32(rect.shape())),
                            left: rect.left,
                            right: rect.right,
                            middle: rect.middle(y),
                        })?;
                    }
                }
            }
            self.next += 1;
        }
        Some(until)
    }

    /// Puts a shape where it belongs among the others; `None` where there is no room.
    #[inline(always)]
    fn insert(&mut self, shape: ActiveShape<'a, K>) -> Option<()> {
        self.active.add(shape)?;
        let mut rest = self.active.as_mut();
        while let [.., before, place] = rest {
            if !K::is_in_front_of(&shape.from, &before.from) {
                break;
            }
            *place = *before;
            rest = rest.split_last_mut().map_or(&mut [], |(_, rest)| rest);
        }
        if let Some(place) = rest.last_mut() {
            *place = shape;
        }
        Some(())
    }

    /// Asks the shapes that can be met in a column. Notes on which side of thin ones the ray passes.
    #[inline(always)]
    pub(super) fn ask(
        &self,
        (column, direction): (u32, &Direction),
        first: usize,
        nearest: &mut Nearest,
    ) {
        match K::IS_BALL {
            true => self.ask_balls((column, direction), first, nearest),
            false => self.ask_others((column, direction), first, nearest),
        }
    }

    #[inline(always)]
    fn ask_balls(
        &self,
        (column, direction): (u32, &Direction),
        first: usize,
        nearest: &mut Nearest,
    ) {
        nearest.pass(self.passed);
        for it in self.active.as_ref() {
            let id = ShapeId::at(first + usize::from(it.index));
            if it.has_column(column) && nearest.ask_from(it.shape, &it.from, direction, (id, false))
            {
                continue;
            }
            // Whether it may be seen matters beside it only, so that it does not matter further on
            // when it is dropped.
            if it.is_left_of(column)
                && (it.has_ended_before(column) || nearest.may_see::<K>(&it.from))
            {
                nearest.pass(id.passed());
            }
        }
    }

    #[inline(always)]
    fn ask_others(
        &self,
        (column, direction): (u32, &Direction),
        first: usize,
        nearest: &mut Nearest,
    ) {
        for it in self.active.as_ref() {
            if it.has_column(column) {
                let id = ShapeId::at(first + usize::from(it.index));
                let is_thin = it.middle < u16::MAX;
                let is_hit = nearest.ask_from(it.shape, &it.from, direction, (id, is_thin));
                if K::IS_FLAT && is_thin && !is_hit {
                    // On which side of it the ray passes is not known: no other ray has been alike.
                    nearest.pass(spread(column + 1));
                }
            }
        }
    }
}
