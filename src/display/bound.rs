//! Floor 8: what a picture can be off by where its paths were ended, from its report.

use crate::accel::drawable::Drawable;
use crate::number::{Unit, narrowed_unsigned, signed};
use crate::render::{Report, Rows};
use crate::scene::access::SceneAccess;

impl<S: Drawable, Q, K> Rows<'_, S, Q, K> {
    /// How far a pixel of this picture that was traced can be from one whose paths are followed for
    /// ever, on account of the reflections that were left out, as a share of white: 0 to 1.
    ///
    /// What follows the last reflection adds up to no more than the path's weight Π αₖ times the
    /// brightest colour that anything in the scene can have; the largest such weight is the
    /// report's. In integers; rounded up to 2⁻³⁰, and 1 where it is more: a display shows nothing above
    /// white. Materials that no shape has count, too.
    ///
    /// Of the pixels between traced ones (see [`crate::quality::Quality::STRIDE`]) it says nothing; what they
    /// and rounding add does not depend on the number of reflections alone: `docs/error-time` has it
    /// for every built-in scene.
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
        // What all colours are 255 parts of.
        let brightest = (u64::from(brightest) * 256).div_ceil(255);
        // Below 2³⁰ · 2³².
        let bound = (u64::from(weight) * brightest).div_ceil(1 << 26);
        Unit::from_bits(signed(narrowed_unsigned(bound.min(1 << 30))))
    }
}
