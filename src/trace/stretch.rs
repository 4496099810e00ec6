//! Whether all paths between two traced ones surely meet the same shapes, lit by the same lights.
//!
//! It is known for the first hit, and for the second if a plane mirrored the path: these rays start at one
//! eye and lie in one plane. docs/internals/edges.md has the proof.

use super::origin::Origin;
use super::shown::shown;
use super::stops::Stop;
use super::{Stops, Tracer};
use crate::accel::stretch::{Body, Chord, Stretch};
use crate::accel::{LitStretch, Window, World, is_clear_way};
use crate::number::Unit;
use crate::qualities::Quality;
use crate::ray::ScaledPoint;
use crate::scene::access::ShapeId;
use crate::scene::shape_set::ShapeSet;
use crate::scene::surface::checker_of;
use crate::shade::Samples;
use crate::shade::highlight::sealed::Shading;
use crate::shape::plane::PreparedPlane;
use crate::shape::rays::Rays;

/// Pixels between two traced ones: the window of the row, and the columns of the two.
pub(crate) type Between<'a> = (&'a Window, [u32; 2]);

/// Largest change of a direction for which three pixels show how colours change: about 20 degrees. The direction is the
/// normal, or leads to a light, to the eye or into the sky. Five pixels show changes of up to 60 degrees.
pub(super) const LARGEST_TURN: Unit = Unit::from_bits(3 << 27);

/// How much is proved of the paths of a stretch. It holds for each part of the stretch, too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress {
    /// Number of hits that are proved.
    hits: usize,
    /// Of the next hit, 0 if nothing is proved, else 1 + the number of lights.
    pub(super) steps: usize,
    /// The shapes that may hide points of the next hit from its next light, if that light is far.
    pub(super) suspects: ShapeSet,
    /// Number of pixels that show how the colours of the proved hits change.
    pub(crate) samples: Samples,
    /// The proved hit at which the paths show several cells of a plane's checker.
    pub(crate) cells: Option<usize>,
    /// The last column before a shape that may come to the front, if the last proof failed because of it.
    pub(super) border: Option<u32>,
}

impl Progress {
    /// Nothing is proved.
    pub(crate) const NONE: Self = Self {
        hits: 0,
        steps: 0,
        suspects: *ShapeSet::ALL,
        samples: Samples::Three,
        cells: None,
        border: None,
    };
}

impl<'a, W: World, K: Shading, Q: Quality> Tracer<'a, W, K, Q> {
    /// Tests whether all paths between two traced ones surely meet the same shapes, lit by the same lights, as
    /// far as the paths have known bounds. The two have equal signatures. `proved` is known before, and gets
    /// what is proved now.
    #[inline(never)]
    pub(crate) fn is_steady(
        &mut self,
        between: Between<'_>,
        ends: [&Stops; 2],
        proved: &mut Progress,
    ) -> bool {
        let parts = self.world.parts();
        let Some(eye) = self.culling.eye() else {
            return false;
        };
        let mut origin = Origin::camera(eye);
        let [start, end] = ends.map(Stops::all);
        for (first, last) in start.iter().zip(end) {
            if first.shape != last.shape || first.is_inside != last.is_inside {
                return false;
            }
            if origin.level == proved.hits {
                match self.keeps_shape(between, &origin, [first, last], proved) {
                    Err(steps) => {
                        proved.steps = steps;
                        return false;
                    }
                    Ok(true) => {}
                    Ok(false) => proved.cells = Some(origin.level),
                }
                (proved.hits, proved.steps) = (proved.hits + 1, 0);
            }
            let plane = parts.plane(first.shape);
            let Some(plane) = plane.filter(|plane| self.mirrors(plane)) else {
                return true;
            };
            // A far mirror shows near shapes as a near one does: the image of the eye is near. Rays that a second mirror
            // sends on from a far point have no known bounds.
            let is_near = origin.level == 0 || first.place.is_near() && last.place.is_near();
            let image = origin.mirrored((first.shape, plane), parts.epsilon);
            let Some(image) = image.filter(|_| is_near) else {
                return false;
            };
            origin = image;
        }
        // All hits that can be seen are stored, or the path has no known bounds.
        true
    }

    /// Tests whether paths go on after a plane.
    #[inline(always)]
    fn mirrors(&self, plane: &PreparedPlane) -> bool {
        let is_mirror = || self.world.parts().material(plane.material).mirrors();
        K::REFLECTS && W::NEEDS.plane_mirrors && is_mirror()
    }

    /// Tests whether all rays between two hit the same shape, lit by the same lights, and whether they hit one cell of its
    /// checker. `proved.steps` are proved before. Returns how many are if not all are.
    fn keeps_shape(
        &mut self,
        between: Between<'_>,
        origin: &Origin<'_>,
        stops: [&Stop; 2],
        proved: &mut Progress,
    ) -> Result<bool, usize> {
        let steps = proved.steps;
        let [first, _] = stops;
        if first.shape == ShapeId::NONE {
            return sure(self.keeps_none(between, origin, stops, proved), 0).map(|()| true);
        }
        let Some(shown) = shown(self.world, origin.eye, origin.row, stops) else {
            return Err(steps);
        };
        let LitStretch { bulge, ends, .. } = shown.lit;
        let aside = if bulge > 0 { bulge + 8 } else { 0 };
        let is_one_cell = !W::NEEDS.checkers || self.is_one_cell(first.shape, ends, aside);
        // Cells may differ at one hit of the paths, on a plane.
        let is_plane = || self.world.parts().plane(first.shape).is_some();
        if !(is_one_cell || proved.cells.is_none() && is_plane()) {
            return Err(steps);
        }
        let keeps = steps > 0
            || !self.world.parts().has_bounded()
            || if W::NEEDS.facing_mirrors && origin.level > 1 {
                shown.ball.is_some() && is_clear_way(self.world, origin.eye, &shown.lit)
            } else {
                self.keeps_front(between, origin, (first.shape, shown.chord()), proved)
            };
        sure(keeps, 0)?;
        self.keeps_lights(&shown, proved).map(|()| is_one_cell)
    }

    /// Tests whether all rays between two that hit nothing hit nothing, and show a sky that can be interpolated.
    fn keeps_none(
        &mut self,
        between: Between<'_>,
        origin: &Origin<'_>,
        stops: [&Stop; 2],
        proved: &mut Progress,
    ) -> bool {
        if self.has_sky() {
            let rays = Rays::new(ScaledPoint::ORIGIN, stops.map(|stop| stop.place));
            let turn = rays.turn;
            if turn > LARGEST_TURN || !self.world.parts().keeps_discs(rays.ends, turn) {
                return false;
            }
        }
        if !W::NEEDS.facing_mirrors || origin.level < 2 {
            return self.keeps_front(between, origin, (ShapeId::NONE, None), proved);
        }
        let beyond = LitStretch {
            shape: ShapeId::NONE,
            is_hollow: false,
            bulge: 0,
            slack: 0,
            ends: stops.map(|stop| stop.place),
        };
        is_clear_way(self.world, origin.eye, &beyond)
    }

    /// Tests whether no other shape comes in front of the one that is shown, directly or in one plane. Notes in `proved`
    /// where one that may begins or ends.
    #[inline(never)]
    pub(super) fn keeps_front(
        &mut self,
        (window, columns): Between<'_>,
        origin: &Origin<'_>,
        (shape, chord): (ShapeId, Option<Chord>),
        proved: &mut Progress,
    ) -> bool {
        let parts = self.world.parts();
        let ball = || parts.ball(shape.index()).map(|(ball, _)| Body::Ball(ball));
        let body = parts.plane(shape).map(Body::Plane).or_else(ball);
        let stretch = Stretch {
            columns,
            shape,
            body: body.unwrap_or(Body::None),
            chord,
            eye: origin.eye,
            mirror: origin.mirror.map(|(_, plane)| plane),
        };
        let kept = (self.culling).keeps(self.world, origin.mirror, window, &stretch);
        proved.border = kept.err().flatten();
        kept.is_ok()
    }

    /// Tests whether a stretch of a shape lies in one cell of its material's checker. Its points are at most `aside` steps off
    /// the straight line between its ends. Cells are convex, so a flat one does if its ends do.
    fn is_one_cell(&self, shape: ShapeId, ends: [ScaledPoint; 2], aside: i32) -> bool {
        checker_of(self.world, shape).is_none_or(|checker| checker.is_one_cell(ends, aside))
    }
}

/// Returns an error with the number of steps before if a step is not proved.
pub(super) fn sure(is_proved: bool, steps: usize) -> Result<(), usize> {
    if is_proved { Ok(()) } else { Err(steps) }
}
