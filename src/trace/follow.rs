//! Follows one path: what each of its rays meets, and the sum over its surfaces.

use super::bounce::Bounce;
use super::footprint::SeenCells;
use super::visibility::{Culled, Plain};
use super::{Footprint, Pixel, STOPS, Stops, Traced, Tracer};
use crate::accel::World;
use crate::number::{IS_ARMV6_M, Unit, share};
use crate::qualities::Quality;
use crate::ray::ScaledRay;
use crate::scene::{Mirrors, Surface};
use crate::shade::Lit;
use crate::shade::highlight::sealed::Shading;
use crate::vector::Direction;

/// What is known so far of a path that is followed.
struct Followed {
    /// The sum and the signature.
    traced: Traced,
    cells: SeenCells,
    throughput: Unit,
    bounce: Bounce,
    /// Whether the rays that can be seen have known bounds.
    is_bounded: bool,
}

impl<'a, W: World, K: Shading, Q: Quality> Tracer<'a, W, K, Q> {
    /// Whether the camera's ray has code of its own. It takes more flash, and on an Armv6-M more instructions.
    const IS_APART: bool = !Q::IS_SMALL && !IS_ARMV6_M;

    /// Follows one path from the camera in `direction`, and returns its colour and signature. Stores its
    /// hits in `stops` if pixels are interpolated and `is_read`. The signature has no meaning otherwise.
    #[inline(always)]
    pub(crate) fn trace(
        &mut self,
        mut pixel: Pixel<'_>,
        (direction, footprint): (Direction, Option<Footprint>),
        (stops, is_read): (&mut Stops, bool),
    ) -> Traced {
        stops.clear();
        // Hits are stored from this throughput on: those that can be seen; none if nobody reads them.
        let least = is_read.then(|| self.world.parts().smallest_weight(Q::TOLERANCE));
        let least = least.unwrap_or(Unit::from_bits(i32::MAX));
        let mut path = Followed {
            traced: Traced::NONE,
            cells: SeenCells::new(footprint),
            throughput: Unit::ONE,
            bounce: Bounce::NONE,
            is_bounded: true,
        };
        // Not part of the path: its address is taken, and the path stays in registers.
        let mut ray = ScaledRay::new(self.visibility.from, direction);
        // Code of its own knows that nothing was met before.
        if !Self::IS_APART || self.meet((&mut pixel, &mut ray), &mut path, (stops, least)) {
            while self.meet((&mut pixel, &mut ray), &mut path, (stops, least)) {}
        }
        self.rays += path.bounce.count + 1;
        path.traced.signature = path
            .cells
            .marked(path.traced.signature.ended(path.is_bounded));
        path.traced
    }

    /// Follows a path's ray to the first surface, and adds the colour there. Returns whether the path goes on, with `ray` as
    /// the mirrored one. Stores the hit in `stops` if the throughput is at least `least`.
    #[inline(always)]
    fn meet(
        &mut self,
        (pixel, ray): (&mut Pixel<'_>, &mut ScaledRay),
        path: &mut Followed,
        (stops, least): (&mut Stops, Unit),
    ) -> bool {
        let world = self.world;
        let Followed {
            traced,
            cells,
            throughput,
            bounce,
            is_bounded,
        } = path;
        let is_seen = |throughput| Self::IS_INTERPOLATED && throughput >= least;
        let Some(surface) = self.surface(pixel, ray, bounce) else {
            traced.add_missed::<W, K>(world, *throughput, ray.direction());
            if is_seen(*throughput) {
                stops.add(None, ray.direction());
            }
            return false;
        };
        cells.reach::<W>(ray, &surface);
        traced.signature.note(surface.shape.side(surface.is_inside));
        let reflected = Self::reflected(world, &surface, *throughput);
        let mut lights = 0;
        if reflected < *throughput && Self::has_own(world, &surface) {
            let lit = self.shade(&surface);
            lights = lit.lights;
            traced.signature.note(lights);
            let own = cells.color::<W, Q>(world, (&surface, &lit), &mut traced.signature);
            traced.sum.add(*throughput - reflected, own);
        }
        if is_seen(*throughput) {
            stops.add(Some((&surface, lights)), surface.view);
        }
        *throughput = reflected;
        if reflected == Unit::ZERO || self.is_cut_off(reflected, bounce.count) {
            return false;
        }
        bounce.count += 1;
        if !W::NEEDS.mirrored {
            traced.add_missed::<W, K>(world, reflected, ray.direction());
            return false;
        }
        *is_bounded &= !is_seen(reflected) || self.is_bounded_after(&surface, bounce.count);
        (bounce.mirror, bounce.skip) = (surface.shape, surface.skip(world));
        cells.turn(world, &surface);
        surface.reflect(world, ray);
        true
    }

    /// Tests whether the rays after a reflection have known bounds: only planes mirrored them, and not too
    /// many. `count` is the number of the reflection.
    #[inline(always)]
    fn is_bounded_after(&self, surface: &Surface<'_>, count: u32) -> bool {
        let parts = self.world.parts();
        let is_plane = W::NEEDS.plane_mirrors && parts.plane_index(surface.shape).is_some();
        is_plane && (count as usize) < STOPS
    }

    /// Tests whether a surface may show a colour besides what it mirrors.
    #[inline(always)]
    pub(super) fn has_own(world: &W, surface: &Surface<'_>) -> bool {
        // A view of normals does not reflect: it shows the surface's own colour even of a mirror.
        !K::REFLECTS
            || W::NEEDS.mirrors != Mirrors::All
                && (!W::HAS_BLANK || surface.material(world).has_own())
    }

    /// Returns the throughput of a path after a surface: `throughput` times the share that the surface
    /// mirrors.
    #[inline(always)]
    pub(super) fn reflected(world: &W, surface: &Surface<'_>, throughput: Unit) -> Unit {
        if K::REFLECTS && W::NEEDS.mirrors != Mirrors::None {
            share(throughput, surface.material(world).mirror)
        } else {
            Unit::ZERO
        }
    }

    /// Tests whether a path ends with this throughput, after so many reflections. If so, updates
    /// `cut_off`.
    #[inline(always)]
    pub(super) fn is_cut_off(&mut self, throughput: Unit, reflections: u32) -> bool {
        let is_cut_off = throughput < self.world.parts().smallest_weight(Q::SMALLEST_WEIGHT)
            // Known at compile time, so that the code for reflections is not linked.
            || W::NEEDS.reflections == 0
            || reflections >= self.reflections;
        if is_cut_off {
            self.cut_off = self.cut_off.max(throughput);
        }
        is_cut_off
    }

    /// Returns the colour of a surface without reflections, and the lights that shine on it.
    #[inline(always)]
    pub(super) fn shade(&self, surface: &Surface<'_>) -> Lit {
        let world = self.world;
        if Self::IS_PLAIN {
            K::color::<W, Q, _>(world, surface, &Plain::<W, Q>::new(world))
        } else {
            K::color::<W, Q, _>(world, surface, &Culled::<W, Q>::new(world, self.visibility))
        }
    }
}
