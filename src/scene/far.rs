//! Paths that start or end beyond the near region: planes near the horizon, distant lights and
//! cameras. Rare, so kept out of the way of the near ones.
//!
//! Planes are met with a distance of 62 bits. Spheres and cylinders lie in the ball, so a path
//! from far away is moved along itself to where it enters the ball and asks them from there.

use super::access::{SceneAccess, ShapeId};
use super::nearest::{Hit, NOWHERE, any_blocks, nearest_of};
use super::planes;
use super::shape_set::ShapeSet;
use crate::number::{Length, narrowed_unsigned, shifted, signed, square_root, unsigned, wide};
use crate::ray::{BALL, PathSignature, REACH, Ray, ScaledPoint, ScaledRay};
use crate::shape::plane::NOT_MET;

/// Places further out than this scale see the ball as a point and are not followed.
const FURTHEST_SCALE: u32 = 32;

/// The nearest plane of any distance below 2⁶² steps, and that distance; [`NOT_MET`] if there is none.
#[inline(always)]
fn nearest_plane<W: SceneAccess>(world: &W, path: &ScaledRay, skip: ShapeId) -> (u64, ShapeId) {
    let mut nearest = (NOT_MET, ShapeId::NONE);
    for (number, plane) in planes::others(world, skip) {
        let distance = plane.intersect_far(path);
        if distance < nearest.0 {
            nearest = (distance, number);
        }
    }
    nearest
}

/// What a path that has skip the shape `skip` meets first, wherever it starts, and where.
#[cold]
#[inline(never)]
pub(super) fn nearest<W: SceneAccess>(
    world: &W,
    path: &ScaledRay,
    skip: ShapeId,
    signature: &mut PathSignature,
) -> Option<(ScaledPoint, ShapeId)> {
    let (plane, shape) = nearest_plane(world, path, skip);
    if world.parts().has_bounded() {
        let start = match path.from().is_near() {
            true => Some((path.ray, 0)),
            false => into_ball(path),
        };
        if let Some((ray, skipped)) = start {
            let hit = nearest_of(world, ShapeSet::ALL, (&ray, NOWHERE), skip, signature);
            let distance = skipped + u64::from(unsigned(hit.distance.to_bits()));
            if hit.shape != ShapeId::NONE && distance < plane {
                let at = ray.origin.along(ray.direction, hit.distance);
                return Some((ScaledPoint::new(at, 0), hit.shape));
            }
        }
    }
    if plane == NOT_MET {
        return None;
    }
    Some((place_along(path, plane)?, shape))
}

/// Where a path that has skip the shape `skip` meets what its ray has hit, and what that is where
/// the ray did not see it.
#[inline(always)]
pub(crate) fn located<W: SceneAccess, const PRECISE: bool>(
    world: &W,
    path: &ScaledRay,
    skip: ShapeId,
    hit: Hit,
    signature: &mut PathSignature,
) -> Option<(ScaledPoint, ShapeId)> {
    if hit.shape == ShapeId::NONE {
        return None;
    }
    if hit.shape != ShapeId::BEYOND {
        let (origin, direction) = (path.ray.origin, path.direction());
        let at = match PRECISE {
            true => origin.precisely_along(direction, hit.distance),
            false => origin.along(direction, hit.distance),
        };
        // Only a plane can be met so far out that this is not near.
        if let Some(at) = ScaledPoint::near(at) {
            return Some((at, hit.shape));
        }
    }
    // Taken apart, or what is near is kept in memory, too.
    let (at, shape) = nearest(world, path, skip, signature)?;
    Some((at, shape))
}

/// Whether a path is blocked on its way to a light, one of them far.
#[cold]
pub(super) fn occluded<W: SceneAccess>(
    world: &W,
    path: &ScaledRay,
    skip: ShapeId,
    (light, distance, scale): (ScaledPoint, Length, u32),
) -> bool {
    let epsilon = world.parts().epsilon.to_bits() >> scale.min(31);
    let reach = Length::from_bits((distance.to_bits() - epsilon).max(0));
    if planes::others(world, skip).any(|(_, plane)| plane.blocks_far(path, reach, scale)) {
        return true;
    }
    let start = if path.from().is_near() {
        Some((path.ray, 0))
    } else {
        into_ball(path)
    };
    let Some((ray, skipped)) = start else {
        return false;
    };
    // The ball may begin behind the light.
    let total = u64::from(unsigned(reach.to_bits())) << scale.min(FURTHEST_SCALE);
    let Some(rest) = total.checked_sub(skipped) else {
        return false;
    };
    let rest = signed(narrowed_unsigned(
        rest.min(unsigned(REACH.to_bits()).into()),
    ));
    let reach = if light.is_near() {
        // Finer than what is skip of a far distance.
        let (_, rest) = ray.origin.to(light.point).direction_and_length();
        rest.to_bits() - world.parts().epsilon.to_bits()
    } else {
        rest
    };
    any_blocks(
        world,
        ShapeSet::ALL,
        &ray,
        skip,
        Length::from_bits(reach.max(0)),
    )
}

/// A path from a far place as a ray from where it enters the ball, and the steps skipped; `None`
/// where it does not enter it.
fn into_ball(path: &ScaledRay) -> Option<(Ray, u64)> {
    let ScaledPoint { point, scale } = path.from();
    if scale > FURTHEST_SCALE {
        return None;
    }
    let start = point.to_vector();
    let along = start.dot(path.direction());
    let nearest = start.without(path.direction(), along);
    // A few steps more than the ball, for what rounding has moved.
    let radius = u64::from((unsigned(BALL) >> scale.min(31)) + 4);
    let half_chord_square = (radius * radius).checked_sub(nearest.square())?;
    let entry = -along - square_root(half_chord_square);
    if entry <= 0 {
        return None;
    }
    let skipped = u64::from(unsigned(entry)) << scale;
    let at = place_along(path, skipped)?;
    at.is_near().then_some((
        Ray {
            origin: at.point,
            direction: path.direction(),
        },
        skipped,
    ))
}

/// The place `distance` (below 2⁶²) steps along a path.
#[inline(never)]
fn place_along(path: &ScaledRay, distance: u64) -> Option<ScaledPoint> {
    let ScaledPoint { point, scale } = path.from();
    if scale > FURTHEST_SCALE {
        return None;
    }
    let excess = 64_u32.saturating_sub(distance.leading_zeros() + 31);
    let leading = signed(narrowed_unsigned(distance >> excess));
    let [x, y, z] = path.direction().components();
    let up = signed(excess) - 30;
    Some(ScaledPoint::from_wide([
        sum((point.x, scale), wide(leading, x.to_bits()), up),
        sum((point.y, scale), wide(leading, y.to_bits()), up),
        sum((point.z, scale), wide(leading, z.to_bits()), up),
    ]))
}

/// `start` · 2^`scale` + `way` · 2^`up`: below 2⁶¹ + 2⁶².
#[inline(never)]
fn sum((start, scale): (i32, u32), way: i64, up: i32) -> i64 {
    (i64::from(start) << scale) + shifted(way, up)
}

#[cfg(test)]
mod tests;
