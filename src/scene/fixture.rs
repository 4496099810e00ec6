//! What the tests of the scene need: scenes filled at run time, without what makes them fast.

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
            /// The scene as the plain path reads it.
            pub(crate) fn plain(&self) -> Result<PlainScene<Room<$($arguments)*>>, Error> {
                PlainScene::prepare(&self.description())
            }
        }
    };
}
kinds!(plain);

impl<R: Capacity> SceneAccess for PlainScene<R> {
    const NEEDS: Needs = Needs::of_room(&R::COUNTS);
    const CHOOSES_HITS: bool = false;

    fn parts(&self) -> Parts<'_> {
        PlainScene::parts(self)
    }
}
