//! Where a ray meets one shape, and which way the shape faces there; it knows no material.

use super::Real;
use super::scene::{Cylinder, Plane, Sphere};
use super::vector::Vector;

/// A half line.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ray {
    pub origin: Vector,
    /// Length one, so that distances along the ray are scene units.
    pub direction: Vector,
}

impl Ray {
    pub fn at(&self, distance: Real) -> Vector {
        self.origin + self.direction * distance
    }
}

/// A shape with its directions made unit length.
#[derive(Clone, Copy, Debug)]
pub(super) enum Shape {
    Sphere {
        center: Vector,
        radius: Real,
    },
    Plane {
        point: Vector,
        normal: Vector,
    },
    Cylinder {
        center: Vector,
        axis: Vector,
        radius: Real,
        half_height: Real,
    },
}

impl Shape {
    /// The distance to the nearest point ahead, where there is one.
    pub fn meet(&self, ray: &Ray) -> Option<Real> {
        match *self {
            Self::Sphere { center, radius } => meet_sphere(ray, center - ray.origin, radius),
            Self::Plane { point, normal } => {
                let distance = normal.dot(point - ray.origin) / normal.dot(ray.direction);
                (distance > 0.0 && distance.is_finite()).then_some(distance)
            }
            Self::Cylinder {
                center,
                axis,
                radius,
                half_height,
            } => {
                let from_center = ray.origin - center;
                let height = axis.dot(from_center);
                let climb = axis.dot(ray.direction);
                meet_tube(ray, from_center, axis, radius)?
                    .into_iter()
                    .find(|t| *t > 0.0 && (height + t * climb).abs() <= half_height)
            }
        }
    }

    /// One over the radius; 0 of a plane.
    pub fn curvature(&self) -> Real {
        match *self {
            Self::Sphere { radius, .. } | Self::Cylinder { radius, .. } => 1.0 / radius,
            Self::Plane { .. } => 0.0,
        }
    }

    /// The unit normal at a point of the surface: outwards, or the plane's own.
    pub fn normal(&self, at: Vector) -> Vector {
        match *self {
            Self::Sphere { center, .. } => (at - center).unit(),
            Self::Plane { normal, .. } => normal,
            Self::Cylinder { center, axis, .. } => (at - center).across(axis).unit(),
        }
    }
}

/// The squared half chord is r² minus the squared distance of the centre from the ray; taken from
/// the distance itself it keeps its digits however far away the sphere is.
fn meet_sphere(ray: &Ray, to_center: Vector, radius: Real) -> Option<Real> {
    let middle = to_center.dot(ray.direction);
    let aside = to_center - ray.direction * middle;
    let half_chord_squared = radius * radius - aside.dot(aside);
    if half_chord_squared < 0.0 {
        return None;
    }
    let half_chord = half_chord_squared.sqrt();
    let (near, far) = (middle - half_chord, middle + half_chord);
    [near, far].into_iter().find(|t| *t > 0.0)
}

/// Where the ray goes through the endless tube, near point first, ahead or behind.
fn meet_tube(ray: &Ray, from_center: Vector, axis: Vector, radius: Real) -> Option<[Real; 2]> {
    let direction = ray.direction.across(axis);
    let origin = from_center.across(axis);
    let speed_squared = direction.dot(direction);
    let aside = origin.cross(direction);
    let discriminant = radius * radius * speed_squared - aside.dot(aside);
    if discriminant < 0.0 {
        return None;
    }
    let (middle, root) = (-origin.dot(direction), discriminant.sqrt());
    // A ray along the axis divides zero by zero, and what is not a number is never ahead.
    Some([
        (middle - root) / speed_squared,
        (middle + root) / speed_squared,
    ])
}

impl From<&Sphere> for Shape {
    fn from(sphere: &Sphere) -> Self {
        Self::Sphere {
            center: Vector::of(sphere.center),
            radius: sphere.radius as Real,
        }
    }
}

impl From<&Plane> for Shape {
    fn from(plane: &Plane) -> Self {
        Self::Plane {
            point: Vector::of(plane.point),
            normal: Vector::of(plane.normal).unit(),
        }
    }
}

impl From<&Cylinder> for Shape {
    fn from(cylinder: &Cylinder) -> Self {
        Self::Cylinder {
            center: Vector::of(cylinder.center),
            axis: Vector::of(cylinder.axis).unit(),
            radius: cylinder.radius as Real,
            half_height: cylinder.height as Real / 2.0,
        }
    }
}
