//! Floor 8: the bound of the error that ended paths cause in a picture, computed from its report.

use crate::accel::any_scene::AnyScene;
use crate::number::Unit;
use crate::render::{Report, Rows, light_cut_off};
use crate::scene::access::SceneAccess;

impl<S: AnyScene, Q, K> Rows<'_, S, Q, K> {
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
        light_cut_off(report.cut_off, self.world().parts().brightest)
    }
}
