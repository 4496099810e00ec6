//! Whether a far light shines alike on a stretch of a plane.

use super::stops::Stop;
use super::{PathQuality, Tracer};
use crate::accel::World;
use crate::accel::shadows::{self, Cast, Pencil};
use crate::ray::ScaledPoint;
use crate::scene::access::ShapeId;
use crate::shade::highlight::sealed::Shading;
use crate::shape::plane::PreparedPlane;

impl<W: World, K: Shading, Q: PathQuality> Tracer<'_, W, K, Q> {
    /// Tests whether no shadow of a far light begins or ends between two columns, if they show a plane. `stops`
    /// are the hits of a path; `level` is the one that is shown.
    #[inline(always)]
    pub(super) fn keeps_far_lights(
        &mut self,
        columns: [u32; 2],
        stops: &[Stop],
        level: usize,
    ) -> bool {
        // A scene without far lights links no code for them.
        let has_some = W::NEEDS.far_lights && W::NEEDS.shadows && K::SHADOWS;
        !has_some || self.keeps_each_far_light(columns, stops, level)
    }

    #[inline(never)]
    fn keeps_each_far_light(
        &mut self,
        [first, last]: [u32; 2],
        stops: &[Stop],
        level: usize,
    ) -> bool {
        let parts = self.world.parts();
        let Some((shown, mirrors)) = stops.get(..=level).and_then(|stops| stops.split_last())
        else {
            return false;
        };
        let Some(plane) = parts.plane(shown.shape) else {
            return true;
        };
        let pencil = mirrors.iter().fold(self.culling.pencil(), |pencil, stop| {
            pencil?.mirrored(parts.plane(stop.shape)?, parts.epsilon)
        });
        let Some(pencil) = pencil else {
            return false;
        };
        let lights = parts.lights.iter().map(|light| light.place);
        lights.enumerate().all(|(index, light)| {
            let is_near_or_hidden = light.is_near() || self.visibility.is_hidden(index);
            is_near_or_hidden
                || self.visibility.is_open(index) && {
                    let shadow = (&pencil, plane, light);
                    self.shines_until((mirrors, shown.shape, index), shadow, first) >= last
                }
        })
    }

    /// Returns the last column to which a light surely shines on a plane as in `column`. `mirrors` are the hits before
    /// the plane. Behind at most one mirror the shadows of the whole row are kept.
    fn shines_until(
        &mut self,
        (mirrors, plane, light): (&[Stop], ShapeId, usize),
        shadow: (&Pencil, &PreparedPlane, ScaledPoint),
        column: u32,
    ) -> u32 {
        let mirror = match mirrors {
            [] => Some(ShapeId::NONE),
            [only] => Some(only.shape),
            _ => None,
        };
        let cast = mirror.map(|mirror| Cast {
            mirror,
            plane,
            light,
        });
        let kept = cast.zip(self.shadows.as_deref_mut());
        let kept = kept.and_then(|(cast, shadows)| shadows.of(self.world, cast, shadow));
        let (pencil, plane, light) = shadow;
        match kept.and_then(|borders| borders.until(column)) {
            Some(until) => until,
            None => shadows::until(self.world, pencil, plane, light, column),
        }
    }
}
