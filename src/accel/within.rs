//! A scene of which less is linked, or more, than its type says.

use core::marker::PhantomData;

use super::{Tables, World};
use crate::scene::access::{SceneAccess, if_needed};
use crate::scene::{Bound, Needs, Parts};

/// A scene of which no more is needed than `B` says; see [`crate::Scene::frame_within`].
pub struct Within<W, B> {
    world: W,
    bound: PhantomData<B>,
}

impl<W, B> Within<W, B> {
    /// The caller knows it.
    pub(crate) const fn new(world: W) -> Self {
        Self {
            world,
            bound: PhantomData,
        }
    }
}

impl<W: Clone, B> Clone for Within<W, B> {
    fn clone(&self) -> Self {
        Self::new(self.world.clone())
    }
}

impl<W: Copy, B> Copy for Within<W, B> {}

impl<W: SceneAccess, B: Bound> SceneAccess for Within<W, B> {
    const NEEDS: Needs = W::NEEDS.both(&B::NEEDS);
    const CHOOSES_HITS: bool = W::CHOOSES_HITS;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.world.parts().within(&B::NEEDS)
    }
}

/// A scene with everything linked that any scene needs; see [`crate::Frame::whole`].
#[derive(Clone, Copy, Debug)]
pub struct Whole<W>(pub(crate) W);

impl<W: SceneAccess> SceneAccess for Whole<W> {
    const NEEDS: Needs = Needs::ALL;
    const CHOOSES_HITS: bool = W::CHOOSES_HITS;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        self.0.parts()
    }
}

impl<W: World, B: Bound> World for Within<W, B> {
    type Room = W::Room;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, W::Room> {
        let tables = self.world.tables();
        Tables {
            light_occluders: if_needed(B::NEEDS.lights, tables.light_occluders),
            ..tables
        }
    }
}

impl<W: World> World for Whole<W> {
    type Room = W::Room;

    #[inline(always)]
    fn tables(&self) -> Tables<'_, W::Room> {
        self.0.tables()
    }
}
