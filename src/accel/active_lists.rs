//! The active lists of all kinds, for rays from one eye: the camera or its image in a plane.

use heapless::Vec;

use super::active_list::{ActiveList, ActiveShape, Storage, Window};
use super::screen_bounds::Rects;
use crate::number::Length;
use crate::ray::{PathSignature, Ray};
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::nearest::{Hit, Nearest, nearest_of};
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Capacity, Room, used};
use crate::vector::{Direction, Point};

macro_rules! active_lists {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident
            [$active_list:ident $active:tt] $($more:tt)* })*
    ) => {
        /// How much memory a scene's active lists take.
        pub trait ActiveRoom: Capacity {
            $(
                #[doc = concat!("The active ", stringify!($list), ".")]
                type $active_list<'a>: Storage<ActiveShape<'a, crate::shape::$prepared>>;
            )*
        }

        impl<$($header)*> ActiveRoom for Room<$($arguments)*> {
            $(
                type $active_list<'a> = Vec<ActiveShape<'a, crate::shape::$prepared>, $active>;
            )*
        }

        /// The shapes that can be met in the columns that a row has come to.
        ///
        /// Where there are too many for the room, every ray asks every shape.
        #[derive(Debug)]
        pub(super) struct ActiveLists<'a, R: ActiveRoom> {
            /// Where the rays come from.
            eye: Point,
            /// The lists stay the same for columns that begin before this one.
            until: u32,
            $($list: ActiveList<'a, crate::shape::$prepared, R::$active_list<'a>>,)*
            /// Whether every shape is asked in every column.
            is_full: bool,
        }

        impl<'a, R: ActiveRoom> ActiveLists<'a, R> {
            /// Empty lists, or every shape in every column if `is_full`. `USED` is false where the lists are
            /// never read.
            #[inline(always)]
            pub(super) fn new<const USED: bool>(eye: Point, is_full: bool) -> Self {
                Self {
                    eye,
                    until: if is_full { u32::MAX } else { 0 },
                    $($list: ActiveList::new::<USED>(),)*
                    is_full,
                }
            }

            /// Goes back to the row's first column, seen from an eye.
            pub(super) fn restart(&mut self, eye: Point, is_full: bool) {
                self.eye = eye;
                (self.is_full, self.until) = (is_full, if is_full { u32::MAX } else { 0 });
                $(self.$list.restart();)*
            }

            /// If no shape reaches the window's first column or those after it, the first that is not
            /// known of.
            pub(super) fn clear_until<W: SceneAccess>(&self, window: &Window) -> Option<u32> {
                let is_clear = !self.is_full
                    $(&& (!W::NEEDS.$list || self.$list.has_ended_before(window.first)))*;
                is_clear.then_some(self.until)
            }

            /// Looks for the shapes of the columns of a window.
            #[inline(never)]
            fn look<W: SceneAccess>(
                &mut self,
                world: &'a W,
                rects: &Rects<R>,
                y: u16,
                columns: (u32, u32),
            ) {
                let (parts, eye) = (world.parts(), self.eye);
                let mut until = Some(u32::MAX);
                $(
                    if W::NEEDS.$list {
                        let shapes = parts.$list;
                        let rects = used(rects.$list.as_ref(), shapes.len());
                        let own = self.$list.advance((shapes, rects), y, columns, eye);
                        until = earlier(until, own);
                    }
                )*
                match until {
                    Some(until) => (self.is_full, self.until) = (false, until),
                    None => {
                        // All anew for the next columns: the lists must not depend on where a row began.
                        self.restart(eye, false);
                        (self.is_full, self.until) = (true, columns.0 + 1);
                    }
                }
            }

            #[inline(never)]
            fn nearest_of_active<W: SceneAccess>(
                &self,
                world: &W,
                column: u32,
                (direction, start): (&Direction, Length),
                signature: &mut PathSignature,
            ) -> Hit {
                let mut nearest = Nearest::beyond(start);
                let lengths = world.parts().lengths();
                let (kind, first) = (0, 0);
                $(
                    if W::NEEDS.$list {
                        self.$list.ask((column, direction), first, &mut nearest);
                    }
                    let (kind, first) = (kind + 1, first + lengths[kind]);
                )*
                let _ = (kind, first);
                nearest.hit(signature)
            }
        }
    };
}
kinds!(active_lists);

impl<'a, R: ActiveRoom> ActiveLists<'a, R> {
    /// Advances to a window, whose first column is not before the last one's.
    #[inline(always)]
    pub(super) fn advance<W: SceneAccess>(
        &mut self,
        world: &'a W,
        rects: &Rects<R>,
        y: u16,
        window: &Window,
    ) {
        if window.first >= self.until {
            self.look(world, rects, y, (window.first, window.last));
        }
    }

    /// How far along a ray its start lies from the eye; a few steps off, and below zero by as many where
    /// both are one.
    #[inline(always)]
    pub(super) fn distance(&self, ray: &Ray) -> Length {
        Length::from_bits(self.eye.to(ray.origin).dot(ray.direction))
    }

    /// The nearest shape further than `start` along a ray of the column; the distance is from there.
    /// Notes on which side of thin shapes the ray passes.
    #[inline(always)]
    pub(super) fn nearest<W: SceneAccess>(
        &self,
        world: &W,
        column: u32,
        (direction, start): (&Direction, Length),
        signature: &mut PathSignature,
    ) -> Hit {
        if self.is_full {
            return self.nearest_of_all(world, column, (direction, start), signature);
        }
        self.nearest_of_active(world, column, (direction, start), signature)
    }

    #[cold]
    #[inline(never)]
    fn nearest_of_all<W: SceneAccess>(
        &self,
        world: &W,
        column: u32,
        (direction, start): (&Direction, Length),
        signature: &mut PathSignature,
    ) -> Hit {
        // It is not known what is thin: no other ray has been alike.
        signature.note(column);
        let ray = Ray {
            origin: self.eye,
            direction: *direction,
        };
        nearest_of(
            world,
            ShapeSet::ALL,
            (&ray, start),
            ShapeId::NONE,
            signature,
        )
    }
}

/// The earlier of two columns, if both are known.
#[inline(always)]
fn earlier(one: Option<u32>, other: Option<u32>) -> Option<u32> {
    Some(one?.min(other?))
}
