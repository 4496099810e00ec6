//! Floor 7: what is known of what was drawn. Knows no pixel.

use crate::accel::World;
use crate::number::Unit;
use crate::trace::Tracer;

/// What is known about a picture, or a part of one, when it has been drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Report {
    /// How many rays were followed: one for each pixel that was traced (with [`crate::quality::Fast`], not all
    /// are) and one for each reflection; rays to lights not counted.
    pub rays: u64,
    /// The largest weight with which a path was ended by the number of reflections or by the
    /// quality. No colour of the pixels that were traced is wrong by more than this times the brightest
    /// colour of the scene on account of it: [`crate::Rows::cut_off_bound`].
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

    /// Of what a tracer followed.
    #[inline(always)]
    pub(super) fn of<W: World, K, Q>(tracer: &Tracer<'_, W, K, Q>) -> Self {
        Self {
            rays: tracer.rays.into(),
            cut_off: tracer.cut_off,
        }
    }
}
