//! What a ray hits first, as a camera ray or after reflections.

use super::Tracer;
use crate::accel::{Beside, Window, World, nearest_ahead};
use crate::qualities::Quality;
use crate::ray::{Ray, ScaledPoint, ScaledRay};
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE, nearest_listed, nearest_of};
use crate::scene::query::{located, nearest_hit_by};
use crate::scene::shape_set::ShapeSet;
use crate::scene::{FEW, Surface, planes};
use crate::shade::highlight::sealed::Shading;

/// Where a path starts in a row of pixels.
pub(crate) enum Pixel<'a> {
    /// Through the centre of the pixel in a column of a window.
    Center(&'a Window, u32),
    /// Beside the centre of the pixel in a column. What such rays can hit is kept.
    Beside(&'a mut Beside, u32),
}

/// The latest reflection of a path, and the number of reflections.
pub(super) struct Bounce {
    /// Number of reflections up to now.
    pub(super) count: u32,
    /// The shape that mirrored the ray.
    pub(super) mirror: ShapeId,
    /// The shape that the ray skips: the mirror, or none if the ray can hit the mirror again.
    pub(super) skip: ShapeId,
}

impl Bounce {
    /// No reflection: a ray from the camera.
    pub(super) const NONE: Self = Self {
        count: 0,
        mirror: ShapeId::NONE,
        skip: ShapeId::NONE,
    };
}

impl<'a, W: World, K: Shading, Q: Quality> Tracer<'a, W, K, Q> {
    /// Returns the surface that a ray hits first, `None` if it hits nothing. `pixel` is that of the path.
    #[inline(always)]
    pub(super) fn surface(
        &mut self,
        pixel: &mut Pixel<'_>,
        ray: &ScaledRay,
        bounce: &Bounce,
    ) -> Option<Surface<'a>> {
        let (world, skip) = (self.world, bounce.skip);
        let (at, shape) = if Self::IS_PLAIN {
            self.plain_hit(ray, bounce)
        } else {
            let hit = self.near_hit(pixel, ray, bounce);
            if Q::IS_PRECISE {
                located::<W, true>(world, ray, skip, hit)
            } else {
                located::<W, false>(world, ray, skip, hit)
            }
        }?;
        Surface::new(world, at, shape, ray.direction())
    }

    /// Returns the first hit of a ray on the plain path. A ray of the camera tests the bounded shapes of the
    /// row's list if the quality has one. Every other ray tests all.
    #[inline(always)]
    fn plain_hit(&self, ray: &ScaledRay, bounce: &Bounce) -> Option<(ScaledPoint, ShapeId)> {
        let (world, skip) = (self.world, bounce.skip);
        let is_listed = Q::CULLING.lists && world.parts().bounded() > FEW;
        let candidates = if is_listed && bounce.count == 0 { self.list } else { *ShapeSet::ALL };
        let nearest = |ray: &Ray| {
            if is_listed {
                nearest_listed(world, &candidates, ray, skip)
            } else {
                nearest_of(world, (ray, NOWHERE), skip)
            }
        };
        // Every pixel is traced, so nothing but the surface itself asks where it is.
        nearest_hit_by(world, ray, skip, (W::NEEDS.places(), nearest))
    }

    /// Returns the first hit of a ray in the near region. Returns [`Hit::BEYOND`] for a ray that starts
    /// far away.
    #[inline(always)]
    fn near_hit(&mut self, pixel: &mut Pixel<'_>, ray: &ScaledRay, bounce: &Bounce) -> Hit {
        if !ray.from().is_near() {
            return Hit::BEYOND;
        }
        let (world, ray, skip) = (self.world, &ray.ray, bounce.skip);
        let parts = world.parts();
        let is_alone = parts.bounded() == 1 && skip == ShapeId::at(0);
        let bounded = if is_alone || !parts.has_bounded() {
            Hit::NONE
        } else {
            let plane = if W::NEEDS.plane_mirrors { parts.plane(skip) } else { None };
            match (pixel, bounce.count, plane) {
                (Pixel::Center(_, column), 0, _) => {
                    // No plane lies before a known ball.
                    if let Some(hit) = self.known_hit(ray) {
                        return hit;
                    }
                    self.culling.direct(world, *column, ray)
                }
                (Pixel::Center(window, column), 1, Some(plane)) => {
                    let pixel = (*window, *column);
                    self.culling.mirrored(world, (skip, plane), pixel, ray)
                }
                (Pixel::Beside(known, column), 0, _)
                | (Pixel::Beside(known, column), 1, Some(_)) => {
                    self.culling.beside(world, known, (skip, *column), ray)
                }
                _ => nearest_ahead::<W, Q>(world, ray, (bounce.mirror, skip)),
            }
        };
        planes::nearest(world, ray, skip, bounded)
    }
}
