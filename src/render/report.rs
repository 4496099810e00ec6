//! Floor 7: the report on a drawn picture. This file knows no pixel.

use core::fmt;

use crate::accel::World;
use crate::number::{Brightness, Unit, narrowed_unsigned, signed};
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
/// // As text: the rays, and the most light that is missing.
/// println!("{both}");
/// # Ok::<(), reflet::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
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
    #[cfg_attr(feature = "defmt", defmt(Display2Format))]
    pub cut_off: Unit,
    /// Largest component of any colour of the scene.
    #[cfg_attr(feature = "defmt", defmt(Display2Format))]
    pub(super) brightest: Brightness,
}

impl Report {
    /// Report on an empty picture: no rays, and no path cut off.
    pub const NONE: Self = Self {
        rays: 0,
        cut_off: Unit::ZERO,
        brightest: Brightness::ZERO,
    };

    /// Returns the report on two parts together: the sum of the rays, the larger `cut_off`.
    #[must_use]
    pub fn merge(self, other: Self) -> Self {
        Self {
            rays: self.rays + other.rays,
            cut_off: self.cut_off.max(other.cut_off),
            brightest: self.brightest.max(other.brightest),
        }
    }

    /// Returns the report on the rays that a tracer has followed.
    #[inline(always)]
    pub(super) fn of<W: World, K, Q>(tracer: &Tracer<'_, W, K, Q>) -> Self {
        Self {
            rays: tracer.rays.into(),
            cut_off: tracer.cut_off,
            brightest: tracer.world.parts().brightest,
        }
    }
}

/// Returns the most light that paths can lose that end with a throughput of at most `weight`, as a share
/// of white: at most 1, because a display shows nothing above white. Rounded up.
pub(crate) fn light_cut_off(weight: Unit, brightest: Brightness) -> Unit {
    // Q2.30 · Q6.26, rounded up.
    let weight = weight.to_bits().unsigned_abs();
    let brightest = brightest.to_bits().unsigned_abs();
    // Colours are stored in 255 of 256 parts; this scales back.
    let brightest = (u64::from(brightest) * 256).div_ceil(255);
    // Below 2³⁰ · 2³².
    let bound = (u64::from(weight) * brightest).div_ceil(1 << 26);
    Unit::from_bits(signed(narrowed_unsigned(bound.min(1 << 30))))
}

/// Writes the number of rays and the most light that is missing in a traced pixel, in levels of 255,
/// rounded up to tenths.
///
/// The light is that of [`Rows::cut_off_bound`](crate::Rows::cut_off_bound): `cut_off` times the brightest
/// colour of the scene. Less than one level changes no traced pixel by more than one level.
impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { rays, .. } = self;
        if self.cut_off == Unit::ZERO {
            return write!(f, "{rays} rays, no reflection cut off");
        }
        let bound = light_cut_off(self.cut_off, self.brightest);
        // At most 2550.
        let tenths = (u64::from(bound.to_bits().unsigned_abs()) * 2550).div_ceil(1 << 30);
        let (levels, rest) = (tenths / 10, tenths % 10);
        write!(
            f,
            "{rays} rays, reflections cut off: at most {levels}.{rest} of 255 levels missing"
        )
    }
}

#[cfg(test)]
mod tests;
