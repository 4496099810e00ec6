//! The active lists of all kinds of bounded shapes, for rays from one eye: the camera, or its image in
//! a plane.

use heapless::Vec;

use super::Scene;
use super::active_list::{ActiveList, ActiveShape, Storage, Window};
use super::screen_bounds::Rects;
use crate::error::Error;
use crate::number::Length;
use crate::ray::{Ray, RowPlane};
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::nearest::{Hit, Nearest, nearest_of};
use crate::scene::{Capacity, Description, Room, used};
use crate::vector::{Direction, Point};

/// Which bounded shapes the rays through the present columns test.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Tested {
    /// Those of the lists.
    Listed,
    /// None: the lists are empty.
    None,
    /// All: a list had no room.
    All,
}

macro_rules! active_lists {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident
            [$active_list:ident $active:tt] $($more:tt)* })*
    ) => {
        /// The capacity of a scene, with the memory for the active lists of each kind of shape.
        pub trait ActiveRoom: Capacity {
            /// Prepares a description whose parts have been checked and fit the room.
            fn prepare(description: &Description<'_>) -> Result<Scene<Self>, Error>;

            $(
                #[doc = concat!("Memory for the active list of ", stringify!($list), ".")]
                type $active_list<'a>: Storage<ActiveShape<'a, crate::shape::$prepared>>;
            )*
        }

        impl<$($header)*> ActiveRoom for Room<$($arguments)*> {
            fn prepare(description: &Description<'_>) -> Result<Scene<Self>, Error> {
                Scene::of_description(description)
            }

            $(
                type $active_list<'a> = Vec<ActiveShape<'a, crate::shape::$prepared>, $active>;
            )*
        }

        /// The active lists of a row: all bounded shapes that rays through the row's present columns
        /// can hit.
        ///
        /// If a list has no room for all of them, every ray tests every shape.
        #[derive(Debug)]
        pub(super) struct ActiveLists<'a, R: ActiveRoom> {
            /// Origin of the rays.
            pub(super) eye: Point,
            /// Plane of the row's rays.
            pub(super) row: RowPlane,
            /// The lists stay valid for windows whose first column is below this one.
            until: u32,
            $(pub(super) $list: ActiveList<'a, crate::shape::$prepared, R::$active_list<'a>>,)*
            pub(super) tested: Tested,
        }

        impl<'a, R: ActiveRoom> ActiveLists<'a, R> {
            /// Returns empty lists. If `is_full`, the rays of all columns test every shape. If the
            /// lists are never read, `USED` is false.
            #[inline(always)]
            pub(super) fn new<const USED: bool>((eye, row): (Point, RowPlane), is_full: bool) -> Self {
                Self {
                    eye,
                    row,
                    until: if is_full { u32::MAX } else { 0 },
                    $($list: ActiveList::new::<USED>(),)*
                    tested: if is_full { Tested::All } else { Tested::None },
                }
            }

            /// Empties the lists and goes back to the row's first column, for rays from another eye.
            pub(super) fn restart(&mut self, (eye, row): (Point, RowPlane), is_full: bool) {
                (self.eye, self.row) = (eye, row);
                self.tested = if is_full { Tested::All } else { Tested::None };
                self.until = if is_full { u32::MAX } else { 0 };
                $(self.$list.restart();)*
            }

            /// Returns the column before which no ray of the row hits a bounded shape, from the
            /// window's first column on. Returns `None` if a ray of the window may hit one.
            pub(super) fn clear_until<W: SceneAccess>(&self, window: &Window) -> Option<u32> {
                let mut first = u32::MAX;
                $(
                    if W::NEEDS.$list {
                        first = first.min(self.$list.first_column(window));
                    }
                )*
                (self.tested != Tested::All && first > window.last).then_some(first.min(self.until))
            }

            /// Advances the lists of all kinds to the columns of a window.
            #[inline(never)]
            fn look<W: SceneAccess>(
                &mut self,
                world: &'a W,
                rects: &Rects<R>,
                y: u16,
                columns: (u32, u32),
            ) {
                let (parts, eye, row) = (world.parts(), self.eye, self.row);
                let (mut until, mut is_empty) = (Some(u32::MAX), true);
                $(
                    if W::NEEDS.$list {
                        let shapes = parts.$list;
                        let rects = used(rects.$list.as_ref(), shapes.len());
                        let own = self.$list.advance((shapes, rects), y, columns, (eye, &row));
                        until = earlier(until, own);
                        is_empty &= self.$list.is_empty();
                    }
                )*
                match until {
                    Some(until) => {
                        self.tested = if is_empty { Tested::None } else { Tested::Listed };
                        self.until = until;
                    }
                    None => {
                        // Rebuild the lists for the next columns: they must not depend on where a row
                        // began.
                        self.restart((eye, self.row), false);
                        (self.tested, self.until) = (Tested::All, columns.0 + 1);
                    }
                }
            }

            /// Returns the nearest hit of a ray among the active shapes, beyond `start`. The distance
            /// counts from there.
            #[inline(never)]
            fn nearest_of_active<W: SceneAccess>(
                &self,
                world: &W,
                column: u32,
                (direction, start): (&Direction, Length),
            ) -> Hit {
                let mut nearest = Nearest::beyond(start);
                let [$($list),*] = world.parts().kinds();
                $(
                    if W::NEEDS.$list {
                        self.$list.ask((column, direction), $list, &mut nearest);
                    }
                )*
                nearest.hit()
            }
        }
    };
}
kinds!(active_lists);

impl<'a, R: ActiveRoom> ActiveLists<'a, R> {
    /// Advances the lists to a window if necessary. The window's first column never decreases.
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

    /// Returns the distance from the eye to the start of a ray, measured along the ray. It is off by a
    /// few steps, so it may be slightly negative where both points are the same.
    #[inline(always)]
    pub(super) fn distance(&self, ray: &Ray) -> Length {
        Length::from_bits(self.eye.to(ray.origin).dot(ray.direction))
    }

    /// Returns the nearest hit of a ray among the bounded shapes, beyond `start`. The distance counts
    /// from there.
    ///
    /// The ray starts at the eye and goes through a column of the latest window.
    #[inline(always)]
    pub(super) fn nearest<W: SceneAccess>(
        &self,
        world: &W,
        column: u32,
        (direction, start): (&Direction, Length),
    ) -> Hit {
        match self.tested {
            Tested::Listed => self.nearest_of_active(world, column, (direction, start)),
            Tested::None => Hit::NONE,
            Tested::All => self.nearest_of_all(world, (direction, start)),
        }
    }

    /// Returns the nearest hit of a ray among all bounded shapes. Used when a list had no room.
    #[cold]
    #[inline(never)]
    fn nearest_of_all<W: SceneAccess>(
        &self,
        world: &W,
        (direction, start): (&Direction, Length),
    ) -> Hit {
        let ray = Ray {
            origin: self.eye,
            direction: *direction,
        };
        nearest_of(world, (&ray, start), ShapeId::NONE)
    }
}

/// Returns the smaller of two columns, `None` if one of them is.
#[inline(always)]
fn earlier(one: Option<u32>, other: Option<u32>) -> Option<u32> {
    Some(one?.min(other?))
}
