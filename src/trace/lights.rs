//! Whether the lights surely shine alike on a stretch of pixels, and how many pixels show how its colours change.
//! docs/internals/edges.md has the proofs.

use super::shown::Shown;
use super::stretch::{LARGEST_TURN, sure};
use super::{Progress, Tracer};
use crate::accel::light_occluders::LightOccluders;
use crate::accel::{World, far_lights_all, lights_all};
use crate::number::{Brightness, Unit};
use crate::qualities::Quality;
use crate::ray::ScaledPoint;
use crate::scene::shape_set::ShapeSet;
use crate::shade::Samples;
use crate::shade::highlight::sealed::Shading;
use crate::shape::rays::Rays;

impl<W: World, K: Shading, Q: Quality> Tracer<'_, W, K, Q> {
    /// Tests whether each light surely shines on a whole stretch or on nothing of it. Raises `proved.samples`
    /// to the number of pixels that show how it shines. If a light is not proved, returns how many steps are; if that
    /// light is far, `proved.suspects` are the shapes that may hide it.
    pub(super) fn keeps_lights(
        &self,
        shown: &Shown<'_>,
        proved: &mut Progress,
    ) -> Result<(), usize> {
        let material = shown.material;
        let is_blank = W::HAS_BLANK && !material.has_own();
        if K::REFLECTS && (material.mirror == Unit::ONE || is_blank) {
            return Ok(());
        }
        let lights = self.world.tables().light_occluders;
        let first = proved.steps.saturating_sub(1);
        for (index, light) in lights.iter().enumerate().skip(first) {
            if self.visibility.is_hidden(index) {
                continue;
            }
            let own = self.samples(shown, (light, index), &mut proved.suspects);
            sure(own < Samples::All, 1 + index)?;
            proved.samples = own.max(proved.samples);
            proved.suspects = *ShapeSet::ALL;
        }
        Ok(())
    }

    /// Returns how many pixels show how a light shines on a stretch: all, unless it surely shines on the whole stretch
    /// or on nothing of it.
    fn samples(
        &self,
        shown: &Shown<'_>,
        (light, index): (&LightOccluders<W::Room>, usize),
        suspects: &mut ShapeSet,
    ) -> Samples {
        let place = light.light().place;
        let ([first, last], [one, other]) = (shown.lit.ends, shown.normals);
        let faces = |end: ScaledPoint, normal| end.to(place).0.dot(normal) > 0;
        let is_facing = faces(first, one);
        // What is flat and faces away at both ends faces away between.
        let is_flat = shown.turn == Unit::ZERO;
        if is_facing != faces(last, other) {
            return Samples::All;
        }
        if !is_facing && is_flat {
            return Samples::Three;
        }
        let rays = Rays::new(place, shown.lit.ends);
        let has_highlight = W::NEEDS.highlights && shown.material.specular > Brightness::ZERO;
        if rays.turn >= Unit::ONE
            || shown.turn > LARGEST_TURN && shown.is_grazed()
            || has_highlight && !is_flat && shown.may_turn_away(&rays)
        {
            return Samples::All;
        }
        let samples = if rays.turn.max(shown.turn) > LARGEST_TURN {
            Samples::Five
        } else {
            Samples::Three
        };
        match is_facing.then(|| self.shines((light, index), (shown, &rays), suspects)) {
            Some(None) => Samples::All,
            Some(Some(true)) if has_highlight => samples.max(shown.highlight_samples::<K>(&rays)),
            _ => samples,
        }
    }

    /// Returns whether a light shines on all points of a stretch that faces it, or on none; `None` if that is not sure.
    #[inline(always)]
    fn shines(
        &self,
        (light, index): (&LightOccluders<W::Room>, usize),
        (shown, rays): (&Shown<'_>, &Rays),
        suspects: &mut ShapeSet,
    ) -> Option<bool> {
        let world = self.world;
        if !(K::SHADOWS && W::NEEDS.shadows) {
            return Some(true);
        }
        let lamp = light.light();
        if W::NEEDS.far_lights && !(W::NEEDS.near_lights && lamp.place.is_near()) {
            let towards = rays.ends.map(|end| lamp.sun().unwrap_or(end.reversed()));
            let is_open = self.visibility.is_open(index);
            return is_open.then(|| far_lights_all(world, &shown.lit, towards, suspects))?;
        }
        let is_clear = self.visibility.is_clear(index);
        is_clear.then(|| lights_all::<W, Q>(world, (light, index), &shown.lit, rays))?
    }
}
