//! Floor 7: which frame of a scene is to be drawn: its camera, reflections, quality and shading.

use core::marker::PhantomData;

use super::Picture;
use crate::accel::{ActiveRoom, Apart, SceneIn, Static, Tabled, Whole, Within, World};
use crate::camera::Camera;
use crate::render::{Fast, Quality};
use crate::scene::{Bound, Excess, MostReflections};
use crate::shade::{BlinnPhong, Shading};

/// A view of a scene that is still to be drawn: which camera, how many reflections, how exact.
///
/// Made by [`StaticFrame::frame`] or [`Scene::frame`](crate::Scene::frame).
pub struct Frame<'a, W, Q = Fast, K = BlinnPhong> {
    world: W,
    camera: &'a Camera,
    reflections: u8,
    kinds: PhantomData<(Q, K)>,
}

/// Reflections unless a frame says otherwise.
const REFLECTIONS: u8 = 4;

impl<'a, W: World + Copy> Frame<'a, W> {
    const fn new(world: W, camera: &'a Camera) -> Self {
        Self {
            world,
            camera,
            reflections: REFLECTIONS,
            kinds: PhantomData,
        }
    }
}

impl<'a, W: World + Copy, Q: Quality, K: Shading> Frame<'a, W, Q, K> {
    /// At most this many reflections a path; 4 unless it is named.
    #[must_use]
    pub fn reflections(self, reflections: u8) -> Self {
        Self {
            reflections,
            ..self
        }
    }

    /// At most `N` reflections a path, known when the program is compiled: with 0, the code for
    /// mirrors is not linked.
    #[must_use]
    pub fn most_reflections<const N: u8>(self) -> Frame<'a, Within<W, MostReflections<N>>, Q, K> {
        Frame {
            world: Within::new(self.world),
            camera: self.camera,
            reflections: N,
            kinds: PhantomData,
        }
    }

    /// With everything linked that any scene needs, whether this one does or not: for measuring what
    /// leaving it out comes to.
    #[must_use]
    pub fn whole(self) -> Frame<'a, Whole<W>, Q, K> {
        Frame {
            world: Whole(self.world),
            camera: self.camera,
            reflections: self.reflections,
            kinds: PhantomData,
        }
    }

    /// As exact as [`Fast`] (the default), [`crate::Fine`] or [`crate::Exact`], or in as little flash
    /// as [`crate::Small`].
    #[must_use]
    pub fn quality<NewQ: Quality>(self) -> Frame<'a, W, NewQ, K> {
        self.with_kinds()
    }

    /// Shaded by [`BlinnPhong`] (the default), [`crate::Phong`] or [`crate::Normals`].
    #[must_use]
    pub fn shading<NewK: Shading>(self) -> Frame<'a, W, Q, NewK> {
        self.with_kinds()
    }

    fn with_kinds<NewQ, NewK>(self) -> Frame<'a, W, NewQ, NewK> {
        let Self {
            world,
            camera,
            reflections,
            ..
        } = self;
        Frame {
            world,
            camera,
            reflections,
            kinds: PhantomData,
        }
    }

    /// Makes the frame ready for a picture of so many columns and rows; each is taken as 1 to 65535.
    // What it needs besides is gone before a row is drawn.
    #[inline(never)]
    pub(crate) fn prepared(&self, width: u32, height: u32) -> Picture<W, Q, K> {
        Picture::new(self.world, self.camera, [width, height], self.reflections)
    }
}

impl<R: ActiveRoom> SceneIn<R> {
    /// A view of this scene through `camera`, with 4 reflections, [`Fast`], [`BlinnPhong`].
    pub const fn frame<'a>(&'a self, camera: &'a Camera) -> Frame<'a, &'a Self> {
        Frame::new(self, camera)
    }

    /// The same, but that nothing is linked that a scene within the bound `B` does not need.
    ///
    /// ```
    /// use embedded_graphics::mock_display::MockDisplay;
    /// use embedded_graphics::pixelcolor::Rgb888;
    /// use reflet::{Bound, Camera, Material, Needs, RuntimeScene};
    ///
    /// struct Matte;
    /// impl Bound for Matte {
    ///     const NEEDS: Needs = Needs::ALL.without_mirrors();
    /// }
    ///
    /// let mut scene = RuntimeScene::<1, 0, 0, 0, 1>::new();
    /// let glass = scene.add_material(Material::new([0.9; 3]).mirror(0.5))?;
    /// scene.add_sphere([0, 0, 0], 1, glass)?;
    /// let scene = scene.build()?;
    /// const CAMERA: Camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    /// // This one mirrors.
    /// assert_eq!(scene.frame_within::<Matte>(&CAMERA).err().unwrap().need, "mirrors");
    /// # Ok::<(), reflet::SceneError>(())
    /// ```
    ///
    /// # Errors
    /// What the scene needs beyond the bound.
    pub fn frame_within<'a, B: Bound>(
        &'a self,
        camera: &'a Camera,
    ) -> Result<Frame<'a, Within<&'a Self, B>>, Excess> {
        match self.needs().within(&B::NEEDS) {
            Ok(()) => Ok(Frame::new(Within::new(self), camera)),
            Err(excess) => Err(excess),
        }
    }
}

impl<R: ActiveRoom> Tabled<'_, R> {
    /// A view of the scene through `camera`, as [`Scene::frame`](crate::Scene::frame).
    pub const fn frame<'a>(&'a self, camera: &'a Camera) -> Frame<'a, &'a Self> {
        Frame::new(self, camera)
    }
}

/// Gives every [`crate::StaticScene`] its frames.
pub trait StaticFrame: Apart + Sized {
    /// A view of this scene through `camera`, with 4 reflections, [`Fast`], [`BlinnPhong`].
    fn frame(camera: &Camera) -> Frame<'_, Static<Self>> {
        Frame::new(Static::new(), camera)
    }
}

impl<T: Apart> StaticFrame for T {}
