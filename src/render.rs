//! Floor 7: rows of pixels into a display. The only floor that names embedded-graphics.

mod bound;
mod budget;
mod dither;
mod enlarged;

pub use budget::{Budgeted, Choice, Front, FrontPoint, Grade};
pub use dither::{Ditherable, Dithered, Threshold, dither};
pub use enlarged::Enlarged;

use core::marker::PhantomData;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::transform::Transform;

use crate::accel::light_visibility::LightVisibility;
use crate::accel::screen_bounds::Bounds;
use crate::accel::screen_culling::ScreenCulling;
use crate::accel::{Apart, Static, Whole, Within, World};
use crate::camera::{Camera, RayGenerator};
use crate::color::Sum;
use crate::interpolate::Colors;
use crate::number::{Unit, unsigned};
use crate::quality::{Fast, Quality};
use crate::ray::ScaledPoint;
use crate::scene::{Bound, Excess, MostReflections, Scene};
use crate::shade::{BlinnPhong, Shading};
use crate::trace::{Traced, Tracer};

/// What is known about a picture, or a part of one, when it has been drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Report {
    /// How many rays were followed: one for each pixel that was traced (with [`Fast`], not all are) and
    /// one for each reflection; rays to lights not counted.
    pub rays: u64,
    /// The largest weight with which a path was ended by the number of reflections or by the
    /// quality. No colour of the pixels that were traced is wrong by more than this times the brightest
    /// colour of the scene on account of it: [`Picture::cut_off_bound`].
    pub cut_off: Unit,
}

impl Report {
    /// Of nothing drawn.
    pub const NONE: Self = Self {
        rays: 0,
        cut_off: Unit::ZERO,
    };

    /// Of two parts together.
    #[must_use]
    pub fn merge(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            cut_off: self.cut_off.max(other.cut_off),
        }
    }

    fn count<W: World, K, Q>(&mut self, tracer: &Tracer<'_, W, K, Q>) {
        self.rays += u64::from(tracer.rays);
        self.cut_off = self.cut_off.max(tracer.cut_off);
    }
}

/// A view of a scene that is still to be drawn: which camera, how many reflections, how exact.
///
/// Made by [`StaticFrame::frame`] or [`Scene::frame`].
pub struct Frame<'a, W, Q = Fast, K = BlinnPhong> {
    world: W,
    camera: &'a Camera,
    reflections: u8,
    kinds: PhantomData<(Q, K)>,
}

/// Reflections unless a frame says otherwise.
const REFLECTIONS: u8 = 4;

impl<'a, W: World + Copy> Frame<'a, W> {
    pub(crate) const fn new(world: W, camera: &'a Camera) -> Self {
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

    /// Makes the frame ready for one size of picture; each side is taken as 1 to 65535 pixels.
    // What it needs besides is gone before a row is drawn.
    #[inline(never)]
    pub fn sized(&self, size: Size) -> Picture<W, Q, K> {
        let (width, height) = (size.width.clamp(1, 65_535), size.height.clamp(1, 65_535));
        let mut picture = Picture {
            world: self.world,
            view: LightVisibility::unclear(ScaledPoint::ORIGIN),
            bounds: None,
            generator: None,
            size: Size::new(width, height),
            reflections: self.reflections,
            kinds: PhantomData,
        };
        if self.world.parts().is_empty() {
            return picture;
        }
        let position = self.camera.description().position;
        let from = self.world.parts().grid.place(position);
        let generator = self.camera.generator(width, height);
        let is_plain = Tracer::<W, K, Q>::IS_PLAIN;
        picture.view = match is_plain {
            true => LightVisibility::unclear(from),
            false => LightVisibility::new(&self.world, from),
        };
        if !is_plain && from.is_near() {
            let bounds = picture.bounds.insert(W::ScreenBounds::ALL);
            bounds.look(
                &self.world,
                &self.camera.screen_axes(&generator, from.point),
            );
        }
        picture.generator = Some(generator);
        picture
    }

    /// Draws the frame over the whole target, row by row.
    ///
    /// # Errors
    /// The target's own, at once: no further row is worked out.
    pub fn draw<D>(&self, target: &mut D) -> Result<Report, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
        let area = target.bounding_box();
        if area.is_zero_sized() {
            return Ok(Report::NONE);
        }
        self.sized(area.size).draw_at(area.top_left, target)
    }
}

/// A frame made ready for one size of picture.
///
/// It holds nothing that changes: rows may be drawn in any order, interrupted, or shared between
/// cores.
#[derive(Clone, Copy)]
pub struct Picture<W: World, Q = Fast, K = BlinnPhong> {
    world: W,
    /// None, where there is nothing to be seen.
    generator: Option<RayGenerator>,
    view: LightVisibility,
    /// Nothing, where the camera is far away or flash is scarce.
    bounds: Option<W::ScreenBounds>,
    size: Size,
    reflections: u8,
    kinds: PhantomData<(Q, K)>,
}

impl<W: World, Q: Quality, K: Shading> Picture<W, Q, K> {
    /// The size it was made for.
    pub fn size(&self) -> Size {
        self.size
    }

    /// Fills `pixels` with row `y` from column `x` on; row 0 is at the top.
    ///
    /// What would lie beyond the picture's edges stays as it is.
    pub fn row<C: PixelColor + From<Rgb888>>(&self, y: u32, x: u32, pixels: &mut [C]) -> Report {
        let mut report = Report::NONE;
        if y >= self.size.height || x >= self.size.width || pixels.is_empty() {
            return report;
        }
        let inside = pixels.len().min((self.size.width - x) as usize);
        let (pixels, _) = pixels.split_at_mut(inside);
        let Some(generator) = self.generator() else {
            pixels.fill(self.only_color());
            report.rays = inside as u64;
            return report;
        };
        self.fill(generator, y, x, pixels)
    }

    /// Fills pixels inside of the picture; what follows their rays is on the stack only meanwhile.
    #[inline(never)]
    fn fill<C>(&self, generator: &RayGenerator, y: u32, x: u32, pixels: &mut [C]) -> Report
    where
        C: Copy + From<Rgb888>,
    {
        let mut tracer = self.tracer(y);
        let mut colors = Colors::new(&mut tracer, generator.row(y), x, self.size.width);
        colors.fill(pixels, shown);
        let mut report = Report::NONE;
        report.count(&tracer);
        report
    }

    /// Draws the whole picture with its top left corner at `top_left` of the target, row by row;
    /// what lies outside the target is not worked out.
    ///
    /// # Errors
    /// The target's own, at once: no further row is worked out.
    pub fn draw_at<D>(&self, top_left: Point, target: &mut D) -> Result<Report, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
        self.draw_area(Rectangle::new(Point::zero(), self.size), top_left, target)
    }

    /// Draws the part of the picture inside `area` (in the picture's own coordinates), where the
    /// picture's top left corner is at `top_left` of the target.
    ///
    /// # Errors
    /// The target's own, at once: no further row is worked out.
    pub fn draw_area<D>(
        &self,
        area: Rectangle,
        top_left: Point,
        target: &mut D,
    ) -> Result<Report, D::Error>
    where
        D: DrawTarget,
        D::Color: From<Rgb888>,
    {
        let visible = Rectangle::new(
            target.bounding_box().top_left - top_left,
            target.bounding_box().size,
        );
        let area = Rectangle::new(Point::zero(), self.size)
            .intersection(&area)
            .intersection(&visible);
        let mut report = Report::NONE;
        if area.is_zero_sized() {
            return Ok(report);
        }
        let Some(generator) = self.generator() else {
            target.fill_solid(&area.translate(top_left), self.only_color())?;
            report.rays = u64::from(area.size.width) * u64::from(area.size.height);
            return Ok(report);
        };
        let (left, width) = (area.top_left.x, area.size.width);
        for y in area.rows() {
            let row = Rectangle::new(Point::new(left, y) + top_left, Size::new(width, 1));
            let mut tracer = self.tracer(unsigned(y));
            let directions = generator.row(unsigned(y));
            let mut colors = Colors::new(&mut tracer, directions, unsigned(left), self.size.width);
            let pixels = (0..width).map(|_| shown(colors.next_color()));
            target.fill_contiguous(&row, pixels)?;
            report.count(&tracer);
        }
        Ok(report)
    }

    /// The rays, unless there is nothing to be met.
    #[inline(always)]
    fn generator(&self) -> Option<&RayGenerator> {
        match W::NEEDS.is_nothing() {
            true => None,
            false => self.generator.as_ref(),
        }
    }

    /// The colour of every pixel, where there is nothing to be met.
    fn only_color<C: From<Rgb888>>(&self) -> C {
        shown(Traced::missed::<W, K>(&self.world).sum)
    }

    /// What follows the rays of row `y`.
    #[inline(always)]
    fn tracer(&self, y: u32) -> Tracer<'_, W, K, Q> {
        let (bounds, from) = (self.bounds.as_ref(), self.view.from);
        let culling = match Tracer::<W, K, Q>::IS_PLAIN {
            true => ScreenCulling::new::<false>(bounds, from, y, true),
            false => ScreenCulling::new::<true>(bounds, from, y, false),
        };
        Tracer::new(&self.world, &self.view, culling, self.reflections)
    }
}

/// A sum as a display shows it.
#[inline(always)]
fn shown<C: From<Rgb888>>(sum: Sum) -> C {
    let [red, green, blue] = sum.to_rgb8();
    C::from(Rgb888::new(red, green, blue))
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Scene<S, P, C, L, M>
{
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
    pub const fn frame_within<'a, B: Bound>(
        &'a self,
        camera: &'a Camera,
    ) -> Result<Frame<'a, Within<&'a Self, B>>, Excess> {
        match self.needs().within(&B::NEEDS) {
            Ok(()) => Ok(Frame::new(Within::new(self), camera)),
            Err(excess) => Err(excess),
        }
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
