//! A scene in RAM of which one shape moves, as something to be measured.

use core::hint::black_box;
use core::marker::PhantomData;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use reflet::__private::Apart;
use reflet::quality::Quality;
use reflet::shading::Shading;
use reflet::{Error, MovingScene, PreparedFrame};

use crate::contestant::{Contestant, View, counted};
use crate::{Clock, report};

/// A constant scene with a shape that moves.
pub trait Moves: Apart {
    /// Moves the shape to the place where it already is, so that the picture stays the same.
    fn move_shape(scene: &mut MovingScene<Self>) -> Result<(), Error>;
}

/// The library, with scene `S` in RAM, view `V`, quality `Q`, shading `K` and at most `N` reflections.
pub struct Moving<S, V, Q, K, const N: u8>(PhantomData<(S, V, Q, K)>);

impl<S: Moves, V: View, Q: Quality, K: Shading, const N: u8> Contestant for Moving<S, V, Q, K, N> {
    type Scene = MovingScene<S>;
    type Picture = PreparedFrame<MovingScene<S>, Q, K>;

    fn scene() -> Self::Scene {
        MovingScene::new()
    }

    fn moved(clock: &Clock, scene: &mut Self::Scene) -> Option<u32> {
        let start = clock.now();
        let moved = S::move_shape(scene);
        let instructions = clock.since(start);
        match moved {
            Ok(()) => Some(instructions),
            Err(_) => report::stop("the move"),
        }
    }

    counted!();
}
