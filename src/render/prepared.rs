//! Floor 7: a frame made ready for one size of picture, and its rows. Knows no display.

use core::marker::PhantomData;

use super::{Colors, Report};
use crate::accel::CullingQuality;
use crate::accel::drawable::Drawable;
use crate::accel::light_visibility::LightVisibility;
use crate::accel::screen_bounds::ScreenBounds;
use crate::accel::screen_culling::ScreenCulling;
use crate::camera::{Camera, RayGenerator};
use crate::color::Sum;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::ray::ScaledPoint;
use crate::render::{Fast, Quality};
use crate::scene::access::SceneAccess;
use crate::shade::{BlinnPhong, Shading};
use crate::trace::{Traced, Tracer};

/// A frame made ready for one size of picture: what the camera sees of a scene, without the scene.
///
/// It owns its data and borrows nothing, so it can be stored in a struct beside its scene, sent to another
/// thread or core, and shared. [`on`](PreparedFrame::on) joins it with the scene again, and refuses a
/// scene that has changed.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use reflet::{Camera, Error, ErrorKind, Material, PreparedFrame, RuntimeScene, Scene, room};
///
/// type Pond = Scene<room!(spheres: 1, lights: 1)>;
///
/// struct App {
///     scene: Pond,
///     frame: PreparedFrame<Pond>,
/// }
///
/// let mut scene = RuntimeScene::new();
/// scene.set_motion([-2, -2, -2], [2, 2, 2])?;
/// let chalk = scene.add_material(Material::new([0.9; 3]))?;
/// let ball = scene.add_sphere([0, 0, 0], 1, chalk)?;
/// scene.add_light([3, -4, 6], [1, 1, 1])?;
/// let scene: Pond = scene.build()?;
///
/// let camera = Camera::new([0, -5, 0], [0, 0, 0], [0, 0, 1], 50)?;
/// let frame = scene.frame(&camera).prepare(Size::new(32, 32));
/// let mut app = App { scene, frame };
///
/// let mut row = [Rgb888::BLACK; 32];
/// app.frame.on(&app.scene)?.row(16, 0, &mut row);
/// assert!(row[16].r() > 0);
///
/// app.scene.set_sphere(ball, [1, 0, 0], 1)?;
/// assert_eq!(app.frame.on(&app.scene).err().unwrap().kind(), ErrorKind::Changed);
/// # Ok::<(), Error>(())
/// ```
pub struct PreparedFrame<S: Drawable, Q = Fast, K = BlinnPhong> {
    /// The rays; `None` where there is nothing to be hit.
    generator: Option<RayGenerator>,
    lights: LightVisibility,
    /// `None` where the camera is far away or flash is scarce.
    bounds: Option<ScreenBounds<S::Room>>,
    width: u32,
    height: u32,
    reflections: u8,
    /// Of the scene that the frame was prepared for.
    stamp: u32,
    kinds: PhantomData<Kinds<S, Q, K>>,
}

/// Scene, quality and shading of a frame. It makes the frame `Send` and `Sync`, whatever they are.
type Kinds<S, Q, K> = fn() -> (S, Q, K);

impl<S: Drawable, Q, K> Clone for PreparedFrame<S, Q, K> {
    fn clone(&self) -> Self {
        Self { ..*self }
    }
}

impl<S: Drawable, Q: Quality, K: Shading> PreparedFrame<S, Q, K> {
    /// Columns and rows are each taken as 1 to 65535.
    #[inline(always)]
    pub(super) fn new(scene: &S, camera: &Camera, sides: [u32; 2], reflections: u8) -> Self {
        let [width, height] = sides.map(|side| side.clamp(1, 65_535));
        let world = &scene.world();
        let mut frame = Self {
            generator: None,
            lights: LightVisibility::unclear(ScaledPoint::ORIGIN),
            bounds: None,
            width,
            height,
            reflections,
            stamp: scene.stamp(),
            kinds: PhantomData,
        };
        if world.parts().is_empty() {
            return frame;
        }
        let position = camera.description().position;
        let from = world.parts().grid.place(position);
        let generator = camera.generator(width, height);
        frame.lights = match Q::CULLING.light_occluders {
            true => LightVisibility::new(world, from),
            false => LightVisibility::unclear(from),
        };
        if Q::CULLING.screen_bounds && from.is_near() {
            let bounds = frame.bounds.insert(ScreenBounds::empty());
            bounds.look(world, &camera.screen_axes(&generator, from.point));
        }
        frame.generator = Some(generator);
        frame
    }

    /// Joins the frame with its scene: then its rows can be drawn.
    ///
    /// # Errors
    /// [`ErrorKind::Changed`](crate::ErrorKind::Changed) if the scene has changed since the frame was
    /// prepared, or is another one.
    #[inline(always)]
    pub fn on<'a>(&'a self, scene: &'a S) -> Result<Rows<'a, S, Q, K>, Error> {
        match S::CHANGES && scene.stamp() != self.stamp {
            true => Err(Error::of("scene", ErrorKind::Changed)),
            false => Ok(self.unchanged(scene)),
        }
    }

    /// Joins the frame with the scene that it was just prepared for.
    #[inline(always)]
    pub(crate) fn unchanged<'a>(&'a self, scene: &'a S) -> Rows<'a, S, Q, K> {
        Rows {
            world: scene.world(),
            frame: self,
        }
    }
}

impl<S: Drawable, Q, K> PreparedFrame<S, Q, K> {
    /// Returns columns and rows: 1 to 65535.
    #[inline(always)]
    pub(crate) fn sides(&self) -> [u32; 2] {
        [self.width, self.height]
    }
}

/// A prepared frame and its scene: the rows of a picture.
///
/// Nothing in it changes, so rows can be drawn in any order, interrupted, or shared between cores.
/// [`PreparedFrame::on`] makes it, and shows it in an example.
pub struct Rows<'a, S: Drawable, Q = Fast, K = BlinnPhong> {
    world: S::World<'a>,
    frame: &'a PreparedFrame<S, Q, K>,
}

impl<S: Drawable, Q, K> Clone for Rows<'_, S, Q, K> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Drawable, Q, K> Copy for Rows<'_, S, Q, K> {}

impl<'a, S: Drawable, Q, K> Rows<'a, S, Q, K> {
    /// Returns columns and rows: 1 to 65535.
    #[inline(always)]
    pub(crate) fn sides(&self) -> [u32; 2] {
        self.frame.sides()
    }

    /// Returns the scene as the kernels read it.
    pub(crate) fn world(&self) -> &S::World<'a> {
        &self.world
    }
}

impl<'a, S: Drawable, Q: Quality, K: Shading> Rows<'a, S, Q, K> {
    /// Fills `pixels` with row `y` from column `x` on, each `shown` from the sum of its path. What would
    /// lie beyond the picture's edges stays as it is.
    #[inline(always)]
    pub(crate) fn fill_row<C: Copy>(
        &self,
        y: u32,
        x: u32,
        pixels: &mut [C],
        shown: impl Fn(Sum) -> C,
    ) -> Report {
        if y >= self.frame.height || x >= self.frame.width || pixels.is_empty() {
            return Report::NONE;
        }
        let inside = pixels.len().min((self.frame.width - x) as usize);
        let (pixels, _) = pixels.split_at_mut(inside);
        let Some(generator) = self.generator() else {
            fill(pixels, shown(self.only_sum()));
            return Report {
                rays: inside as u64,
                ..Report::NONE
            };
        };
        self.fill(generator, [x, y], pixels, shown)
    }

    /// Fills pixels inside of the picture; what follows their rays is on the stack only meanwhile.
    #[inline(never)]
    fn fill<C: Copy>(
        &self,
        generator: &RayGenerator,
        start: [u32; 2],
        pixels: &mut [C],
        shown: impl Fn(Sum) -> C,
    ) -> Report {
        let (_, report) = self.in_row(generator, start, |colors| colors.fill(pixels, shown));
        report
    }

    /// Hands `draw` the colours of a row from `[x, y]` on, which lies in the picture.
    #[inline(always)]
    pub(crate) fn in_row<T>(
        &self,
        generator: &RayGenerator,
        [x, y]: [u32; 2],
        draw: impl FnOnce(&mut Colors<'_, '_, S::World<'a>, K, Q>) -> T,
    ) -> (T, Report) {
        let mut tracer = self.tracer(y);
        let mut colors = Colors::new(&mut tracer, generator.row(y), x, self.frame.width);
        let drawn = draw(&mut colors);
        (drawn, Report::of(&tracer))
    }

    /// The rays, unless there is nothing to be met.
    #[inline(always)]
    pub(crate) fn generator(&self) -> Option<&'a RayGenerator> {
        match S::World::<'a>::NEEDS.is_nothing() {
            true => None,
            false => self.frame.generator.as_ref(),
        }
    }

    /// The sum of every pixel, where there is nothing to be met.
    pub(crate) fn only_sum(&self) -> Sum {
        Traced::missed::<_, K>(&self.world).sum
    }

    /// What follows the rays of row `y`.
    #[inline(always)]
    fn tracer(&self, y: u32) -> Tracer<'_, S::World<'a>, K, Q> {
        let (bounds, from) = (self.frame.bounds.as_ref(), self.frame.lights.from);
        let culling = match Tracer::<S::World<'a>, K, Q>::IS_PLAIN {
            true => ScreenCulling::new::<false>(bounds, from, y, true),
            false => ScreenCulling::new::<true>(bounds, from, y, !Q::CULLING.screen_bounds),
        };
        Tracer::new(
            &self.world,
            &self.frame.lights,
            culling,
            self.frame.reflections,
        )
    }
}

/// Fills pixels with one colour; out of line, or its caller's loops are unrolled around a constant.
#[inline(never)]
fn fill<C: Copy>(pixels: &mut [C], color: C) {
    pixels.fill(color);
}
