//! The bounded shapes that the camera's rays through one row of pixels can hit. The quality `Small` reads
//! the list.
//!
//! The rays of a row lie in a plane through the eye. A shape is left out if its ball does not reach that
//! plane. Bound: a radius is widened as in [`screen_bounds`](super::screen_bounds). With |w| and |n| the
//! lengths of the vector to a pixel and of the plane's normal, |n| ≤ |w| + 4, coordinates are rounded to
//! one, so |n · w| is at most 6 |w|, and 10 after w is brought to length one. So a point on a ray is off
//! the plane by at most 10 / |n| of its distance; 16 / |n| are allowed.

use super::screen_axis::widened;
use crate::camera::RowDirections;
use crate::number::{unsigned, unsigned_wide, wide};
use crate::qualities::Quality;
use crate::ray::ScaledPoint;
use crate::scene::FEW;
use crate::scene::access::SceneAccess;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::vector::{Point, Vector};

/// Returns the bounded shapes that the rays of a camera at `from` through a row can hit. Returns all shapes
/// if `Q` does not use lists, if there are few, or if the camera is far.
#[inline(always)]
pub(crate) fn row_list<W: SceneAccess, Q: Quality>(
    world: &W,
    from: ScaledPoint,
    directions: &RowDirections,
) -> ShapeSet {
    if Q::CULLING.lists && world.parts().bounded() > FEW && from.is_near() {
        found(world, from.point, directions)
    } else {
        *ShapeSet::ALL
    }
}

/// Returns the shapes whose balls reach the plane of a row, for a camera at `eye`.
#[inline(never)]
fn found<W: SceneAccess>(world: &W, eye: Point, directions: &RowDirections) -> ShapeSet {
    let (normal, length) = directions.plane();
    let parts = world.parts();
    let layout = SetLayout::new(parts.lengths());
    let mut set = ShapeSet::NONE;
    let mut number = 0;
    while let Some(((center, radius), _)) = parts.ball(number) {
        let (way, radius) = (eye.to(center), widened(radius));
        let height = wide(way.x, normal.x) + wide(way.y, normal.y) + wide(way.z, normal.z);
        let rounding = 16 * u64::from(length_bound(way) + unsigned(radius));
        if height.unsigned_abs() <= unsigned_wide(wide(radius, length)) + rounding {
            set = set.with(layout.set_of(number));
        }
        number += 1;
    }
    set
}

/// Returns the sum of the magnitudes of a vector's coordinates. Each is within ±2³⁰.
const fn length_bound(way: Vector) -> u32 {
    way.x.unsigned_abs() + way.y.unsigned_abs() + way.z.unsigned_abs()
}
