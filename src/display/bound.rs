//! Floor 8: the bound of the error that ended paths cause in a picture, computed from its report.

use crate::accel::drawable::Drawable;
use crate::number::{Unit, narrowed_unsigned, signed};
use crate::render::{Report, Rows};
use crate::scene::access::SceneAccess;

impl<S: Drawable, Q, K> Rows<'_, S, Q, K> {
    /// Returns the largest error that the reflections left out cause in a traced pixel, as a share of
    /// white, 0 to 1.
    ///
    /// The light after the last reflection of a path is at most the path's throughput Π αₖ times the
    /// brightest colour that anything in the scene can have. The report holds the largest such
    /// throughput. The bound is computed in integers, rounded up to 2⁻³⁰, and at most 1, because a
    /// display shows nothing above white. Materials that no shape uses count, too.
    ///
    /// The bound does not cover interpolated pixels (see [`crate::quality::Quality::TOLERANCE`]) or
    /// rounding. `docs/error-time` in the repository shows the whole error for every built-in scene.
    ///
    /// ```
    /// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
    /// use reflet::scenes::{BuiltIn, Mirror2};
    ///
    /// let bound = |reflections| {
    ///     let frame = Mirror2::frame(&Mirror2::CAMERA).reflections(reflections);
    ///     let frame = frame.prepare(Size::new(32, 32));
    ///     let rows = frame.on(&Mirror2).unwrap();
    ///     let mut row = [Rgb888::BLACK; 32];
    ///     rows.cut_off_bound(&rows.row(16, 0, &mut row))
    /// };
    /// assert!(bound(8) < bound(2));
    /// ```
    #[must_use]
    pub fn cut_off_bound(&self, report: &Report) -> Unit {
        // Q2.30 · Q6.26, rounded up.
        let weight = report.cut_off.to_bits().unsigned_abs();
        let brightest = self.world().parts().brightest.to_bits().unsigned_abs();
        // Colours are stored in 255 of 256 parts; this scales back.
        let brightest = (u64::from(brightest) * 256).div_ceil(255);
        // Below 2³⁰ · 2³².
        let bound = (u64::from(weight) * brightest).div_ceil(1 << 26);
        Unit::from_bits(signed(narrowed_unsigned(bound.min(1 << 30))))
    }
}
