//! A column between two traced ones at which what their paths show changes. It need not be right: nothing depends on
//! it but how a stretch is divided.

use super::stretch::Between;
use super::{PathQuality, Stops, Tracer};
use crate::accel::World;
use crate::shade::highlight::sealed::Shading;

impl<W: World, K: Shading, Q: PathQuality> Tracer<'_, W, K, Q> {
    /// Returns the last column before a border at which what two paths show changes, if one is known between
    /// them: the end of a shape that the first shows, or the start of one that the other shows.
    #[inline(never)]
    pub(crate) fn border(&mut self, between: Between<'_>, ends: [&Stops; 2]) -> Option<u32> {
        let parts = self.world.parts();
        if !parts.has_bounded() {
            return None;
        }
        let [start, end] = ends.map(Stops::all);
        let mut mirror = None;
        for (first, last) in start.iter().zip(end).take(2) {
            if first.shape != last.shape {
                let shapes = [first.shape, last.shape];
                return self.culling.border(self.world, mirror, between, shapes);
            }
            mirror = Some((first.shape, parts.plane(first.shape)?));
        }
        None
    }
}
