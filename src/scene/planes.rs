//! The planes of a scene: the nearest that a ray hits, and those that may block it.
//!
//! The distance to a plane is a fraction: height over descent. Fractions are compared by products; only
//! that of the nearest plane is divided.

use super::access::{SceneAccess, ShapeId};
use super::nearest::Hit;
use crate::number::to_u32;
use crate::ray::Ray;
use crate::shape::plane::{Approach, Bearing, PreparedPlane};

/// Returns the nearest hit of a near ray: a plane, or `bounded`, its nearest bounded shape. Skips the
/// plane that the ray leaves.
#[inline(always)]
pub(crate) fn nearest<W: SceneAccess>(world: &W, ray: &Ray, skip: ShapeId, bounded: Hit) -> Hit {
    let parts = world.parts();
    // A ray that leaves a plane does not hit it again.
    if parts.planes.is_empty() || (parts.planes.len() == 1 && parts.is_plane(skip)) {
        return bounded;
    }
    nearer(world, ray, skip, bounded)
}

/// Compares the planes with the nearest bounded hit. Out of line: inlined code for several planes needs
/// more registers than there are.
#[inline(never)]
fn nearer<W: SceneAccess>(world: &W, ray: &Ray, skip: ShapeId, bounded: Hit) -> Hit {
    let parts = world.parts();
    let mut nearest = NearestPlane {
        approach: Approach::at(bounded.distance),
        shape: bounded.shape,
        is_met: false,
    };
    let number = |index: usize| ShapeId(parts.first_plane() + to_u32(index));
    // One by one, so that the compiler can use the constants of a constant scene's planes. A closure is
    // not always inlined. All products come first: a sign that is extended in another block takes three
    // instructions instead of one.
    let bearings = [
        bearing(parts.planes, 0, ray),
        bearing(parts.planes, 1, ray),
        bearing(parts.planes, 2, ray),
        bearing(parts.planes, 3, ray),
    ];
    for_first_four(parts.planes, |index, _| {
        nearest.meet(&bearings[index], number(index), skip);
    });
    for (index, plane) in parts.planes.iter().enumerate().skip(4) {
        nearest.meet(&plane.bearing(ray), number(index), skip);
    }
    Hit {
        distance: if nearest.is_met { nearest.approach.distance() } else { bounded.distance },
        shape: nearest.shape,
    }
}

/// Returns a ray's height over a plane and its rate of climb. `index` is the plane's index.
#[inline(always)]
fn bearing(planes: &[PreparedPlane], index: usize, ray: &Ray) -> Bearing {
    match planes.get(index) {
        Some(plane) => plane.bearing(ray),
        None => Bearing::NONE,
    }
}

/// Calls `call` for each of the first four items separately, so that each call is compiled for its
/// item.
#[inline(always)]
pub(crate) fn for_first_four<'a, T>(items: &'a [T], mut call: impl FnMut(usize, &'a T)) {
    if let Some(item) = items.first() {
        call(0, item);
    }
    if let Some(item) = items.get(1) {
        call(1, item);
    }
    if let Some(item) = items.get(2) {
        call(2, item);
    }
    if let Some(item) = items.get(3) {
        call(3, item);
    }
}

/// The nearest hit among the planes that a ray has been tested against so far, or something nearer.
struct NearestPlane {
    /// Distance of the nearest hit, as a fraction.
    approach: Approach,
    /// The shape that is hit; [`ShapeId::BEYOND`] if a plane is hit beyond the near region.
    shape: ShapeId,
    /// Whether the nearest hit is a plane.
    is_met: bool,
}

impl NearestPlane {
    /// Intersects the ray with a plane, and keeps the plane if it is nearer than the hit so far.
    #[inline(always)]
    fn meet(&mut self, bearing: &Bearing, number: ShapeId, skip: ShapeId) {
        if number == skip {
            return;
        }
        let Some(approach) = bearing.approach() else {
            return;
        };
        if approach.is_before(&self.approach) {
            (self.approach, self.shape, self.is_met) = (approach, number, true);
        } else if self.shape == ShapeId::NONE {
            self.shape = ShapeId::BEYOND;
        }
    }
}

/// Returns all planes and their ids, without the plane `skip` that a ray leaves.
pub(super) fn others<W: SceneAccess>(
    world: &W,
    skip: ShapeId,
) -> impl Iterator<Item = (ShapeId, &PreparedPlane)> {
    let parts = world.parts();
    let planes = (parts.first_plane()..).map(ShapeId).zip(parts.planes);
    planes.filter(move |(number, _)| *number != skip)
}
