//! Paths that start or end beyond the near region: planes near the horizon, distant lights and
//! cameras. Rare, so kept out of the way of the near ones.
//!
//! Planes are met with a distance of 62 bits. Spheres and cylinders lie in the ball, so a path
//! from far away is moved along itself to where it enters the ball and asks them from there.

use super::World;
use super::mask::Mask;
use super::query::{Hit, NOWHERE, ShapeNumber, blocked_by_bounded, nearest_bounded, planes_but};
use crate::number::{Length, square_root};
use crate::ray::{BALL, Path, Place, REACH, Ray, Trail};
use crate::vector::Point;

/// Places further out than this scale see the ball as a point and are not followed.
const FURTHEST_SCALE: u32 = 32;

/// The nearest plane of any distance below 2⁶² steps, and that distance.
#[cold]
fn nearest_plane<W: World>(
    world: &W,
    path: &Path,
    left: ShapeNumber,
) -> Option<(u64, Place, ShapeNumber)> {
    let (distance, shape) = planes_but(world, left)
        .filter_map(|(number, plane)| Some((plane.intersect_far(path)?, number)))
        .min_by_key(|(distance, _)| *distance)?;
    Some((distance, place_along(path, distance)?, shape))
}

/// What a path that has left the shape `left` meets first, wherever it starts, and where.
#[cold]
#[inline(never)]
pub(crate) fn nearest<W: World>(
    world: &W,
    path: &Path,
    left: ShapeNumber,
    trail: &mut Trail,
) -> Option<(Place, ShapeNumber)> {
    let plane = nearest_plane(world, path, left);
    let start = match path.from().is_near() {
        true => Some((path.ray, 0)),
        false => into_ball(path),
    };
    let bounded = start.and_then(|(ray, skipped)| {
        let Hit { distance, shape } = nearest_bounded(world, &ray, NOWHERE, left, trail);
        let at = Place::new(ray.origin.along(ray.direction, distance), 0);
        (shape != ShapeNumber::NONE).then_some((skipped + distance.to_bits() as u64, at, shape))
    });
    let nearest = match (plane, bounded) {
        (Some(plane), Some(bounded)) => {
            if plane.0 <= bounded.0 {
                plane
            } else {
                bounded
            }
        }
        (plane, bounded) => plane.or(bounded)?,
    };
    Some((nearest.1, nearest.2))
}

/// Whether a path is blocked on its way to a light, one of them far.
#[cold]
pub(super) fn blocked<W: World>(
    world: &W,
    path: &Path,
    left: ShapeNumber,
    light: Place,
    distance: Length,
    scale: u32,
) -> bool {
    let epsilon = world.parts().epsilon.to_bits() >> scale.min(31);
    let reach = Length::from_bits((distance.to_bits() - epsilon).max(0));
    if planes_but(world, left).any(|(_, plane)| plane.blocks_far(path, reach, scale)) {
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
    let total = u128::from(reach.to_bits() as u32) << scale.min(64);
    let Some(rest) = total.checked_sub(u128::from(skipped)) else {
        return false;
    };
    let rest = rest.min(REACH.to_bits() as u128) as i32;
    let reach = if light.is_near() {
        // Finer than what is left of a far distance.
        let (_, rest) = ray.origin.to(light.point).direction_and_length();
        rest.to_bits() - world.parts().epsilon.to_bits()
    } else {
        rest
    };
    blocked_by_bounded(
        world,
        Mask::ALL,
        &ray,
        left,
        Length::from_bits(reach.max(0)),
    )
}

/// A path from a far place as a ray from where it enters the ball, and the steps skipped; `None`
/// where it does not enter it.
fn into_ball(path: &Path) -> Option<(Ray, u64)> {
    let Place { point, scale } = path.from();
    if scale > FURTHEST_SCALE {
        return None;
    }
    let start = point.to_vector();
    let along = start.dot(path.direction());
    let nearest = start.without(path.direction(), along);
    // A few steps more than the ball, for what rounding has moved.
    let radius = u64::from((BALL as u32 >> scale.min(31)) + 4);
    let half_chord_square = (radius * radius).checked_sub(nearest.square())?;
    let entry = -along - square_root(half_chord_square);
    if entry <= 0 {
        return None;
    }
    let skipped = (entry as u64) << scale;
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
fn place_along(path: &Path, distance: u64) -> Option<Place> {
    let Place {
        point: Point { x, y, z },
        scale,
    } = path.from();
    if scale > FURTHEST_SCALE {
        return None;
    }
    let excess = 64_u32.saturating_sub(distance.leading_zeros() + 31);
    let leading = (distance >> excess) as i64;
    let [dx, dy, dz] = path.direction().components();
    let coordinate = |start: i32, unit: crate::number::Unit| {
        let way = leading * i64::from(unit.to_bits());
        let way = if excess < 30 {
            way >> (30 - excess)
        } else {
            way << (excess - 30)
        };
        (i64::from(start) << scale).saturating_add(way)
    };
    Some(Place::from_wide([
        coordinate(x, dx),
        coordinate(y, dy),
        coordinate(z, dz),
    ]))
}

#[cfg(test)]
mod tests;
