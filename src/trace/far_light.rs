//! Up to which column the far lights surely shine alike on a plane.

use super::stops::Stop;
use super::{PathQuality, Progress, Tracer};
use crate::accel::World;
use crate::accel::shadows::{self, Cast, Shadow};
use crate::scene::access::ShapeId;
use crate::shade::highlight::sealed::Shading;

impl<W: World, K: Shading, Q: PathQuality> Tracer<'_, W, K, Q> {
    /// Tests whether no shadow of a far light begins or ends between two columns, if they show a plane at this level of a
    /// path. Notes in `proved` where one does.
    #[inline(always)]
    pub(super) fn keeps_far_lights(
        &mut self,
        columns: [u32; 2],
        (stops, level): (&[Stop], usize),
        proved: &mut Progress,
    ) -> bool {
        let until = self.far_lights_until(columns, stops, level);
        let is_kept = until.is_some_and(|until| until >= columns[1]);
        if !is_kept {
            proved.border = until;
        }
        is_kept
    }

    /// Returns the last column from the first of two up to the last to which no shadow of a far light begins or ends, if
    /// they show a plane; else the last. `None` if that is not known. `stops` are the hits of the first column's path;
    /// `level` is the one that is shown.
    #[inline(always)]
    pub(super) fn far_lights_until(
        &mut self,
        columns: [u32; 2],
        stops: &[Stop],
        level: usize,
    ) -> Option<u32> {
        // A scene without far lights links no code for them.
        match W::NEEDS.far_lights && W::NEEDS.shadows && K::SHADOWS {
            true => self.each_far_light_until(columns, stops, level),
            false => Some(columns[1]),
        }
    }

    #[inline(never)]
    fn each_far_light_until(
        &mut self,
        [first, last]: [u32; 2],
        stops: &[Stop],
        level: usize,
    ) -> Option<u32> {
        let parts = self.world.parts();
        let (shown, mirrors) = stops.get(..=level)?.split_last()?;
        let Some(plane) = parts.plane(shown.shape) else {
            return Some(last);
        };
        let pencil = mirrors.iter().fold(self.culling.pencil(), |pencil, stop| {
            pencil?.mirrored(parts.plane(stop.shape)?, parts.epsilon)
        })?;
        let mut until = last;
        for (index, light) in parts.lights.iter().enumerate() {
            if light.place.is_near() || self.visibility.is_hidden(index) {
                continue;
            }
            if !self.visibility.is_open(index) {
                return None;
            }
            let shadow = (&pencil, plane, light.place);
            until = until.min(self.shines_until((mirrors, shown.shape, index), shadow, first)?);
        }
        Some(until)
    }

    /// Returns the last column to which a light surely shines on a plane as in `column`, `None` if that is not known.
    /// `mirrors` are the hits before the plane. Behind at most one mirror the shadows of the whole row are kept.
    fn shines_until(
        &mut self,
        (mirrors, plane, light): (&[Stop], ShapeId, usize),
        shadow: Shadow<'_>,
        column: u32,
    ) -> Option<u32> {
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
        match cast.zip(self.shadows.as_deref_mut()) {
            Some((cast, shadows)) => shadows.of(self.world, cast, shadow).until(column),
            None => {
                // If only the column itself is known, a border comes next or there are more than can be noted.
                let borders = shadows::borders_from(column, self.world, shadow);
                borders.until(column).filter(|until| *until > column)
            }
        }
    }
}
