//! Floor 6: one ray to one colour: the accumulation over reflections, its weight and its stop.
//!
//! c = Σᵢ (1 - αᵢ) (Π over k < i of αₖ) cᵢ, in a loop: the weight Π αₖ is carried along, and the
//! path ends where it is spent, where nothing is met, or after the last reflection.

mod visibility;

use core::marker::PhantomData;

use visibility::{Culled, Plain};

use crate::accel::light_visibility::LightVisibility;
use crate::accel::screen_culling::ScreenCulling;
use crate::accel::{CullingQuality, LONGEST_STRIDE, Window, World, nearest_ahead};
use crate::color::Sum;
use crate::number::{Unit, share};
use crate::quality::Quality;
use crate::ray::{PathSignature, ScaledPoint, ScaledRay};
use crate::scene::access::ShapeId;
use crate::scene::nearest::Hit;
use crate::scene::query::nearest_hit;
use crate::scene::{Mirrors, Surface, far, planes};
use crate::shade::Lit;
use crate::shade::highlight::sealed::Shading;
use crate::vector::Direction;

/// The colour at the end of a path, and what it met.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Traced {
    pub(crate) sum: Sum,
    pub(crate) signature: PathSignature,
}

impl Traced {
    /// Of a path that has not met anything.
    pub(crate) const NONE: Self = Self {
        sum: Sum::ZERO,
        signature: PathSignature::new(),
    };

    /// Of no path: black, and like no other.
    pub(crate) const BEYOND: Self = Self {
        sum: Sum::ZERO,
        signature: PathSignature::of_none(),
    };

    /// Of paths that meet nothing and pass by nothing that is thin.
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
    /// The largest weight with which a path would have gone on.
    pub(crate) cut_off: Unit,
    kinds: PhantomData<(K, Q)>,
}

impl<'a, W: World, K: Shading, Q: Quality> Tracer<'a, W, K, Q> {
    /// Whether every pixel is traced, and nothing is known before about what its ray may meet.
    pub(crate) const IS_PLAIN: bool = !Q::CULLING;

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
        match Q::CULLING {
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

    /// How many columns lie from one pixel that is always traced to the next.
    ///
    /// What all planes together show is cut into convex parts, one for each sequence of planes that a
    /// path can meet, and no plane throws a shadow. So nothing lies between two pixels whose paths
    /// went alike.
    #[inline(always)]
    pub(crate) fn stride(&self) -> u32 {
        match Q::STRIDE > 1 && !self.world.parts().has_bounded() {
            true => LONGEST_STRIDE,
            false => Q::STRIDE,
        }
    }

    /// Follows the path that begins in this direction, through the pixel of a column: one of those it
    /// has been turned to.
    #[inline(always)]
    pub(crate) fn trace(&mut self, window: (&Window, u32), direction: Direction) -> Traced {
        let world = self.world;
        let mut path = ScaledRay::new(self.visibility.from, direction);
        let Traced {
            mut sum,
            mut signature,
        } = Traced::NONE;
        let mut weight = Unit::ONE;
        let mut mirror = ShapeId::NONE;
        let mut skip = ShapeId::NONE;
        let mut reflections = 0;
        let mut is_bent = false;
        loop {
            let met = self.meet(window, &path, reflections, (mirror, skip), &mut signature);
            let Some(surface) = surface(world, &path, met) else {
                sum.add(weight, K::missed(world));
                signature.note(u32::MAX);
                break;
            };
            signature.note(surface.shape.side(surface.is_inside));
            let reflected = match K::REFLECTS && W::NEEDS.mirrors != Mirrors::None {
                true => share(weight, surface.material(world).mirror),
                false => Unit::ZERO,
            };
            // A view of normals has none but the surface's own colour.
            let is_seen = !K::REFLECTS || W::NEEDS.mirrors != Mirrors::All;
            if is_seen && reflected < weight {
                let lit = self.shade(&surface);
                signature.note(lit.lights);
                sum.add(weight - reflected, lit.color);
            }
            weight = reflected;
            if weight == Unit::ZERO {
                break;
            }
            if weight < world.parts().smallest_weight(Q::SMALLEST_WEIGHT)
                // Known when compiled, so that what follows is not linked.
                || W::NEEDS.reflections == 0
                || reflections >= self.reflections
            {
                self.cut_off = self.cut_off.max(weight);
                break;
            }
            reflections += 1;
            if !W::NEEDS.mirrored {
                sum.add(weight, K::missed(world));
                break;
            }
            is_bent |= !world.parts().is_plane(surface.shape);
            surface.reflect(world, &mut path);
            mirror = surface.shape;
            skip = surface.skip(world);
        }
        self.rays += reflections + 1;
        let signature = signature.ended(is_bent);
        Traced { sum, signature }
    }

    /// The colour of a surface without reflections.
    #[inline(always)]
    fn shade(&self, surface: &Surface<'_>) -> Lit {
        let world = self.world;
        match Q::CULLING {
            true => K::color::<W, Q, _>(world, surface, &Culled::new(world, self.visibility)),
            false => K::color::<W, Q, _>(world, surface, &Plain(world)),
        }
    }

    /// What a path that has been reflected so often meets first, and where.
    #[inline(always)]
    fn meet(
        &mut self,
        (window, column): (&Window, u32),
        path: &ScaledRay,
        reflections: u32,
        (mirror, skip): (ShapeId, ShapeId),
        signature: &mut PathSignature,
    ) -> Option<(ScaledPoint, ShapeId)> {
        let world = self.world;
        if !Q::CULLING {
            return nearest_hit::<W, false>(world, path, skip, signature);
        }
        let hit = self.nearest(
            (window, column),
            path,
            reflections,
            (mirror, skip),
            signature,
        );
        match Q::IS_PRECISE {
            true => far::located::<W, true>(world, path, skip, hit, signature),
            false => far::located::<W, false>(world, path, skip, hit, signature),
        }
    }

    /// What a path that has been reflected so often meets first if it is short.
    #[inline(always)]
    fn nearest(
        &mut self,
        (window, column): (&Window, u32),
        path: &ScaledRay,
        reflections: u32,
        (mirror, skip): (ShapeId, ShapeId),
        signature: &mut PathSignature,
    ) -> Hit {
        let (world, ray) = (self.world, &path.ray);
        if !path.from().is_near() {
            return Hit::BEYOND;
        }
        let parts = world.parts();
        let bounded = if !parts.has_bounded() {
            Hit::NONE
        } else if reflections == 0 {
            self.culling.direct(world, column, ray, signature)
        } else {
            match parts.plane(skip) {
                Some(plane) if reflections == 1 => {
                    self.culling
                        .mirrored(world, (skip, plane), (window, column), ray, signature)
                }
                _ => nearest_ahead(world, ray, (mirror, skip), signature),
            }
        };
        planes::nearest(world, ray, skip, bounded)
    }
}

/// The surface where a path meets a shape, if it does.
#[inline(always)]
fn surface<'a, W: World>(
    world: &'a W,
    path: &ScaledRay,
    met: Option<(ScaledPoint, ShapeId)>,
) -> Option<Surface<'a>> {
    let (at, shape) = met?;
    Surface::new(world, at, shape, path.direction())
}

#[cfg(test)]
mod tests;
