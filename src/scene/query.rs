//! The two questions that a ray asks a scene, in the plain way: what it hits first, and whether a
//! light is occluded. Rays start and end anywhere.

use super::access::{SceneAccess, ShapeId};
use super::far::{between, into_ball, place_along};
use super::nearest::{Hit, NOWHERE, any_blocks, nearest_of};
use super::planes;
use super::shape_set::ShapeSet;
use crate::number::{Length, unsigned};
use crate::ray::{PathSignature, ScaledPoint, ScaledRay};
use crate::shape::plane::NOT_MET;

/// Where a ray first hits a shape, and which. Skips the shape that the ray leaves.
#[inline(always)]
pub(crate) fn nearest_hit<W: SceneAccess>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
    signature: &mut PathSignature,
) -> Option<(ScaledPoint, ShapeId)> {
    let (mut distance, mut shape) = (NOT_MET, ShapeId::NONE);
    for (id, plane) in planes::others(world, skip) {
        let own = plane.intersect_far(ray);
        if own < distance {
            (distance, shape) = (own, id);
        }
    }
    if world.parts().has_bounded() {
        let start = match ray.from().is_near() {
            true => Some((ray.ray, 0)),
            false => into_ball(ray),
        };
        if let Some((ray, skipped)) = start {
            let hit = nearest_of(world, ShapeSet::ALL, (&ray, NOWHERE), skip, signature);
            let own = skipped + u64::from(unsigned(hit.distance.to_bits()));
            if hit.shape != ShapeId::NONE && own < distance {
                let at = ray.origin.along(ray.direction, hit.distance);
                return Some((ScaledPoint::new(at, 0), hit.shape));
            }
        }
    }
    if distance == NOT_MET {
        return None;
    }
    Some((place_along(ray, distance)?, shape))
}

/// The same for a ray whose near hit is known; only a plane can be hit further out.
#[inline(always)]
pub(crate) fn located<W: SceneAccess, const PRECISE: bool>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
    hit: Hit,
    signature: &mut PathSignature,
) -> Option<(ScaledPoint, ShapeId)> {
    if hit.shape == ShapeId::NONE {
        return None;
    }
    if hit.shape != ShapeId::BEYOND {
        let (origin, direction) = (ray.ray.origin, ray.direction());
        let at = match PRECISE {
            true => origin.precisely_along(direction, hit.distance),
            false => origin.along(direction, hit.distance),
        };
        if let Some(at) = ScaledPoint::near(at) {
            return Some((at, hit.shape));
        }
    }
    // Taken apart, or what is near is kept in memory, too.
    let (at, shape) = far_hit(world, ray, skip, signature)?;
    Some((at, shape))
}

/// Out of the way of near hits.
#[cold]
#[inline(never)]
fn far_hit<W: SceneAccess>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
    signature: &mut PathSignature,
) -> Option<(ScaledPoint, ShapeId)> {
    nearest_hit(world, ray, skip, signature)
}

/// Whether a ray hits anything more than epsilon before a light that is `distance` · 2^`scale` steps
/// away. Planes are all asked, bounded shapes if they are `candidates`.
pub(crate) fn occluded<W: SceneAccess>(
    world: &W,
    candidates: &ShapeSet,
    ray: &ScaledRay,
    skip: ShapeId,
    (light, distance, scale): (ScaledPoint, Length, u32),
) -> bool {
    let epsilon = world.parts().epsilon;
    let own = epsilon.to_bits() >> scale.min(31);
    let reach = Length::from_bits((distance.to_bits() - own).max(0));
    if planes::others(world, skip).any(|(_, plane)| plane.blocks(ray, reach, scale)) {
        return true;
    }
    if scale == 0 {
        return any_blocks(world, candidates, &ray.ray, skip, reach);
    }
    between(ray, (light, reach, scale), epsilon)
        .is_some_and(|(ray, reach)| any_blocks(world, ShapeSet::ALL, &ray, skip, reach))
}

#[cfg(test)]
mod tests;
