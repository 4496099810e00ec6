//! Whether a far light shines alike on a stretch of a plane.

use super::stops::Stop;
use super::{PathQuality, Tracer};
use crate::accel::{World, shadows};
use crate::ray::ScaledPoint;
use crate::shade::highlight::sealed::Shading;
use crate::shape::plane::Side;

impl<W: World, K: Shading, Q: PathQuality> Tracer<'_, W, K, Q> {
    /// Tests whether no shadow of a far light begins or ends between two columns, if they show a plane. `stops`
    /// are the hits of a path; `level` is the one that is shown.
    #[inline(always)]
    pub(super) fn keeps_far_lights(&self, columns: [u32; 2], stops: &[Stop], level: usize) -> bool {
        // A scene without far lights links no code for them.
        let has_some = W::NEEDS.far_lights && W::NEEDS.shadows && K::SHADOWS;
        !has_some || self.keeps_each_far_light(columns, stops, level)
    }

    #[inline(never)]
    fn keeps_each_far_light(&self, [first, last]: [u32; 2], stops: &[Stop], level: usize) -> bool {
        let parts = self.world.parts();
        let Some((shown, mirrors)) = stops.get(..=level).and_then(|stops| stops.split_last())
        else {
            return false;
        };
        let Some(plane) = parts.plane(shown.shape) else {
            return true;
        };
        let mut pencil = self.culling.pencil();
        for stop in mirrors {
            let image = pencil.zip(parts.plane(stop.shape));
            pencil = image.and_then(|(pencil, mirror)| pencil.mirrored(mirror, parts.epsilon));
        }
        let lights = parts.lights.iter().map(|light| light.place);
        let mut lights = lights
            .enumerate()
            .filter(|(index, light)| !light.is_near() && !self.visibility.is_hidden(*index));
        lights.all(|(_, light)| {
            self.is_open(light)
                && pencil.is_some_and(|pencil| {
                    shadows::until(self.world, &pencil, plane, light, first) >= last
                })
        })
    }

    /// Tests whether no plane hides a light from a surface of the frame: it stands on the camera's side of each.
    fn is_open(&self, light: ScaledPoint) -> bool {
        let parts = self.world.parts();
        parts.planes.iter().all(|plane| {
            let side = plane.side(light, parts.epsilon);
            let is_apart = matches!(side, Side::Above | Side::Below);
            is_apart && side == plane.side(self.visibility.from, parts.epsilon)
        })
    }
}
