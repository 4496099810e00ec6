//! Floor 7: the report on a drawn picture. This file knows no pixel.

use crate::accel::World;
use crate::number::Unit;
use crate::trace::Tracer;

/// The report on a picture, or on a part of one, that has been drawn.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use reflet::Report;
/// use reflet::quality::Exact;
/// use reflet::scenes::{BuiltIn, Mirror2};
///
/// let frame = Mirror2::frame(&Mirror2::CAMERA).reflections(1).quality::<Exact>();
/// let frame = frame.prepare(Size::new(32, 32));
/// let rows = frame.on(&Mirror2)?;
/// let mut row = [Rgb888::BLACK; 32];
/// let (upper, lower) = (rows.row(8, 0, &mut row), rows.row(24, 0, &mut row));
/// let both = upper.merge(lower);
/// assert_eq!(both.rays, upper.rays + lower.rays);
/// assert_eq!(both.cut_off, upper.cut_off.max(lower.cut_off));
/// assert_eq!(Report::NONE.merge(both), both);
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Report {
    /// Number of rays: one for each traced pixel and one for each reflection, without shadow rays.
    ///
    /// With [`crate::quality::Fast`] not every pixel is traced.
    pub rays: u64,
    /// Largest throughput, 0 to 1, with which the number of reflections or the quality ended a path.
    ///
    /// Ending paths changes no traced pixel by more than this times the brightest colour of the scene;
    /// [`Rows::cut_off_bound`](crate::Rows::cut_off_bound) computes that product.
    pub cut_off: Unit,
}

impl Report {
    /// Report on an empty picture: no rays, and no path cut off.
    pub const NONE: Self = Self {
        rays: 0,
        cut_off: Unit::ZERO,
    };

    /// Returns the report on two parts together: the sum of the rays, the larger `cut_off`.
    #[must_use]
    pub fn merge(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            cut_off: self.cut_off.max(other.cut_off),
        }
    }

    /// Returns the report on the rays that a tracer has followed.
    #[inline(always)]
    pub(super) fn of<W: World, K, Q>(tracer: &Tracer<'_, W, K, Q>) -> Self {
        Self {
            rays: tracer.rays.into(),
            cut_off: tracer.cut_off,
        }
    }
}
