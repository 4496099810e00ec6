//! The two queries of a ray, answered without culling: what it hits first, and whether a light is
//! occluded. Rays may start and end anywhere.

use super::access::{SceneAccess, ShapeId};
use super::far::{between, into_ball, near_part, place_along};
use super::nearest::{Hit, NOWHERE, any_blocks, nearest_of};
use super::planes;
use super::shape_set::ShapeSet;
use crate::number::{Length, unsigned};
use crate::ray::{Ray, ScaledPoint, ScaledRay};
use crate::shape::plane::NOT_MET;

/// Returns the first hit of a ray: point and shape; `None` if nothing is hit. Skips the shape that the
/// ray leaves. Out of line, away from the code of near hits.
#[cold]
#[inline(never)]
pub(crate) fn nearest_hit<W: SceneAccess>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
) -> Option<(ScaledPoint, ShapeId)> {
    let nearest = |ray: &Ray| nearest_of(world, (ray, NOWHERE), skip);
    nearest_hit_by(world, ray, skip, (true, nearest))
}

/// Returns the first hit of a ray, as [`nearest_hit`] does. `nearest` returns the nearest hit of the
/// bounded shapes. It is given the near part of the ray. Unless `asks_place`, the place of a hit on a
/// plane is not computed: the start of the ray stands for it.
#[inline(always)]
pub(crate) fn nearest_hit_by<W: SceneAccess>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
    (asks_place, nearest): (bool, impl Fn(&Ray) -> Hit),
) -> Option<(ScaledPoint, ShapeId)> {
    let (mut distance, mut shape) = (NOT_MET, ShapeId::NONE);
    // Nothing compares the distance of an only plane.
    let asks_distance = asks_place || world.parts().planes.len() > 1;
    for (id, plane) in planes::others(world, skip) {
        let own = if asks_distance {
            plane.intersect_far(ray)
        } else if plane.approach_far(ray).is_some() {
            0
        } else {
            NOT_MET
        };
        if own < distance {
            (distance, shape) = (own, id);
        }
    }
    if world.parts().has_bounded() {
        let start = if ray.from().is_near() { Some((ray.ray, 0)) } else { into_ball(ray) };
        if let Some((ray, skipped)) = start {
            let hit = nearest(&ray);
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
    let at = if asks_place { place_along(ray, distance)? } else { ray.from() };
    Some((at, shape))
}

/// Returns the first hit of a ray whose near hit `hit` is known: point and shape; `None` if nothing is
/// hit. Beyond the near region only planes can be hit.
///
/// If `PRECISE`, the point is rounded to the nearest step.
#[inline(always)]
pub(crate) fn located<W: SceneAccess, const PRECISE: bool>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
    hit: Hit,
) -> Option<(ScaledPoint, ShapeId)> {
    if hit.shape == ShapeId::NONE {
        return None;
    }
    if hit.shape != ShapeId::BEYOND {
        let (origin, direction) = (ray.ray.origin, ray.direction());
        let at = if PRECISE {
            origin.precisely_along(direction, hit.distance)
        } else {
            origin.along(direction, hit.distance)
        };
        if let Some(at) = ScaledPoint::near(at) {
            return Some((at, hit.shape));
        }
    }
    // Unpacked and packed again, or the compiler keeps near hits in memory, too.
    nearest_hit(world, ray, skip)
}

/// Tests whether a shape occludes a light: whether the ray to the light hits a shape more than epsilon before it.
///
/// Skips the shape that the ray leaves. The light is `distance` · 2^`scale` steps away. All planes are
/// tested, and the bounded shapes among `candidates`; all bounded shapes if `scale` is not 0.
pub(crate) fn occluded<W: SceneAccess>(
    world: &W,
    candidates: &ShapeSet,
    ray: &ScaledRay,
    skip: ShapeId,
    light: (ScaledPoint, Length, u32),
) -> bool {
    let candidates = match light.2 {
        0 => candidates,
        _ => ShapeSet::ALL,
    };
    occluded_by(world, ray, skip, light, |ray, reach| {
        any_blocks(world, candidates, ray, skip, reach)
    })
}

/// Tests whether a plane occludes a light, or `blocks` says that a bounded shape does. It is given the near
/// part of the ray, and its length.
#[inline(always)]
pub(crate) fn occluded_by<W: SceneAccess>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
    (light, distance, scale): (ScaledPoint, Length, u32),
    blocks: impl Fn(&Ray, Length) -> bool,
) -> bool {
    let epsilon = world.parts().epsilon;
    let own = epsilon.to_bits() >> scale.min(31);
    let reach = Length::from_bits((distance.to_bits() - own).max(0));
    if planes::others(world, skip).any(|(_, plane)| plane.blocks(ray, reach, scale)) {
        return true;
    }
    if !world.parts().has_bounded() {
        return false;
    }
    if ray.from().is_near() {
        return blocks(&ray.ray, near_part(reach, scale));
    }
    between(ray, (light, reach, scale), epsilon).is_some_and(|(ray, reach)| blocks(&ray, reach))
}

#[cfg(test)]
mod tests;
