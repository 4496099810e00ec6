//! Rays that start or end beyond the near region: planes near the horizon, distant lights and cameras.
//!
//! The distance to a plane has 62 bits. Bounded shapes lie in the ball, so a ray from far away is moved
//! along itself to where it enters the ball. Shapes are tested from there.

use crate::number::{Length, narrowed_unsigned, shifted, signed, square_root, unsigned, wide};
use crate::ray::{BALL, REACH, Ray, ScaledPoint, ScaledRay};

/// Largest scale of a point from which rays are followed. From points of larger scale the whole ball is
/// seen as a point.
const FURTHEST_SCALE: u32 = 32;

/// Returns how much of a ray of `reach` · 2^`scale` steps from a near point can be near.
#[inline(always)]
pub(super) const fn near_part(reach: Length, scale: u32) -> Length {
    // A shift by 30 leaves one step of the furthest point that a near ray reaches.
    let scale = if scale < 30 { scale } else { 30 };
    if reach.to_bits() < REACH.to_bits() >> scale {
        Length::from_bits(reach.to_bits() << scale)
    } else {
        REACH
    }
}

/// Returns the part of a shadow ray that lies in the ball: a near ray and its length. Returns `None` if
/// the ray does not enter the ball before the light.
///
/// The light is `reach` · 2^`scale` steps away. The ray's start is far.
#[cold]
#[inline(never)]
pub(super) fn between(
    ray: &ScaledRay,
    (light, reach, scale): (ScaledPoint, Length, u32),
    epsilon: Length,
) -> Option<(Ray, Length)> {
    let (near, skipped) = into_ball(ray)?;
    // The light may stand before the ball.
    let total = u64::from(unsigned(reach.to_bits())) << scale.min(FURTHEST_SCALE);
    let rest = total.checked_sub(skipped)?;
    let rest = signed(narrowed_unsigned(
        rest.min(unsigned(REACH.to_bits()).into()),
    ));
    let reach = if light.is_near() {
        // The distance to a near light is more exact than the rest of a far distance.
        let (_, rest) = near.origin.to(light.point).direction_and_length();
        rest.to_bits() - epsilon.to_bits()
    } else {
        rest
    };
    Some((near, Length::from_bits(reach.max(0))))
}

/// Moves a ray from a far point to where it enters the ball. Returns the near ray and the steps that
/// were skipped; `None` if the ray does not enter the ball.
pub(super) fn into_ball(path: &ScaledRay) -> Option<(Ray, u64)> {
    let ScaledPoint { point, scale } = path.from();
    if scale > FURTHEST_SCALE {
        return None;
    }
    let start = point.to_vector();
    let along = start.dot(path.direction());
    let nearest = start.without(path.direction(), along);
    // A few steps more than the ball, to cover rounding.
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

/// Returns the point `distance` steps along a ray. `distance` is below 2⁶². Returns `None` if the ray
/// starts too far away.
#[inline(never)]
pub(super) fn place_along(path: &ScaledRay, distance: u64) -> Option<ScaledPoint> {
    let ScaledPoint { point, scale } = path.from();
    // On the near part of a ray from a near point, 32 bits hold every coordinate.
    if scale == 0 && distance < u64::from(unsigned(REACH.to_bits())) {
        let distance = Length::from_bits(signed(narrowed_unsigned(distance)));
        return Some(ScaledPoint::new(point.along(path.direction(), distance), 0));
    }
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

/// Returns `start` · 2^`scale` + `way` · 2^`up`. The magnitude is below 2⁶¹ + 2⁶².
#[inline(never)]
fn sum((start, scale): (i32, u32), way: i64, up: i32) -> i64 {
    (i64::from(start) << scale) + shifted(way, up)
}

#[cfg(test)]
mod tests;
