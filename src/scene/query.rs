//! What a ray asks the scene: what it meets first, and whether it is blocked before a light.

use super::cells::Cells;
use super::mask::Mask;
#[cfg(any(test, feature = "host"))]
use super::nearest::{NOWHERE, nearest_bounded};
use super::{Occluders, Parts, World, far};
use crate::number::{Length, to_u32};
use crate::ray::{PathSignature, REACH, Ray, ScaledPoint, ScaledRay, spread};
use crate::shape::cylinder::{LitCylinder, PreparedCylinder};
use crate::shape::plane::{Approach, Bearing, PreparedPlane};
use crate::shape::sphere::{PreparedSphere, SphereFromPoint};
use crate::vector::Direction;

/// Names a shape of a scene, or none: spheres come first, then cylinders, then planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ShapeId(u32);

impl ShapeId {
    /// No shape.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// Not known: further away than near rays look.
    pub(crate) const BEYOND: Self = Self(u32::MAX - 1);

    /// Names one side of it.
    pub(crate) const fn side(self, is_inside: bool) -> u32 {
        self.0 << 1 | is_inside as u32
    }

    /// What a path notes that passes it on one side and not on the other; spread, so that several
    /// together are told from others.
    #[inline(always)]
    pub(super) const fn passed(self) -> u32 {
        spread(self.0 + 1)
    }

    /// Where it stands among all shapes.
    #[inline(always)]
    pub(super) const fn index(self) -> usize {
        self.0 as usize
    }

    pub(crate) const fn of_sphere(index: usize) -> Self {
        Self(to_u32(index))
    }
}

impl Parts<'_> {
    pub(crate) fn cylinder_number(&self, index: usize) -> ShapeId {
        ShapeId(to_u32(self.spheres.len() + index))
    }

    /// The number that the planes begin with.
    #[inline(always)]
    fn first_plane(&self) -> u32 {
        to_u32(self.spheres.len() + self.cylinders.len())
    }

    /// Whether a shape is a plane.
    #[inline(always)]
    pub(crate) fn is_plane(&self, shape: ShapeId) -> bool {
        shape != ShapeId::NONE && shape.0 >= self.first_plane()
    }
}

/// A shape of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape<'a> {
    Sphere(&'a PreparedSphere),
    Cylinder(&'a PreparedCylinder),
    Plane(&'a PreparedPlane),
}

impl<'a> Parts<'a> {
    /// The shape with a number.
    #[inline(always)]
    pub(crate) fn shape(&self, shape: ShapeId) -> Option<Shape<'a>> {
        let number = shape.index();
        if let Some(sphere) = self.spheres.get(number) {
            return Some(Shape::Sphere(sphere));
        }
        let number = number - self.spheres.len();
        if let Some(cylinder) = self.cylinders.get(number) {
            return Some(Shape::Cylinder(cylinder));
        }
        let plane = self.planes.get(number - self.cylinders.len())?;
        Some(Shape::Plane(plane))
    }

    /// The plane with a number, if it is one.
    #[inline(always)]
    pub(crate) fn plane(&self, shape: ShapeId) -> Option<&'a PreparedPlane> {
        self.planes.get(self.plane_index(shape)?)
    }

    /// Where a plane stands among the planes.
    #[inline(always)]
    pub(super) fn plane_index(&self, shape: ShapeId) -> Option<usize> {
        shape
            .0
            .checked_sub(self.first_plane())
            .map(|it| it as usize)
    }
}

/// Where a near ray meets a shape first: [`ShapeId::NONE`] where it meets none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Hit {
    pub(crate) distance: Length,
    pub(crate) shape: ShapeId,
}

impl Hit {
    /// Nothing as far as a near ray looks.
    pub(crate) const NONE: Self = Self {
        distance: REACH,
        shape: ShapeId::NONE,
    };

    /// Not known to a near ray.
    pub(crate) const BEYOND: Self = Self {
        distance: REACH,
        shape: ShapeId::BEYOND,
    };
}

/// What a near ray that has left the shape `left` meets first, given what it meets first of the
/// spheres and cylinders.
#[inline(always)]
pub(crate) fn nearest<W: World>(world: &W, ray: &Ray, left: ShapeId, bounded: Hit) -> Hit {
    let parts = world.parts();
    // A ray that leaves a plane does not meet it again.
    if parts.planes.is_empty() || (parts.planes.len() == 1 && parts.is_plane(left)) {
        return bounded;
    }
    match W::PLANES {
        1 => nearer_plane(world, ray, left, bounded),
        _ => nearest_plane(world, ray, left, bounded),
    }
}

/// Out of line: several in line take more registers than there are.
#[inline(never)]
fn nearest_plane<W: World>(world: &W, ray: &Ray, left: ShapeId, bounded: Hit) -> Hit {
    nearer_plane(world, ray, left, bounded)
}

#[inline(always)]
fn nearer_plane<W: World>(world: &W, ray: &Ray, left: ShapeId, bounded: Hit) -> Hit {
    let parts = world.parts();
    let mut nearest = NearestPlane {
        approach: Approach::at(bounded.distance),
        shape: bounded.shape,
        is_met: false,
    };
    let number = |index: usize| ShapeId(parts.first_plane() + to_u32(index));
    // One by one, so that the compiler can work with the planes of a constant scene; not by a closure,
    // which is not always in line. All products first: a sign that is extended in another block makes
    // three instructions of one.
    let bearings = [
        bearing(parts.planes, 0, ray),
        bearing(parts.planes, 1, ray),
        bearing(parts.planes, 2, ray),
        bearing(parts.planes, 3, ray),
    ];
    for_first_four(parts.planes, |index, _| {
        nearest.meet(&bearings[index], number(index), left);
    });
    for (index, plane) in parts.planes.iter().enumerate().skip(4) {
        nearest.meet(&plane.bearing(ray), number(index), left);
    }
    Hit {
        distance: if nearest.is_met {
            nearest.approach.distance()
        } else {
            bounded.distance
        },
        shape: nearest.shape,
    }
}

/// Where a ray begins and where it goes, as one of the planes sees it.
#[inline(always)]
fn bearing(planes: &[PreparedPlane], index: usize, ray: &Ray) -> Bearing {
    match planes.get(index) {
        Some(plane) => plane.bearing(ray),
        None => Bearing::NONE,
    }
}

/// Calls with each of the first four items by itself, so that each call is compiled for its item.
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

/// The nearest of the planes that a ray has been held against, or what is nearer.
struct NearestPlane {
    approach: Approach,
    shape: ShapeId,
    /// Whether it is one of the planes.
    is_met: bool,
}

impl NearestPlane {
    #[inline(always)]
    fn meet(&mut self, bearing: &Bearing, number: ShapeId, left: ShapeId) {
        if number == left {
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

/// Where a path that has left the shape `left` meets what its ray has hit, and what that is where
/// the ray did not see it.
#[inline(always)]
pub(crate) fn located<W: World, const PRECISE: bool>(
    world: &W,
    path: &ScaledRay,
    left: ShapeId,
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
    let (at, shape) = far::nearest::<W, false>(world, path, left, signature)?;
    Some((at, shape))
}

/// What a path that has left the shape `left` meets first, and where, with every shape asked.
#[cfg(any(test, feature = "host"))]
pub(crate) fn first<W: World>(
    world: &W,
    path: &ScaledRay,
    left: ShapeId,
) -> Option<(ScaledPoint, ShapeId)> {
    let mut signature = PathSignature::new();
    let hit = match path.from().is_near() {
        true => nearest(
            world,
            &path.ray,
            left,
            nearest_bounded::<W, false>(world, &path.ray, NOWHERE, left, &mut signature),
        ),
        false => Hit::BEYOND,
    };
    located::<W, false>(world, path, left, hit, &mut signature)
}

/// The planes but the one a ray has just left, and their numbers.
pub(super) fn planes_but<W: World>(
    world: &W,
    left: ShapeId,
) -> impl Iterator<Item = (ShapeId, &PreparedPlane)> {
    let parts = world.parts();
    let numbers = (parts.first_plane()..).map(ShapeId);
    numbers
        .zip(parts.planes)
        .filter(move |(number, _)| *number != left)
}

/// Whether a path towards a light that is `distance` · 2^`scale` steps away meets anything more
/// than epsilon before it, with nothing known about camera and light but its cells, if it has any.
pub(crate) fn blocked<W: World>(
    world: &W,
    path: &ScaledRay,
    left: ShapeId,
    (light, cells): (ScaledPoint, Option<&Cells>),
    distance: Length,
    scale: u32,
) -> bool {
    if scale != 0 {
        return far::blocked(world, path, left, light, distance, scale);
    }
    let ray = &path.ray;
    let reach = Length::from_bits((distance.to_bits() - world.parts().epsilon.to_bits()).max(0));
    let mask = cells.map_or(Mask::ALL, |cells| cells.mask(ray.direction.reversed()));
    planes_but(world, left).any(|(_, plane)| plane.blocks(ray, reach))
        || blocked_by_bounded(world, mask, ray, left, reach)
}

/// Shadow test from a light that no plane hides: whether a sphere or cylinder occludes the point that
/// lies `distance` along `direction` from the light. `hides` tests a sphere. A cylinder is skipped where
/// `is_left`: the point lies on its outside.
#[inline(always)]
pub(crate) fn blocked_from<W: World>(
    world: &W,
    (lamp, index): (&W::LightOccluders, usize),
    (direction, distance): (Direction, Length),
    is_left: impl Fn(ShapeId) -> bool,
    hides: impl Fn(ShapeId, &PreparedSphere, &SphereFromPoint) -> bool,
) -> bool {
    let parts = world.parts();
    let (spheres, cylinders) = (lamp.spheres(), lamp.cylinders());
    // One copy in memory, for all cylinders.
    let along = direction;
    let sphere_hides = |index: usize, sphere: &PreparedSphere, seen: &SphereFromPoint| {
        hides(ShapeId::of_sphere(index), sphere, seen)
    };
    let cylinder_hides = |index: usize, cylinder: &PreparedCylinder, lit: &LitCylinder| {
        !is_left(parts.cylinder_number(index))
            && lit.is_before(cylinder, &along, parts.epsilon, distance)
    };
    if !W::NEEDS.sets {
        let mut spheres = parts.spheres.iter().zip(spheres).enumerate();
        let mut cylinders = parts.cylinders.iter().zip(cylinders).enumerate();
        return spheres.any(|(index, (sphere, seen))| sphere_hides(index, sphere, seen))
            || cylinders.any(|(index, (cylinder, lit))| cylinder_hides(index, cylinder, lit));
    }
    let mask = match world.cells().get(index) {
        Some(cells) => cells.mask(direction),
        None => Mask::ALL,
    };
    let runs = parts.runs();
    runs.any_sphere(mask, |index| {
        let sphere = parts.spheres.get(index).zip(spheres.get(index));
        sphere.is_some_and(|(sphere, seen)| sphere_hides(index, sphere, seen))
    }) || runs.any_cylinder(mask, |index| {
        let cylinder = parts.cylinders.get(index).zip(cylinders.get(index));
        cylinder.is_some_and(|(cylinder, lit)| cylinder_hides(index, cylinder, lit))
    })
}

/// Whether a sphere or cylinder of a set lies on the ray before `reach`, other than the one whose
/// outside the ray has `left`.
#[inline(never)]
pub(crate) fn blocked_by_bounded<W: World>(
    world: &W,
    mask: Mask,
    ray: &Ray,
    left: ShapeId,
    reach: Length,
) -> bool {
    let parts = world.parts();
    let runs = parts.runs();
    runs.any_sphere(mask, |index| {
        let sphere = parts.spheres.get(index);
        let is_left = ShapeId::of_sphere(index) == left;
        !is_left && sphere.is_some_and(|sphere| sphere.blocks(ray, reach))
    }) || runs.any_cylinder(mask, |index| {
        let cylinder = parts.cylinders.get(index);
        let is_left = parts.cylinder_number(index) == left;
        !is_left && cylinder.is_some_and(|cylinder| cylinder.blocks(ray, reach))
    })
}

#[cfg(test)]
mod tests;
