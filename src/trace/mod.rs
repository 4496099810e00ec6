//! Floor 6: follows one path and returns its colour: the sum over reflections, the throughput, and when
//! the path stops.
//!
//! The colour is c = Σᵢ (1 - αᵢ) (Π over k < i of αₖ) cᵢ, computed in a loop. The throughput Π αₖ is
//! carried along. The path ends when the throughput is zero or too small, when nothing is hit, or after
//! the last reflection.

mod border;
mod bounce;
mod cells;
mod follow;
mod footprint;
mod known;
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

pub(crate) use bounce::Pixel;
pub(crate) use cells::Cells;
pub(crate) use footprint::Footprint;
use stops::STOPS;
pub(crate) use stops::Stops;
pub(crate) use stretch::Progress;
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
use crate::number::Unit;
use crate::qualities::Quality;
use crate::ray::{PathSignature, RowPlane};
use crate::scene::shape_set::ShapeSet;
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
    /// Index of the sphere that the camera's rays surely hit first, or [`known::NO_BALL`].
    known_ball: usize,
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
            known_ball: known::NO_BALL,
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

    /// Turns to rays through row `y` that lie in another plane.
    pub(crate) fn turn(&mut self, y: u32, (plane, directions): (RowPlane, &RowDirections)) {
        let from = self.visibility.from;
        self.culling.turn(y, plane);
        self.list = row_list::<_, Q>(self.world, from, directions);
    }
}

#[cfg(test)]
pub(crate) mod tests;
