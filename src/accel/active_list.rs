//! The active list of a row for one kind of shape: the shapes whose rectangles
//! ([`super::screen_bounds`]) the row cuts in its present columns. A row advances from left to right.
//!
//! Bound: a list holds at least all shapes whose rectangles are cut. If a list has no room for them,
//! rays test every shape.

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

/// The range of columns that a row has advanced to, the last one included. A ray is traced only through
/// a column of such a range.
#[derive(Debug, Default)]
pub(crate) struct Window {
    pub(super) first: u32,
    pub(super) last: u32,
}

/// A shape in an active list, prepared for the rays of the row.
#[derive(Clone, Copy, Debug)]
pub struct ActiveShape<'a, K: Bounded> {
    /// The shape, prepared for rays from the eye.
    from: K::FromPoint,
    shape: &'a K,
    /// Index of the shape among its kind.
    index: u16,
    /// First column of the shape's rectangle.
    left: u16,
    /// Last column of the shape's rectangle.
    right: u16,
    /// Centre column if the shape is thin in this row, else `u16::MAX`.
    middle: u16,
}

impl<K: Bounded> ActiveShape<'_, K> {
    /// Tests whether rays through a column can hit the shape.
    #[inline(always)]
    fn has_column(&self, column: u32) -> bool {
        let left = u32::from(self.left);
        difference_modulo_2_32(column, left) <= difference_modulo_2_32(self.right.into(), left)
    }

    /// Tests whether the shape is thin in this row and the rays of a column pass to the right of its
    /// centre.
    #[inline(always)]
    fn is_left_of(&self, column: u32) -> bool {
        column > u32::from(self.middle)
    }

    /// Tests whether the shape ends more than [`LONGEST_STRIDE`] columns before a column. At least one
    /// traced pixel then lies between them.
    #[inline(always)]
    fn has_ended_before(&self, column: u32) -> bool {
        column > u32::from(self.right) + LONGEST_STRIDE
    }
}

/// The memory of an active list. Its capacity may be fixed.
pub trait Storage<T>: Default + Debug + AsRef<[T]> + AsMut<[T]> {
    /// Adds an item. Returns `None` if there is no room.
    fn add(&mut self, item: T) -> Option<()>;

    /// Keeps the items for which `stays` is true.
    fn keep(&mut self, stays: impl FnMut(&T) -> bool);

    /// Empties an active list; its memory stays.
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

/// The active list of one kind of shape.
#[derive(Debug)]
pub(super) struct ActiveList<'a, K: Bounded, V> {
    /// The active shapes; balls are sorted from front to back.
    active: V,
    /// Index of the first rectangle that `advance` has not yet reached.
    next: usize,
    /// Sum (XOR) of the notes of all thin balls that were dropped. All further rays pass on their
    /// right.
    passed: u32,
    kind: PhantomData<&'a K>,
}

impl<'a, K: Bounded, V: Storage<ActiveShape<'a, K>>> ActiveList<'a, K, V> {
    /// Returns an empty list. If the list is never read, `USED` is false and nothing is stored.
    #[inline(always)]
    pub(super) fn new<const USED: bool>() -> Self {
        Self {
            active: V::default(),
            // Hidden from the compiler, which otherwise clears the whole list together with this field.
            next: match USED && size_of::<V>() > size_of::<usize>() {
                true => black_box(0),
                false => 0,
            },
            passed: 0,
            kind: PhantomData,
        }
    }

    /// Empties the list and goes back to the first column of the row.
    pub(super) fn restart(&mut self) {
        (self.next, self.passed) = (0, 0);
        self.active.empty();
    }

    /// Tests whether all active shapes end before a column.
    pub(super) fn has_ended_before(&self, column: u32) -> bool {
        let mut active = self.active.as_ref().iter();
        active.all(|it| u32::from(it.right) < column)
    }

    /// Advances to the columns from `first` to `last`: drops shapes that end before, adds shapes that
    /// begin.
    ///
    /// Balls are kept sorted from front to back. Returns the smallest `first` for which the list must
    /// advance again, or `None` if there is no room.
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
                    // All windows of a row have the same number of columns.
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

    /// Inserts a shape: a ball behind all balls in front of it, any other shape at the end. Returns
    /// `None` if there is no room.
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

    /// Intersects a ray with the active shapes of its column, and keeps the nearest hit in `nearest`.
    ///
    /// Notes on which side of thin shapes the ray passes. `first` is the number of the first shape of
    /// this kind.
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

    /// Intersects a ray with the active balls of its column, front to back.
    ///
    /// Notes the thin balls that the ray passes on their right.
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
            // Whether something nearer hides the ball counts only close to it. So dropping the ball
            // later changes nothing.
            if it.is_left_of(column)
                && (it.has_ended_before(column) || nearest.may_see::<K>(&it.from))
            {
                nearest.pass(id.passed());
            }
        }
    }

    /// Intersects a ray with the active shapes of its column, for kinds that are not balls.
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
                    // It is unknown on which side the ray passes, so the signature equals no other
                    // ray's.
                    nearest.pass(spread(column + 1));
                }
            }
        }
    }
}
