//! Floor 6: follows one path and returns its colour: the sum over reflections, the throughput, and when
//! the path stops.
//!
//! The colour is c = Σᵢ (1 - αᵢ) (Π over k < i of αₖ) cᵢ, computed in a loop. The throughput Π αₖ is
//! carried along. The path ends when the throughput is zero or too small, when nothing is hit, or after
//! the last reflection.

mod border;
mod bounce;
mod cells;
mod footprint;
mod lights;
mod origin;
mod plane_line;
mod shown;
mod stops;
mod stretch;
mod visibility;
#[cfg(feature = "files")]
mod walk;

use core::marker::PhantomData;

use bounce::Bounce;
pub(crate) use bounce::Pixel;
pub(crate) use cells::Cells;
pub(crate) use footprint::Footprint;
use footprint::SeenCells;
use stops::STOPS;
pub(crate) use stops::Stops;
pub(crate) use stretch::Progress;
use visibility::{Culled, Plain};
#[cfg(feature = "files")]
pub use walk::End;
#[cfg(feature = "files")]
pub(crate) use walk::{Met, Walked};

use crate::accel::light_visibility::LightVisibility;
use crate::accel::row_list::row_list;
use crate::accel::screen_culling::ScreenCulling;
use crate::accel::{Window, World};
use crate::camera::RowDirections;
use crate::color::Sum;
use crate::number::{Unit, share};
use crate::qualities::Quality;
use crate::ray::{PathSignature, RowPlane, ScaledRay};
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Mirrors, Surface};
use crate::shade::Lit;
use crate::shade::highlight::sealed::Shading;
use crate::vector::{Direction, Vector};

/// The result of a path: its colour, and its signature, a hash of what it hit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Traced {
    pub(crate) sum: Sum,
    pub(crate) signature: PathSignature,
}

impl Traced {
    /// The state at the start of a path: no light, nothing hit.
    pub(crate) const NONE: Self = Self {
        sum: Sum::DARK,
        signature: PathSignature::new(),
    };

    /// Returns the result of a path that hits nothing, where the background has one colour.
    pub(crate) fn missed<W: World, K: Shading>(world: &W) -> Self {
        let mut missed = Self::NONE;
        let ahead = Direction::from_raw(Vector::new(1 << 30, 0, 0));
        missed.add_missed::<W, K>(world, Unit::ONE, ahead);
        missed.signature = missed.signature.ended(true);
        missed
    }

    /// Adds what a ray shows that hits nothing.
    #[inline(always)]
    fn add_missed<W: World, K: Shading>(&mut self, world: &W, weight: Unit, direction: Direction) {
        let beyond = K::missed(world, direction);
        self.sum.add(weight, beyond.color);
        self.signature.note(beyond.note());
    }
}

/// Follows the rays of one row of pixels.
pub(crate) struct Tracer<'a, W: World, K, Q> {
    pub(crate) world: &'a W,
    /// The camera's position, and the lights that planes hide in this frame.
    pub(crate) visibility: &'a LightVisibility,
    /// The candidates for the rays of this row.
    culling: ScreenCulling<'a, W>,
    /// The bounded shapes that the camera's rays through this row can hit, on the plain path.
    list: ShapeSet,
    /// Largest number of reflections of a path.
    reflections: u32,
    /// Number of rays that were followed, without shadow rays.
    pub(crate) rays: u32,
    /// Largest throughput that a path had when it was cut off.
    pub(crate) cut_off: Unit,
    kinds: PhantomData<(K, Q)>,
}

impl<'a, W: World, K: Shading, Q: Quality> Tracer<'a, W, K, Q> {
    /// Whether no culling is used and every pixel is traced. A branch on this constant compiles one side only.
    pub(crate) const IS_PLAIN: bool = !Q::CULLING.is_any();

    /// Whether pixels are interpolated.
    pub(crate) const IS_INTERPOLATED: bool = Q::TOLERANCE.to_bits() > 0 && !Self::IS_PLAIN;

    /// Makes the tracer of one row of pixels. `reflections` is limited to what the scene needs.
    #[inline(always)]
    pub(crate) fn new(
        world: &'a W,
        visibility: &'a LightVisibility,
        (culling, list): (ScreenCulling<'a, W>, ShapeSet),
        reflections: u8,
    ) -> Self {
        Self {
            world,
            visibility,
            culling,
            list,
            reflections: reflections.min(W::NEEDS.reflections).into(),
            rays: 0,
            cut_off: Unit::ZERO,
            kinds: PhantomData,
        }
    }

    /// Advances to the columns from `first` to `last`, and returns them. `first` never decreases.
    #[inline(always)]
    pub(crate) fn advance(&mut self, first: u32, last: u32) -> Window {
        if Self::IS_PLAIN {
            Window::default()
        } else {
            self.culling.advance(self.world, first, last)
        }
    }

    /// Returns the column before which all paths of the row are [`Tracer::missed`], if those of the
    /// window are. Returns `None` if that is not known.
    #[inline(always)]
    pub(crate) fn clear_until(&self, window: &Window) -> Option<u32> {
        (!self.has_sky()).then(|| self.culling.clear_until(self.world, window))?
    }

    /// Tests whether rays that hit nothing show different colours.
    #[inline(always)]
    fn has_sky(&self) -> bool {
        W::NEEDS.sky && self.world.parts().has_sky()
    }

    /// Returns the result of a path that hits nothing, where the background has one colour.
    pub(crate) fn missed(&self) -> Traced {
        Traced::missed::<W, K>(self.world)
    }

    /// Tests whether the camera is near. If it is far, it is not known what lies between two pixels.
    #[inline(always)]
    pub(crate) fn is_near(&self) -> bool {
        self.visibility.from.is_near()
    }

    /// Follows one path from the camera in `direction`, and returns its colour and signature. Stores its
    /// hits in `stops` if pixels are interpolated and `is_read`. The signature has no meaning otherwise.
    #[inline(always)]
    pub(crate) fn trace(
        &mut self,
        mut pixel: Pixel<'_>,
        (direction, footprint): (Direction, Option<Footprint>),
        (stops, is_read): (&mut Stops, bool),
    ) -> Traced {
        let world = self.world;
        let mut ray = ScaledRay::new(self.visibility.from, direction);
        let (mut traced, mut cells) = (Traced::NONE, SeenCells::new(footprint));
        stops.clear();
        let (mut throughput, mut bounce, mut is_bounded) = (Unit::ONE, Bounce::NONE, true);
        // Hits are stored from this throughput on: those that can be seen; none if nobody reads them.
        let least = is_read.then(|| world.parts().smallest_weight(Q::TOLERANCE));
        let least = least.unwrap_or(Unit::from_bits(i32::MAX));
        let is_seen = |throughput| Self::IS_INTERPOLATED && throughput >= least;
        loop {
            let Some(surface) = self.surface(&mut pixel, &ray, &bounce) else {
                traced.add_missed::<W, K>(world, throughput, ray.direction());
                if is_seen(throughput) {
                    stops.add(None, ray.direction());
                }
                break;
            };
            cells.reach::<W>(&ray, &surface);
            traced.signature.note(surface.shape.side(surface.is_inside));
            let reflected = Self::reflected(world, &surface, throughput);
            let mut lights = 0;
            if reflected < throughput && Self::has_own(world, &surface) {
                let lit = self.shade(&surface);
                lights = lit.lights;
                traced.signature.note(lights);
                let own = cells.color::<W, Q>(world, (&surface, &lit), &mut traced.signature);
                traced.sum.add(throughput - reflected, own);
            }
            if is_seen(throughput) {
                stops.add(Some((&surface, lights)), surface.view);
            }
            throughput = reflected;
            if throughput == Unit::ZERO || self.is_cut_off(throughput, bounce.count) {
                break;
            }
            bounce.count += 1;
            if !W::NEEDS.mirrored {
                traced.add_missed::<W, K>(world, throughput, ray.direction());
                break;
            }
            is_bounded &= !is_seen(throughput) || self.is_bounded_after(&surface, bounce.count);
            surface.reflect(world, &mut ray);
            cells.turn(world, &surface);
            (bounce.mirror, bounce.skip) = (surface.shape, surface.skip(world));
        }
        self.rays += bounce.count + 1;
        traced.signature = cells.marked(traced.signature.ended(is_bounded));
        traced
    }

    /// Turns to rays through row `y` that lie in another plane.
    pub(crate) fn turn(&mut self, y: u32, (plane, directions): (RowPlane, &RowDirections)) {
        let from = self.visibility.from;
        self.culling.turn(y, plane);
        self.list = row_list::<_, Q>(self.world, from, directions);
    }

    /// Tests whether the rays after a reflection have known bounds: only planes mirrored them, and not too
    /// many. `count` is the number of the reflection.
    #[inline(always)]
    fn is_bounded_after(&self, surface: &Surface<'_>, count: u32) -> bool {
        let parts = self.world.parts();
        let is_plane = W::NEEDS.plane_mirrors && parts.plane_index(surface.shape).is_some();
        is_plane && (count as usize) < STOPS
    }

    /// Tests whether a surface may show a colour of its own.
    #[inline(always)]
    fn has_own(world: &W, surface: &Surface<'_>) -> bool {
        // A view of normals does not reflect: it shows the surface's own colour even of a mirror.
        !K::REFLECTS
            || W::NEEDS.mirrors != Mirrors::All
                && (!W::HAS_BLANK || surface.material(world).has_own())
    }

    /// Returns the throughput of a path after a surface: `throughput` times the share that the surface
    /// mirrors.
    #[inline(always)]
    fn reflected(world: &W, surface: &Surface<'_>, throughput: Unit) -> Unit {
        if K::REFLECTS && W::NEEDS.mirrors != Mirrors::None {
            share(throughput, surface.material(world).mirror)
        } else {
            Unit::ZERO
        }
    }

    /// Tests whether a path ends with this throughput, after so many reflections. If so, updates
    /// `cut_off`.
    #[inline(always)]
    fn is_cut_off(&mut self, throughput: Unit, reflections: u32) -> bool {
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
    fn shade(&self, surface: &Surface<'_>) -> Lit {
        let world = self.world;
        if Self::IS_PLAIN {
            K::color::<W, Q, _>(world, surface, &Plain::<W, Q>::new(world))
        } else {
            K::color::<W, Q, _>(world, surface, &Culled::<W, Q>::new(world, self.visibility))
        }
    }
}

#[cfg(test)]
pub(crate) mod tests;
