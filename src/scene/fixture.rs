//! Helpers for tests of this floor: run-time scenes prepared without culling tables.

use super::access::SceneAccess;
use super::capacity::{Capacity, Room};
use super::{Needs, Parts, PlainScene, RuntimeScene};
use crate::error::Error;

macro_rules! plain {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $($more:tt)*
    ) => {
        impl<$($header)*> RuntimeScene<Room<$($arguments)*>> {
            /// Prepares the scene for the plain path, without culling tables.
            pub(crate) fn plain(&self) -> Result<PlainScene<Room<$($arguments)*>>, Error> {
                PlainScene::prepare(&self.description())
            }
        }
    };
}
kinds!(plain);

impl<R: Capacity> SceneAccess for PlainScene<R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS);

    fn parts(&self) -> Parts<'_> {
        PlainScene::parts(self)
    }
}
