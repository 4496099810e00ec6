//! The column at which a stretch is best divided. A wrong column costs time and changes nothing else: both parts are
//! treated as any stretch is.

use super::stretch::Between;
use super::{PathQuality, Progress, Stops, Tracer};
use crate::accel::World;
use crate::shade::highlight::sealed::Shading;

impl<W: World, K: Shading, Q: PathQuality> Tracer<'_, W, K, Q> {
    /// Returns the last column before a shape ends or begins between two traced pixels: one that kept `proved` from
    /// going on, one that one of the pixels shows and the other does not, directly or in one flat mirror. `None` if
    /// no such column is known.
    #[inline(never)]
    pub(crate) fn border(
        &mut self,
        between: Between<'_>,
        ends: [&Stops; 2],
        proved: &Progress,
    ) -> Option<u32> {
        let [first, last] = between.1;
        if let Some(border) = proved.border.filter(|it| (first..last).contains(it)) {
            return Some(border);
        }
        let parts = self.world.parts();
        if !parts.has_bounded() {
            return None;
        }
        let [start, end] = ends.map(Stops::all);
        let mut mirror = None;
        for (level, (one, other)) in start.iter().zip(end).take(2).enumerate() {
            if one.shape != other.shape {
                let shapes = [one.shape, other.shape];
                return self.culling.border(self.world, mirror, between, shapes);
            }
            let until = self.far_lights_until(between.1, start, level);
            if until < last {
                return Some(until);
            }
            mirror = Some((one.shape, parts.plane(one.shape)?));
        }
        None
    }
}
