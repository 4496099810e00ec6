//! The active list of a row for one kind of shape: the shapes whose rectangles
//! ([`super::screen_bounds`]) the row cuts in its present columns. A row advances from left to right.
//!
//! Bound: a list holds at least all shapes whose rectangles are cut. If a list has no room for them,
//! rays test every shape.

use core::fmt::Debug;
use core::hint::black_box;
use core::marker::PhantomData;

use heapless::Vec;

use super::screen_rect::ScreenRect;
use crate::number::{difference_modulo_2_32, to_u16, to_u32};
use crate::ray::{RowPlane, Span};
use crate::scene::nearest::Nearest;
use crate::scene::shape_set::ShapeKind;
use crate::shape::bordered::Bordered;
use crate::vector::{Direction, Point};

/// The range of columns that a row has advanced to, the last one included. A ray is traced only through
/// a column of such a range.
#[derive(Debug, Default)]
pub(crate) struct Window {
    pub(super) first: u32,
    pub(crate) last: u32,
}

/// A shape in an active list, prepared for the rays of the row.
#[derive(Clone, Copy, Debug)]
pub struct ActiveShape<'a, K: Bordered> {
    /// The shape, prepared for rays from the eye.
    pub(super) from: K::FromPoint,
    pub(super) shape: &'a K,
    /// Columns of the whole shape: also of the part that mirrored rays do not reach.
    pub(super) span: Span<K::Rims>,
    /// First and last column in which rays can hit the shape: those of the span that lie in its rectangle.
    pub(super) columns: [u16; 2],
    /// Index of the shape among its kind.
    pub(super) index: u16,
}

impl<K: Bordered> ActiveShape<'_, K> {
    /// Tests whether rays through a column can hit the shape.
    #[inline(always)]
    fn has_column(&self, column: u32) -> bool {
        let [first, last] = self.columns.map(u32::from);
        difference_modulo_2_32(column, first) <= difference_modulo_2_32(last, first)
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
pub(super) struct ActiveList<'a, K: Bordered, V> {
    /// The active shapes; balls are sorted from front to back.
    pub(super) active: V,
    /// Index of the first rectangle that `advance` has not yet reached.
    next: usize,
    kind: PhantomData<&'a K>,
}

impl<'a, K: Bordered, V: Storage<ActiveShape<'a, K>>> ActiveList<'a, K, V> {
    /// Returns an empty list. If the list is never read, `USED` is false and nothing is stored.
    #[inline(always)]
    pub(super) fn new<const USED: bool>() -> Self {
        Self {
            active: V::default(),
            // Hidden from the compiler, which otherwise clears the whole list together with this field.
            next: if USED && size_of::<V>() > size_of::<usize>() { black_box(0) } else { 0 },
            kind: PhantomData,
        }
    }

    /// Empties the list and goes back to the first column of the row.
    pub(super) fn restart(&mut self) {
        self.next = 0;
        self.active.empty();
    }

    /// Returns the first column of a window, or after it, in which a ray can hit an active shape.
    pub(super) fn first_column(&self, window: &Window) -> u32 {
        let active = self.active.as_ref().iter();
        let reached = active.filter(|it| u32::from(it.span.last) >= window.first);
        let first = reached.map(|it| u32::from(it.span.first)).min();
        first.unwrap_or(u32::MAX)
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
        (eye, row): (Point, &RowPlane),
    ) -> Option<u32> {
        self.active.keep(|it| u32::from(it.columns[1]) >= first);
        let mut until = u32::MAX;
        while let Some(rect) = rects.get(self.next) {
            if rect.has_row(y) {
                if u32::from(rect.left) > last {
                    // All windows of a row have the same number of columns.
                    until = u32::from(rect.left) - (last - first);
                    break;
                }
                if u32::from(rect.right) >= first {
                    self.begin(shapes, rect, first, (eye, row))?;
                }
            }
            self.next += 1;
        }
        Some(until)
    }

    /// Inserts the shape of a rectangle if the row's rays can hit it in column `first` or after it. Returns
    /// `None` if there is no room.
    #[inline(never)]
    fn begin(
        &mut self,
        shapes: &'a [K],
        rect: &ScreenRect,
        first: u32,
        (eye, row): (Point, &RowPlane),
    ) -> Option<()> {
        let Some(shape) = shapes.get(rect.shape()) else {
            return Some(());
        };
        let from = shape.seen_from_eye(eye);
        let span = shape.span(&from, row, [rect.left, rect.right]);
        match span.filter(|span| u32::from(span.last) >= first) {
            None => Some(()),
            Some(span) => self.insert(ActiveShape {
                from,
                shape,
                span,
                columns: [span.first.max(rect.left), span.last.min(rect.right)],
                index: to_u16(to_u32(rect.shape())),
            }),
        }
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

    /// Tests whether no shape is active.
    #[inline(always)]
    pub(super) fn is_empty(&self) -> bool {
        self.active.as_ref().is_empty()
    }

    /// Intersects a ray with the active shapes of its column, and keeps the nearest hit in `nearest`.
    #[inline(always)]
    pub(super) fn ask(
        &self,
        (column, direction): (u32, &Direction),
        kind: ShapeKind,
        nearest: &mut Nearest,
    ) {
        // With an iterator, the compiler takes an instruction more for each shape on a Cortex-M3.
        let mut active = self.active.as_ref();
        while let [it, rest @ ..] = active {
            active = rest;
            if it.has_column(column) {
                nearest.ask_from(it.shape, &it.from, direction, kind.id(it.index.into()));
            }
        }
    }
}
