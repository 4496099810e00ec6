//! The two questions that a ray asks a scene, in the plain way: what it hits first, and whether a
//! light is occluded.

use super::access::{SceneAccess, ShapeId};
use super::nearest::{Hit, NOWHERE, any_blocks, nearest_of};
use super::shape_set::ShapeSet;
use super::{far, planes};
use crate::number::Length;
use crate::ray::{PathSignature, ScaledPoint, ScaledRay};

/// Where a ray first hits a shape, and which. Skips the shape whose outside the ray leaves.
#[inline(always)]
pub(crate) fn nearest_hit<W: SceneAccess, const PRECISE: bool>(
    world: &W,
    ray: &ScaledRay,
    skip: ShapeId,
    signature: &mut PathSignature,
) -> Option<(ScaledPoint, ShapeId)> {
    let hit = match ray.from().is_near() {
        true => {
            let bounded = match world.parts().has_bounded() {
                true => nearest_of(world, ShapeSet::ALL, (&ray.ray, NOWHERE), skip, signature),
                false => Hit::NONE,
            };
            planes::nearest(world, &ray.ray, skip, bounded)
        }
        false => Hit::BEYOND,
    };
    far::located::<W, PRECISE>(world, ray, skip, hit, signature)
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
    if scale != 0 {
        return far::occluded(world, ray, skip, (light, distance, scale));
    }
    let ray = &ray.ray;
    let reach = Length::from_bits((distance.to_bits() - world.parts().epsilon.to_bits()).max(0));
    planes::others(world, skip).any(|(_, plane)| plane.blocks(ray, reach))
        || any_blocks(world, candidates, ray, skip, reach)
}

#[cfg(test)]
mod tests;
