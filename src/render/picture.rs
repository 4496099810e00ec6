//! Floor 7: a frame made ready for one size of picture, and its rows. Knows no display.

use core::marker::PhantomData;

use super::{Colors, Report};
use crate::accel::light_visibility::LightVisibility;
use crate::accel::screen_bounds::ScreenBounds;
use crate::accel::screen_culling::ScreenCulling;
use crate::accel::{CullingQuality, World};
use crate::camera::{Camera, RayGenerator};
use crate::color::Sum;
use crate::ray::ScaledPoint;
use crate::render::{Fast, Quality};
use crate::shade::{BlinnPhong, Shading};
use crate::trace::{Traced, Tracer};

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
    bounds: Option<ScreenBounds<W::Room>>,
    width: u32,
    height: u32,
    reflections: u8,
    kinds: PhantomData<(Q, K)>,
}

impl<W: World, Q, K> Picture<W, Q, K> {
    /// Columns and rows: 1 to 65535.
    #[inline(always)]
    pub(crate) fn sides(&self) -> [u32; 2] {
        [self.width, self.height]
    }

    /// The scene.
    pub(crate) fn world(&self) -> &W {
        &self.world
    }
}

impl<W: World, Q: Quality, K: Shading> Picture<W, Q, K> {
    /// Columns and rows are each taken as 1 to 65535.
    #[inline(always)]
    pub(super) fn new(world: W, camera: &Camera, sides: [u32; 2], reflections: u8) -> Self {
        let [width, height] = sides.map(|side| side.clamp(1, 65_535));
        let mut picture = Self {
            world,
            view: LightVisibility::unclear(ScaledPoint::ORIGIN),
            bounds: None,
            generator: None,
            width,
            height,
            reflections,
            kinds: PhantomData,
        };
        let world = &picture.world;
        if world.parts().is_empty() {
            return picture;
        }
        let position = camera.description().position;
        let from = world.parts().grid.place(position);
        let generator = camera.generator(width, height);
        picture.view = match Q::CULLING.light_occluders {
            true => LightVisibility::new(world, from),
            false => LightVisibility::unclear(from),
        };
        if Q::CULLING.screen_bounds && from.is_near() {
            let bounds = picture.bounds.insert(ScreenBounds::empty());
            bounds.look(world, &camera.screen_axes(&generator, from.point));
        }
        picture.generator = Some(generator);
        picture
    }

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
        if y >= self.height || x >= self.width || pixels.is_empty() {
            return Report::NONE;
        }
        let inside = pixels.len().min((self.width - x) as usize);
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
        draw: impl FnOnce(&mut Colors<'_, '_, W, K, Q>) -> T,
    ) -> (T, Report) {
        let mut tracer = self.tracer(y);
        let mut colors = Colors::new(&mut tracer, generator.row(y), x, self.width);
        let drawn = draw(&mut colors);
        (drawn, Report::of(&tracer))
    }

    /// The rays, unless there is nothing to be met.
    #[inline(always)]
    pub(crate) fn generator(&self) -> Option<&RayGenerator> {
        match W::NEEDS.is_nothing() {
            true => None,
            false => self.generator.as_ref(),
        }
    }

    /// The sum of every pixel, where there is nothing to be met.
    pub(crate) fn only_sum(&self) -> Sum {
        Traced::missed::<W, K>(&self.world).sum
    }

    /// What follows the rays of row `y`.
    #[inline(always)]
    fn tracer(&self, y: u32) -> Tracer<'_, W, K, Q> {
        let (bounds, from) = (self.bounds.as_ref(), self.view.from);
        let culling = match Tracer::<W, K, Q>::IS_PLAIN {
            true => ScreenCulling::new::<false>(bounds, from, y, true),
            false => ScreenCulling::new::<true>(bounds, from, y, !Q::CULLING.screen_bounds),
        };
        Tracer::new(&self.world, &self.view, culling, self.reflections)
    }
}

/// Fills pixels with one colour; out of line, or its caller's loops are unrolled around a constant.
#[inline(never)]
fn fill<C: Copy>(pixels: &mut [C], color: C) {
    pixels.fill(color);
}
