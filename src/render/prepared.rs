//! Floor 7: frames prepared for one size of picture, and their rows. This file knows no display.

use core::marker::PhantomData;

use super::interpolate::fill;
use super::smooth::Line;
use super::{Colors, Report};
use crate::accel::any_scene::AnyScene;
use crate::accel::light_visibility::LightVisibility;
use crate::accel::row_list::row_list;
use crate::accel::screen_bounds::ScreenBounds;
use crate::accel::screen_culling::ScreenCulling;
use crate::camera::{Camera, RayGenerator, RowDirections};
use crate::color::Sum;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::qualities::{Fast, Quality};
use crate::ray::ScaledPoint;
use crate::scene::access::SceneAccess;
use crate::shade::{BlinnPhong, Shading};
use crate::trace::{Traced, Tracer};

/// A frame prepared for one size of picture: rays, screen bounds and visible lights, without the scene.
///
/// The frame owns its data. So it can be stored in a struct beside its scene, sent to another thread or core, and
/// shared. Only the frame of a [`Limited`](crate::needs::Limited) or a [`Tabled`](crate::needs::Tabled) scene borrows that scene.
/// [`on`](PreparedFrame::on) joins a frame with its scene again, and refuses a scene that has changed.
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
#[derive(Debug)]
pub struct PreparedFrame<S: AnyScene, Q = Fast, K = BlinnPhong> {
    /// Generator of the camera rays; `None` if the scene has no shape.
    generator: Option<RayGenerator>,
    lights: LightVisibility,
    /// Screen bounds of the shapes; `None` if the camera is far away or the quality is small.
    bounds: Option<ScreenBounds<S::Room>>,
    width: u32,
    height: u32,
    reflections: u8,
    /// Stamp of the scene at the time when the frame was prepared.
    stamp: u32,
    kinds: PhantomData<Kinds<S, Q, K>>,
}

/// Marker for a frame's types of scene, quality and shading. As a function type it is always `Send` and `Sync`.
type Kinds<S, Q, K> = fn() -> (S, Q, K);

impl<S: AnyScene, Q, K> Clone for PreparedFrame<S, Q, K> {
    fn clone(&self) -> Self {
        Self { ..*self }
    }
}

impl<S: AnyScene, Q: Quality, K: Shading> PreparedFrame<S, Q, K> {
    /// Prepares a frame for a picture of these columns and rows, each clamped to 1 to 65535.
    #[inline(always)]
    pub(super) fn new(scene: &S, camera: &Camera, sides: [u32; 2], reflections: u8) -> Self {
        // Smooth edges have a column of corners more than of pixels.
        let most = 65_535 - u32::from(Q::SMOOTHNESS > 1);
        let [width, height] = [sides[0].clamp(1, most), sides[1].clamp(1, most)];
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
        let generator = match Q::SMOOTHNESS {
            1 => camera.generator(width, height),
            _ => camera.corners(width, height),
        };
        frame.lights = if Q::CULLING.views {
            LightVisibility::new(world, from)
        } else {
            LightVisibility::unclear(from)
        };
        if Q::CULLING.views && from.is_near() {
            let bounds = frame.bounds.insert(ScreenBounds::empty());
            bounds.look(world, &camera.screen_axes(&generator, from.point));
        }
        frame.generator = Some(generator);
        frame
    }

    /// Joins the frame with its scene, so that its rows can be drawn.
    ///
    /// # Errors
    /// [`ErrorKind::Changed`](crate::ErrorKind::Changed) if the scene has changed since the frame was
    /// prepared, or is another scene.
    #[inline(always)]
    pub fn on<'a>(&'a self, scene: &'a S) -> Result<Rows<'a, S, Q, K>, Error> {
        if S::CHANGES && scene.stamp() != self.stamp {
            Err(Error::of("scene", ErrorKind::Changed))
        } else {
            Ok(self.unchanged(scene))
        }
    }

    /// Joins the frame with its scene, which is the one it was prepared for, without a check.
    #[inline(always)]
    pub(crate) fn unchanged<'a>(&'a self, scene: &'a S) -> Rows<'a, S, Q, K> {
        Rows {
            world: scene.world(),
            frame: self,
        }
    }
}

impl<S: AnyScene, Q, K> PreparedFrame<S, Q, K> {
    /// Returns the number of columns and of rows of the picture, each 1 to 65535.
    #[inline(always)]
    pub(crate) fn sides(&self) -> [u32; 2] {
        [self.width, self.height]
    }
}

/// The rows of a picture: a prepared frame joined with its scene. [`PreparedFrame::on`] creates it.
///
/// Drawing changes nothing in it. So rows can be drawn in any order, interrupted, or shared between cores.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888, prelude::*};
/// use embedded_graphics::primitives::Rectangle;
/// use reflet::quality::Fast;
/// use reflet::scenes::{BuiltIn, Floor};
/// use reflet::{Error, Rows};
///
/// let frame = Floor::frame(&Floor::CAMERA).prepare(Size::new(64, 48));
/// let rows: Rows<'_, Floor, Fast> = frame.on(&Floor)?;
/// let mut row = [Rgb888::BLACK; 64];
/// let report = rows.row(40, 0, &mut row);
/// assert!(report.rays > 0);
///
/// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
/// let lower_half = Rectangle::new(Point::new(0, 24), Size::new(64, 24));
/// rows.draw_area(lower_half, Point::new(0, 8), &mut display).unwrap();
/// assert_eq!(display.get_pixel(Point::new(5, 48)), Some(row[5]));
/// assert_eq!((rows.size(), display.get_pixel(Point::zero())), (Size::new(64, 48), None));
/// # Ok::<(), Error>(())
/// ```
#[derive(Debug)]
pub struct Rows<'a, S: AnyScene, Q = Fast, K = BlinnPhong> {
    world: S::World<'a>,
    frame: &'a PreparedFrame<S, Q, K>,
}

impl<S: AnyScene, Q, K> Clone for Rows<'_, S, Q, K> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: AnyScene, Q, K> Copy for Rows<'_, S, Q, K> {}

impl<'a, S: AnyScene, Q, K> Rows<'a, S, Q, K> {
    /// Returns the number of columns and of rows of the picture, each 1 to 65535.
    #[inline(always)]
    pub(crate) fn sides(&self) -> [u32; 2] {
        self.frame.sides()
    }

    /// Returns the access through which the kernels read the scene.
    pub(crate) fn world(&self) -> &S::World<'a> {
        &self.world
    }
}

impl<'a, S: AnyScene, Q: Quality, K: Shading> Rows<'a, S, Q, K> {
    /// Fills `pixels` with the colours of row `y` from column `x` on, each converted by `shown`. Pixels beyond the picture stay.
    #[inline(always)]
    pub(crate) fn fill_row<C: Copy>(
        &self,
        y: u32,
        x: u32,
        pixels: &mut [C],
        (seam, shown): (Option<&mut [Line]>, impl Fn(Sum) -> C),
    ) -> Report {
        if y >= self.frame.height || x >= self.frame.width || pixels.is_empty() {
            return Report::NONE;
        }
        let inside = pixels.len().min((self.frame.width - x) as usize);
        let (pixels, _) = pixels.split_at_mut(inside);
        if let Some(only) = self.only_sum() {
            fill(pixels, shown(only));
            let rays = inside as u64;
            return Report {
                rays,
                ..Report::NONE
            };
        }
        let Some(generator) = self.generator() else {
            return Report::NONE;
        };
        match Q::SMOOTHNESS {
            1 => self.fill(generator, [x, y], pixels, shown),
            _ => self.fill_smooth(generator, [x, y], pixels, (seam, shown)),
        }
    }

    /// Fills pixels inside of the picture. Not inlined, so that the tracer leaves the stack again.
    #[inline(never)]
    fn fill<C: Copy>(
        &self,
        generator: &RayGenerator,
        start: [u32; 2],
        pixels: &mut [C],
        shown: impl Fn(Sum) -> C,
    ) -> Report {
        self.in_row(generator, start, |colors| colors.fill(pixels, shown))
            .1
    }

    /// Calls `draw` with the colours of row `y` from column `x` on, inside of the picture. Returns its result with a report.
    #[inline(always)]
    pub(crate) fn in_row<T>(
        &self,
        generator: &RayGenerator,
        [x, y]: [u32; 2],
        draw: impl FnOnce(&mut Colors<'_, '_, S::World<'a>, K, Q>) -> T,
    ) -> (T, Report) {
        let directions = generator.row(y);
        let mut tracer = self.tracer((generator, &directions), y);
        let mut colors = Colors::new(&mut tracer, directions, x, self.frame.width);
        let drawn = draw(&mut colors);
        (drawn, Report::of(&tracer))
    }

    /// Returns the generator of the camera rays, unless all pixels have one colour ([`Rows::only_sum`]).
    #[inline(always)]
    pub(crate) fn generator(&self) -> Option<&'a RayGenerator> {
        self.frame.generator.as_ref()
    }

    /// Returns the sum of every pixel if the scene has no shape and no sky.
    #[inline(always)]
    pub(crate) fn only_sum(&self) -> Option<Sum> {
        let is_empty = S::World::<'a>::NEEDS.is_nothing() || self.world.parts().is_empty();
        is_empty.then(|| Traced::missed::<_, K>(&self.world).sum)
    }

    /// Returns the tracer for the rays of row `y`.
    #[inline(always)]
    pub(super) fn tracer(
        &self,
        (generator, directions): (&RayGenerator, &RowDirections),
        y: u32,
    ) -> Tracer<'_, S::World<'a>, K, Q> {
        let (bounds, from) = (self.frame.bounds.as_ref(), self.frame.lights.from);
        let from = (from, generator.row_plane(y, from.point));
        let culling = if Tracer::<S::World<'a>, K, Q>::IS_PLAIN {
            ScreenCulling::new::<false>(bounds, from, y, true)
        } else {
            ScreenCulling::new::<true>(bounds, from, y, !Q::CULLING.views)
        };
        Tracer::new(
            &self.world,
            &self.frame.lights,
            (culling, row_list::<_, Q>(&self.world, from.0, directions)),
            self.frame.reflections,
        )
    }
}
