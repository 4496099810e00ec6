//! Floor 7: which frame of a scene is drawn: its camera, reflections, quality and shading.

use core::marker::PhantomData;

use super::PreparedFrame;
use crate::accel::drawable::{Drawable, Everything};
use crate::accel::{ActiveRoom, Apart, Limited, MovingScene, Scene, Tabled};
use crate::camera::Camera;
use crate::render::{Fast, Quality};
use crate::scene::NeedsLimit;
use crate::shade::{BlinnPhong, Shading};

/// A view of a scene that is still to be drawn: the camera, the reflections, the quality `Q` and the
/// shading `K`.
///
/// The function `frame` of a scene makes one. [`draw`](FrameBuilder::draw) draws it at once.
/// [`prepare`](FrameBuilder::prepare) makes it ready for rows that are drawn one by one.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
/// use reflet::quality::Fine;
/// use reflet::scenes::{BuiltIn, Mirror1};
/// use reflet::shading::Phong;
///
/// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
/// Mirror1::frame(&Mirror1::CAMERA)
///     .reflections(2)
///     .quality::<Fine>()
///     .shading::<Phong>()
///     .draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
pub struct FrameBuilder<'a, S, Q = Fast, K = BlinnPhong> {
    scene: &'a S,
    camera: &'a Camera,
    reflections: u8,
    kinds: PhantomData<fn() -> (Q, K)>,
}

/// Reflections of a frame that names no other number.
const REFLECTIONS: u8 = 4;

impl<'a, S: Drawable> FrameBuilder<'a, S> {
    /// Views a scene through a camera: 4 reflections, quality [`Fast`], shading [`BlinnPhong`].
    pub const fn new(scene: &'a S, camera: &'a Camera) -> Self {
        Self {
            scene,
            camera,
            reflections: REFLECTIONS,
            kinds: PhantomData,
        }
    }
}

impl<'a, S: Drawable, Q: Quality, K: Shading> FrameBuilder<'a, S, Q, K> {
    /// Limits a path to this many reflections. Defaults to 4.
    ///
    /// [`MostReflections`](crate::needs::MostReflections) limits them when the program is compiled.
    #[must_use]
    pub fn reflections(self, reflections: u8) -> Self {
        Self {
            reflections,
            ..self
        }
    }

    /// Sets the quality: [`Fast`] (the default), [`Fine`](crate::quality::Fine),
    /// [`Exact`](crate::quality::Exact), or [`Small`](crate::quality::Small), which takes the least flash.
    #[must_use]
    pub fn quality<NewQ: Quality>(self) -> FrameBuilder<'a, S, NewQ, K> {
        self.with_kinds()
    }

    /// Sets the shading: [`BlinnPhong`] (the default), [`Phong`](crate::shading::Phong), or another of
    /// [`shading`](crate::shading).
    #[must_use]
    pub fn shading<NewK: Shading>(self) -> FrameBuilder<'a, S, Q, NewK> {
        self.with_kinds()
    }

    fn with_kinds<NewQ, NewK>(self) -> FrameBuilder<'a, S, NewQ, NewK> {
        let Self {
            scene,
            camera,
            reflections,
            ..
        } = self;
        FrameBuilder {
            scene,
            camera,
            reflections,
            kinds: PhantomData,
        }
    }

    /// Returns the scene.
    pub(crate) fn scene(&self) -> &'a S {
        self.scene
    }

    /// Makes the frame ready for a picture of so many columns and rows; each is taken as 1 to 65535.
    // What it needs besides is gone before a row is drawn.
    #[inline(never)]
    pub(crate) fn prepared(&self, width: u32, height: u32) -> PreparedFrame<S, Q, K> {
        PreparedFrame::new(self.scene, self.camera, [width, height], self.reflections)
    }
}

/// Gives a kind of scene the function that views it.
macro_rules! framed {
    ([$($parameters:tt)*] $scene:ty) => {
        impl<$($parameters)*> $scene {
            /// Views the scene through a camera: 4 reflections, quality [`Fast`], shading [`BlinnPhong`].
            pub const fn frame<'f>(&'f self, camera: &'f Camera) -> FrameBuilder<'f, Self> {
                FrameBuilder::new(self, camera)
            }
        }
    };
}
framed!([R: ActiveRoom] Scene<R>);
framed!(['a, R: ActiveRoom] Tabled<'a, R>);
framed!([T: Apart] MovingScene<T>);
framed!(['a, S: Drawable, L: NeedsLimit] Limited<'a, S, L>);
framed!(['a, S: Drawable] Everything<'a, S>);
