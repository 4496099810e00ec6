//! Where a ray meets one shape.

use crate::float::square_root;
use crate::scene::{Cylinder, Plane, Sphere};
use crate::vector::Vector;

/// A half line.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vector,
    /// Where it goes, of length one.
    pub direction: Vector,
}

impl Ray {
    /// The point at this distance.
    #[inline]
    pub fn at(&self, distance: f32) -> Vector {
        self.origin + self.direction * distance
    }
}

impl Sphere {
    /// The distance to the nearest point ahead and before `reach`.
    #[inline]
    pub(crate) fn meet(&self, ray: &Ray, reach: f32) -> Option<f32> {
        let to_center = self.center - ray.origin;
        let middle = to_center.dot(ray.direction);
        let beyond = to_center.dot(to_center) - self.radius * self.radius;
        let half_chord_squared = middle * middle - beyond;
        if half_chord_squared < 0.0 {
            return None;
        }
        let half_chord = square_root(half_chord_squared);
        let near = middle - half_chord;
        let distance = if near > 0.0 {
            near
        } else {
            middle + half_chord
        };
        (distance > 0.0 && distance < reach).then_some(distance)
    }

    #[inline]
    pub(crate) fn normal(&self, at: Vector) -> Vector {
        (at - self.center) * (1.0 / self.radius)
    }
}

impl Plane {
    /// The distance to the plane, ahead and before `reach`.
    #[inline]
    pub(crate) fn meet(&self, ray: &Ray, reach: f32) -> Option<f32> {
        let distance = self.normal.dot(self.point - ray.origin) / self.normal.dot(ray.direction);
        (distance > 0.0 && distance < reach).then_some(distance)
    }
}

impl Cylinder {
    /// The distance to the nearest point ahead and before `reach`.
    #[inline]
    pub(crate) fn meet(&self, ray: &Ray, reach: f32) -> Option<f32> {
        let from_center = ray.origin - self.center;
        let climb = self.axis.dot(ray.direction);
        let height = self.axis.dot(from_center);
        let direction = ray.direction - self.axis * climb;
        let origin = from_center - self.axis * height;
        let a = direction.dot(direction);
        let b = origin.dot(direction);
        let c = origin.dot(origin) - self.radius * self.radius;
        let discriminant = b * b - a * c;
        if discriminant < 0.0 {
            return None;
        }
        let root = square_root(discriminant);
        for distance in [(-b - root) / a, (-b + root) / a] {
            if distance >= reach {
                return None;
            }
            let is_on = (height + distance * climb).abs() <= self.half_height;
            if distance > 0.0 && is_on {
                return Some(distance);
            }
        }
        None
    }

    #[inline]
    pub(crate) fn normal(&self, at: Vector) -> Vector {
        let from_center = at - self.center;
        (from_center - self.axis * self.axis.dot(from_center)) * (1.0 / self.radius)
    }
}
