//! Floor 6: one ray to one colour: the accumulation over reflections, its throughput and its stop.
//!
//! c = Σᵢ (1 - αᵢ) (Π over k < i of αₖ) cᵢ, in a loop: the throughput Π αₖ is carried along, and the
//! path ends where it is spent, where nothing is hit, or after the last reflection.

mod visibility;

use core::marker::PhantomData;

use visibility::{Culled, Plain};

use crate::accel::light_visibility::LightVisibility;
use crate::accel::screen_culling::ScreenCulling;
use crate::accel::{CullingQuality, Window, World, nearest_ahead};
use crate::color::Sum;
use crate::number::{Unit, share};
use crate::ray::{PathSignature, ScaledRay};
use crate::scene::access::ShapeId;
use crate::scene::nearest::Hit;
use crate::scene::query::{located, nearest_hit};
use crate::scene::{Mirrors, Surface, planes};
use crate::shade::highlight::sealed::Shading;
use crate::shade::{LightQuality, Lit};
use crate::vector::Direction;

/// How exactly paths are followed.
pub trait PathQuality: CullingQuality + LightQuality {
    /// A path ends when its throughput times the brightest colour of the scene falls below this share of
    /// white.
    const SMALLEST_WEIGHT: Unit;
}

/// The colour at the end of a path, and what it met.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Traced {
    pub(crate) sum: Sum,
    pub(crate) signature: PathSignature,
}

impl Traced {
    /// The start of a path: no light, nothing hit.
    pub(crate) const NONE: Self = Self {
        sum: Sum::ZERO,
        signature: PathSignature::new(),
    };

    /// Sentinel for a column beyond the picture: black; its signature equals no real one.
    pub(crate) const BEYOND: Self = Self {
        sum: Sum::ZERO,
        signature: PathSignature::of_none(),
    };

    /// The result of a path that hits nothing and passes no thin shape.
    pub(crate) fn missed<W: World, K: Shading>(world: &W) -> Self {
        let mut missed = Self::NONE;
        missed.sum.add(Unit::ONE, K::missed(world));
        missed.signature.note(0);
        missed.signature.note(u32::MAX);
        missed.signature = missed.signature.ended(false);
        missed
    }
}

/// Follows the rays of one row of pixels.
pub(crate) struct Tracer<'a, W: World, K, Q> {
    world: &'a W,
    visibility: &'a LightVisibility,
    culling: ScreenCulling<'a, W>,
    /// How often a ray is reflected at most.
    reflections: u32,
    /// How many rays were followed, those to the lights apart.
    pub(crate) rays: u32,
    /// The largest throughput with which a path would have gone on.
    pub(crate) cut_off: Unit,
    kinds: PhantomData<(K, Q)>,
}

impl<'a, W: World, K: Shading, Q: PathQuality> Tracer<'a, W, K, Q> {
    /// Whether every pixel is traced, and nothing is known before about what its ray may meet.
    pub(crate) const IS_PLAIN: bool = !Q::CULLING.is_any();

    #[inline(always)]
    pub(crate) fn new(
        world: &'a W,
        visibility: &'a LightVisibility,
        culling: ScreenCulling<'a, W>,
        reflections: u8,
    ) -> Self {
        Self {
            world,
            visibility,
            culling,
            reflections: reflections.min(W::NEEDS.reflections).into(),
            rays: 0,
            cut_off: Unit::ZERO,
            kinds: PhantomData,
        }
    }

    /// Advances to the columns from `first` to `last`; `first` never decreases.
    #[inline(always)]
    pub(crate) fn advance(&mut self, first: u32, last: u32) -> Window {
        match Q::CULLING.is_any() {
            true => self.culling.advance(self.world, first, last),
            false => Window::default(),
        }
    }

    /// If all paths that begin in a window are [`Tracer::missed`], the first column for which that is not
    /// known.
    #[inline(always)]
    pub(crate) fn clear_until(&self, window: &Window) -> Option<u32> {
        self.culling.clear_until(self.world, window)
    }

    /// Whether the scene has bounded shapes.
    #[inline(always)]
    pub(crate) fn has_bounded(&self) -> bool {
        self.world.parts().has_bounded()
    }

    /// What paths are that meet nothing.
    pub(crate) fn missed(&self) -> Traced {
        Traced::missed::<W, K>(self.world)
    }

    /// Whether the signatures of the row tell on which side of something thin a path passes: not if the
    /// camera is so far away that it is not known what is thin.
    #[inline(always)]
    pub(crate) fn notes_what_is_thin(&self) -> bool {
        self.visibility.from.is_near()
    }

    /// Follows the path that begins in this direction, through the pixel of a column in a window.
    #[inline(always)]
    pub(crate) fn trace(&mut self, pixel: (&Window, u32), direction: Direction) -> Traced {
        let world = self.world;
        let mut ray = ScaledRay::new(self.visibility.from, direction);
        let Traced {
            mut sum,
            mut signature,
        } = Traced::NONE;
        let mut throughput = Unit::ONE;
        let mut bounce = Bounce::NONE;
        let mut is_bent = false;
        loop {
            let Some(surface) = self.surface(pixel, &ray, &bounce, &mut signature) else {
                sum.add(throughput, K::missed(world));
                signature.note(u32::MAX);
                break;
            };
            signature.note(surface.shape.side(surface.is_inside));
            let reflected = Self::reflected(world, &surface, throughput);
            // A view of normals has none but the surface's own colour.
            let is_seen = !K::REFLECTS || W::NEEDS.mirrors != Mirrors::All;
            if is_seen && reflected < throughput {
                let lit = self.shade(&surface);
                signature.note(lit.lights);
                sum.add(throughput - reflected, lit.color);
            }
            throughput = reflected;
            if throughput == Unit::ZERO || self.is_cut_off(throughput, bounce.count) {
                break;
            }
            bounce.count += 1;
            if !W::NEEDS.mirrored {
                sum.add(throughput, K::missed(world));
                break;
            }
            is_bent |= !world.parts().is_flat(surface.shape);
            surface.reflect(world, &mut ray);
            (bounce.mirror, bounce.skip) = (surface.shape, surface.skip(world));
        }
        self.rays += bounce.count + 1;
        let signature = signature.ended(is_bent);
        Traced { sum, signature }
    }

    /// What is left of a path's throughput after a surface.
    #[inline(always)]
    fn reflected(world: &W, surface: &Surface<'_>, throughput: Unit) -> Unit {
        match K::REFLECTS && W::NEEDS.mirrors != Mirrors::None {
            true => share(throughput, surface.material(world).mirror),
            false => Unit::ZERO,
        }
    }

    /// Whether a path ends with this throughput, after so many reflections; notes it if it does.
    #[inline(always)]
    fn is_cut_off(&mut self, throughput: Unit, reflections: u32) -> bool {
        let is_cut_off = throughput < self.world.parts().smallest_weight(Q::SMALLEST_WEIGHT)
            // Known when compiled, so that what follows is not linked.
            || W::NEEDS.reflections == 0
            || reflections >= self.reflections;
        if is_cut_off {
            self.cut_off = self.cut_off.max(throughput);
        }
        is_cut_off
    }

    /// The colour of a surface without reflections.
    #[inline(always)]
    fn shade(&self, surface: &Surface<'_>) -> Lit {
        let world = self.world;
        match Q::CULLING.is_any() {
            true => {
                K::color::<W, Q, _>(world, surface, &Culled::<W, Q>::new(world, self.visibility))
            }
            false => K::color::<W, Q, _>(world, surface, &Plain(world)),
        }
    }

    /// The surface that a ray hits first, if it hits one.
    #[inline(always)]
    fn surface(
        &mut self,
        pixel: (&Window, u32),
        ray: &ScaledRay,
        bounce: &Bounce,
        signature: &mut PathSignature,
    ) -> Option<Surface<'a>> {
        let (world, skip) = (self.world, bounce.skip);
        let (at, shape) = if !Q::CULLING.is_any() {
            nearest_hit(world, ray, skip, signature)
        } else {
            let hit = self.near_hit(pixel, ray, bounce, signature);
            match Q::IS_PRECISE {
                true => located::<W, true>(world, ray, skip, hit, signature),
                false => located::<W, false>(world, ray, skip, hit, signature),
            }
        }?;
        Surface::new(world, at, shape, ray.direction())
    }

    /// What a ray hits first if that is near.
    #[inline(always)]
    fn near_hit(
        &mut self,
        (window, column): (&Window, u32),
        ray: &ScaledRay,
        bounce: &Bounce,
        signature: &mut PathSignature,
    ) -> Hit {
        if !ray.from().is_near() {
            return Hit::BEYOND;
        }
        let (world, ray, skip) = (self.world, &ray.ray, bounce.skip);
        let parts = world.parts();
        let bounded = if !parts.has_bounded() {
            Hit::NONE
        } else if bounce.count == 0 {
            self.culling.direct(world, column, ray, signature)
        } else {
            match parts.plane(skip) {
                Some(plane) if bounce.count == 1 => {
                    let pixel = (window, column);
                    self.culling
                        .mirrored(world, (skip, plane), pixel, ray, signature)
                }
                _ => nearest_ahead::<W, Q>(world, ray, (bounce.mirror, skip), signature),
            }
        };
        planes::nearest(world, ray, skip, bounded)
    }
}

/// The latest reflection of a path.
struct Bounce {
    /// How many there were.
    count: u32,
    mirror: ShapeId,
    /// The mirror, unless the ray can hit it again.
    skip: ShapeId,
}

impl Bounce {
    /// Of a ray from the camera.
    const NONE: Self = Self {
        count: 0,
        mirror: ShapeId::NONE,
        skip: ShapeId::NONE,
    };
}

#[cfg(test)]
pub(crate) mod tests;
