//! Floor 7: the settings of a frame: its camera, reflections, quality and shading.

use core::marker::PhantomData;

use super::PreparedFrame;
use crate::accel::any_scene::AnyScene;
use crate::accel::screen_axis::Columns;
use crate::accel::thin::is_shown_thin;
use crate::accel::{ActiveRoom, Apart, BoundedShape, Limited, MovingScene, Scene, Tabled, Touched};
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::number::signed;
use crate::qualities::{Fast, Quality};
use crate::scene::access::SceneAccess;
use crate::scene::{Handle, NeedsLimit};
use crate::shade::{BlinnPhong, Shading};

/// The settings of a frame: a scene, a camera, a number of reflections, a quality `Q` and a shading `K`.
///
/// The function `frame` of a scene creates it. [`draw`](FrameBuilder::draw) draws the frame at once.
/// [`prepare`](FrameBuilder::prepare) prepares it, so that its rows can be drawn one by one.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
/// use reflet::quality::Exact;
/// use reflet::scenes::{BuiltIn, Mirror1};
/// use reflet::shading::Phong;
///
/// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
/// Mirror1::frame(&Mirror1::CAMERA)
///     .reflections(2)
///     .quality::<Exact>()
///     .shading::<Phong>()
///     .draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Debug)]
pub struct FrameBuilder<'a, S, Q = Fast, K = BlinnPhong> {
    scene: &'a S,
    camera: &'a Camera,
    reflections: u8,
    kinds: PhantomData<fn() -> (Q, K)>,
}

/// Default number of reflections of a path.
const REFLECTIONS: u8 = 4;

impl<'a, S: AnyScene> FrameBuilder<'a, S> {
    /// Creates a frame of a scene with 4 reflections, quality [`Fast`] and shading [`BlinnPhong`].
    ///
    /// The function `frame` of a scene does the same in fewer words:
    ///
    /// ```
    /// use embedded_graphics::prelude::Size;
    /// use reflet::FrameBuilder;
    /// use reflet::scenes::{BuiltIn, Floor};
    ///
    /// let frame = FrameBuilder::new(&Floor, &Floor::CAMERA);
    /// assert_eq!(frame.prepare(Size::new(32, 24)).size(), Size::new(32, 24));
    /// ```
    pub const fn new(scene: &'a S, camera: &'a Camera) -> Self {
        Self {
            scene,
            camera,
            reflections: REFLECTIONS,
            kinds: PhantomData,
        }
    }
}

impl<'a, S: AnyScene, Q: Quality, K: Shading> FrameBuilder<'a, S, Q, K> {
    /// Sets the largest number of reflections of a path, 0 to 255. Defaults to 4.
    ///
    /// [`MostReflections`](crate::needs::MostReflections) sets a limit when the program is compiled.
    #[must_use]
    pub fn reflections(self, reflections: u8) -> Self {
        Self {
            reflections,
            ..self
        }
    }

    /// Sets the quality: [`Fast`] (the default), [`Exact`](crate::quality::Exact),
    /// [`Small`](crate::quality::Small), which takes the least flash, or a type of your own.
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

    /// Returns the scene that the frame shows.
    pub(crate) fn scene(&self) -> &'a S {
        self.scene
    }

    /// Calls `found` with the columns and rows of each part of a picture that may depend on a shape. Returns `false` if that may
    /// be the whole picture.
    ///
    /// # Errors
    /// [`ErrorKind::UnknownHandle`] if the scene has no such shape.
    #[inline(never)]
    pub(crate) fn touched<T: BoundedShape>(
        &self,
        shape: Handle<T>,
        [width, height]: [u32; 2],
        mut found: impl FnMut([Columns; 2]),
    ) -> Result<bool, Error> {
        let world = &self.scene.world();
        let (parts, index) = (world.parts(), shape.index());
        let unknown = Error::at(T::KIND, index, ErrorKind::UnknownHandle);
        let shape = parts.shape_of::<T>(index).ok_or(unknown)?;
        let from = parts.grid.place(self.camera.description().position);
        if !from.is_near() {
            return Ok(false);
        }
        let generator = self.camera.generator(width, height);
        if Q::SMOOTHNESS > 1 {
            // A thin shape divides whole rows, even if it lies beside the picture.
            for y in 0..height {
                let plane = generator.row_plane_below((y, 0), from.point);
                if is_shown_thin(&parts, shape, &plane, width) {
                    let row = Columns::at(signed(y));
                    found([Columns::ALL, row]);
                }
            }
        }
        let axes = self.camera.screen_axes(&generator, from.point);
        let bounces = if K::REFLECTS { self.reflections.into() } else { 0 };
        Ok(Touched::find(
            world,
            &axes,
            shape,
            (bounces, K::SHADOWS),
            found,
        ))
    }

    /// Prepares the frame for a picture of `width` columns and `height` rows, each clamped to 1 to
    /// 65535.
    // Not inlined, so that its stack is free again before a row is drawn.
    #[inline(never)]
    pub(crate) fn prepared(&self, width: u32, height: u32) -> PreparedFrame<S, Q, K> {
        PreparedFrame::new(self.scene, self.camera, [width, height], self.reflections)
    }
}

/// Writes the function `frame` of a type of scenes.
macro_rules! framed {
    ([$($parameters:tt)*] $scene:ty) => {
        impl<$($parameters)*> $scene {
            /// Views the scene through a camera, with 4 reflections, quality [`Fast`] and shading
            /// [`BlinnPhong`].
            pub const fn frame<'f>(&'f self, camera: &'f Camera) -> FrameBuilder<'f, Self> {
                FrameBuilder::new(self, camera)
            }
        }
    };
}
framed!([R: ActiveRoom] Scene<R>);
framed!(['a, R: ActiveRoom] Tabled<'a, R>);
framed!([T: Apart] MovingScene<T>);
framed!(['a, S: AnyScene, L: NeedsLimit] Limited<'a, S, L>);
