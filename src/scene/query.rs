//! What a ray asks the scene: what it meets first, and whether it is blocked before a light.

use super::mask::Mask;
use super::{Lamp, World, far};
use crate::number::Length;
use crate::ray::{Path, Place, REACH, Ray};
use crate::shape::MaterialId;
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::plane::PreparedPlane;
use crate::shape::sphere::PreparedSphere;
use crate::vector::Direction;

/// The shape a ray has met.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Met<'a> {
    Sphere(&'a PreparedSphere),
    Plane(&'a PreparedPlane),
    Cylinder(&'a PreparedCylinder),
}

impl<'a> Met<'a> {
    /// The normal where the shape has been met; it may face away from the ray.
    pub(crate) fn normal(&self, at: Place) -> Direction {
        match self {
            Self::Sphere(sphere) => sphere.normal(at.point),
            Self::Plane(plane) => plane.normal,
            Self::Cylinder(cylinder) => cylinder.normal(at.point),
        }
    }

    pub(crate) fn material(&self) -> MaterialId {
        match self {
            Self::Sphere(sphere) => sphere.material,
            Self::Plane(plane) => plane.material,
            Self::Cylinder(cylinder) => cylinder.material,
        }
    }

    /// The plane that has been met, if it is one: no ray that leaves it meets it again.
    pub(crate) fn plane(&self) -> Option<&'a PreparedPlane> {
        match self {
            Self::Plane(plane) => Some(plane),
            _ => None,
        }
    }
}

/// Where a path meets a shape.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Hit<'a> {
    pub(crate) at: Place,
    pub(crate) shape: Met<'a>,
}

/// What a path that has left the plane `left`, if any, meets first.
pub(crate) fn nearest<'a, W: World>(
    world: &'a W,
    mask: Mask,
    path: &Path,
    left: Option<&PreparedPlane>,
) -> Option<Hit<'a>> {
    if !path.from.is_near() {
        return far::nearest(world, path, left);
    }
    let ray = path.ray();
    let mut met = nearest_bounded(world, mask, &ray);
    for plane in planes_but(world, left) {
        let reach = met.map_or(REACH, |(distance, _)| distance);
        if let Some(distance) = plane.intersect(&ray, reach) {
            met = Some((distance, Met::Plane(plane)));
        }
    }
    match met {
        Some((distance, shape)) => Some(hit(&ray, distance, shape)),
        None => far::nearest_plane(world, path, left).map(|(_, hit)| hit),
    }
}

/// The nearest sphere or cylinder.
#[inline(never)]
pub(super) fn nearest_bounded<'a, W: World>(
    world: &'a W,
    mask: Mask,
    ray: &Ray,
) -> Option<(Length, Met<'a>)> {
    let mut met: Option<(Length, Met<'a>)> = None;
    let reach = |met: &Option<(Length, Met)>| met.as_ref().map_or(REACH, |(distance, _)| *distance);
    let parts = world.parts();
    let runs = parts.runs();
    for sphere in runs.spheres(mask, parts.spheres) {
        if let Some(distance) = sphere.intersect(ray, reach(&met)) {
            met = Some((distance, Met::Sphere(sphere)));
        }
    }
    for cylinder in runs.cylinders(mask, parts.cylinders) {
        if let Some(distance) = cylinder.intersect(ray, reach(&met)) {
            met = Some((distance, Met::Cylinder(cylinder)));
        }
    }
    met
}

/// The hit at a distance below [`REACH`] along a near ray.
pub(super) fn hit<'a>(ray: &Ray, distance: Length, shape: Met<'a>) -> Hit<'a> {
    Hit {
        at: Place::new(ray.origin.along(ray.direction, distance), 0),
        shape,
    }
}

/// The planes but the one a ray has just left.
pub(super) fn planes_but<'a, W: World>(
    world: &'a W,
    left: Option<&PreparedPlane>,
) -> impl Iterator<Item = &'a PreparedPlane> {
    world
        .parts()
        .planes
        .iter()
        .filter(move |plane| !left.is_some_and(|left| core::ptr::eq(*plane, left)))
}

/// Whether a path towards a light that is `distance` · 2^`scale` steps away meets anything more
/// than epsilon before it.
pub(crate) fn blocked<W: World>(
    world: &W,
    path: &Path,
    left: Option<&PreparedPlane>,
    lamp: &Lamp,
    distance: Length,
    scale: u32,
) -> bool {
    if scale != 0 {
        return far::blocked(world, path, left, lamp.light.place, distance, scale);
    }
    let ray = path.ray();
    let reach = Length::from_bits((distance.to_bits() - world.parts().epsilon.to_bits()).max(0));
    planes_but(world, left).any(|plane| plane.blocks(&ray, reach))
        || blocked_by_bounded(world, seen_from(world, lamp, &ray), &ray, reach)
}

/// The shapes that may lie between a light and the start of a ray towards it.
fn seen_from<W: World>(world: &W, lamp: &Lamp, ray: &Ray) -> Mask {
    let parts = world.parts();
    // So few are asked in less time than it takes to choose.
    const FEW: usize = 2;
    if parts.spheres.len() + parts.cylinders.len() <= FEW {
        return Mask::ALL;
    }
    lamp.cells.mask(ray.direction.reversed())
}

/// Whether a sphere or cylinder of a set lies on the ray before `reach`.
#[inline(never)]
pub(crate) fn blocked_by_bounded<W: World>(
    world: &W,
    mask: Mask,
    ray: &Ray,
    reach: Length,
) -> bool {
    let parts = world.parts();
    let runs = parts.runs();
    runs.spheres(mask, parts.spheres)
        .any(|sphere| sphere.blocks(ray, reach))
        || runs
            .cylinders(mask, parts.cylinders)
            .any(|cylinder| cylinder.blocks(ray, reach))
}

#[cfg(test)]
mod tests;
