//! The trait of all scenes that frames can be drawn of: constant scenes, scenes in RAM, limited ones.

use super::within::{Limited, Whole, Within};
use super::{ActiveRoom, Apart, MovingScene, Scene, Static, Tabled, World};
use crate::scene::NeedsLimit;

/// A scene that frames can be drawn of. The crate implements it for every scene.
pub trait Drawable: Sized {
    /// Room of the scene: the capacities of its lists.
    type Room: ActiveRoom;

    /// Type through which the kernels read the scene.
    type World<'a>: World<Room = Self::Room> + Copy
    where
        Self: 'a;

    /// Whether the scene can change while the program runs.
    const CHANGES: bool;

    /// Returns the access through which the kernels read the scene.
    fn world(&self) -> Self::World<'_>;

    /// Returns a number that changes when the scene changes. A frame compares it to refuse a changed
    /// scene.
    fn stamp(&self) -> u32;
}

impl<T: Apart> Drawable for T {
    type Room = T::Room;
    type World<'a> = Static<T>;
    const CHANGES: bool = false;

    #[inline(always)]
    fn world(&self) -> Static<T> {
        Static::new()
    }

    #[inline(always)]
    fn stamp(&self) -> u32 {
        0
    }
}

/// Implements [`Drawable`] for a scene that the kernels read through a reference.
macro_rules! drawn_in_place {
    ([$($parameters:tt)*] $scene:ty, $room:ty, |$it:ident| $stamp:expr) => {
        impl<$($parameters)*> Drawable for $scene {
            type Room = $room;
            type World<'w>
                = &'w Self
            where
                Self: 'w;
            const CHANGES: bool = true;

            #[inline(always)]
            fn world(&self) -> &Self {
                self
            }

            fn stamp(&self) -> u32 {
                let $it = self;
                $stamp
            }
        }
    };
}
drawn_in_place!([R: ActiveRoom] Scene<R>, R, |scene| scene.stamp);
drawn_in_place!(['a, R: ActiveRoom] Tabled<'a, R>, R, |tabled| tabled.scene.stamp);
drawn_in_place!([T: Apart] MovingScene<T>, T::Room, |moving| moving.stamp());

impl<S: Drawable, L: NeedsLimit> Drawable for Limited<'_, S, L> {
    type Room = S::Room;
    type World<'w>
        = Within<S::World<'w>, L>
    where
        Self: 'w;
    const CHANGES: bool = S::CHANGES;

    #[inline(always)]
    fn world(&self) -> Self::World<'_> {
        Within::new(self.scene().world())
    }

    fn stamp(&self) -> u32 {
        self.scene().stamp()
    }
}

impl<S: Drawable> Drawable for Everything<'_, S> {
    type Room = S::Room;
    type World<'w>
        = Whole<S::World<'w>>
    where
        Self: 'w;
    const CHANGES: bool = S::CHANGES;

    #[inline(always)]
    fn world(&self) -> Self::World<'_> {
        Whole(self.0.world())
    }

    fn stamp(&self) -> u32 {
        self.0.stamp()
    }
}

/// A scene for which all code of the library is linked. Measurements use it to show what needs save.
#[derive(Clone, Copy, Debug)]
pub struct Everything<'a, S>(pub &'a S);
