//! Intersects a ray with one shape, and computes the shape's normal. This file knows materials only by
//! index.
//!
//! `meet` is always inlined, so that the compiler can use the numbers of shapes in a constant scene.

use super::{IS_CAREFUL, Real, Vector, square_root};

/// A ray: a start point and a unit direction.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Point where the ray starts, in scene units.
    pub origin: Vector,
    /// Direction of the ray. Its length is one, so that distances along the ray are in scene units.
    pub direction: Vector,
}

impl Ray {
    /// Returns the point at `distance` from the start of the ray.
    #[inline]
    pub fn at(&self, distance: Real) -> Vector {
        self.origin + self.direction * distance
    }
}

/// The functions that each kind of shape implements: hit, normal and curvature.
pub trait Shape {
    /// Returns the distance to the nearest hit, if it is above 0 and below `reach`.
    fn meet(&self, ray: &Ray, reach: Real) -> Option<Real>;

    /// Returns the unit normal at a point of the surface: outwards on a sphere or cylinder, the
    /// described normal on a plane or disc.
    fn normal(&self, at: Vector) -> Vector;

    /// Returns the curvature: 1 / radius of a sphere or cylinder, 0 of a flat shape.
    fn curvature(&self) -> Real;
}

/// A sphere, prepared for tracing.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    /// Centre of the sphere, in scene units.
    pub center: Vector,
    /// Radius of the sphere, in scene units.
    pub radius: Real,
    /// Index of the shape's material in the scene's list.
    pub material: usize,
}

/// An infinite plane that is visible from both sides, prepared for tracing.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Any point of the plane, in scene units.
    pub point: Vector,
    /// Unit normal of the plane.
    pub normal: Vector,
    /// Index of the shape's material in the scene's list.
    pub material: usize,
}

/// A cylinder without caps that is visible from outside and inside, prepared for tracing.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    /// Middle of the cylinder's axis, in scene units.
    pub center: Vector,
    /// Unit direction of the cylinder's axis.
    pub axis: Vector,
    /// Radius of the cylinder, in scene units.
    pub radius: Real,
    /// Half of the cylinder's length along the axis, in scene units.
    pub half_height: Real,
    /// Index of the shape's material in the scene's list.
    pub material: usize,
}

/// A flat disc that is visible from both sides, prepared for tracing.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// Centre of the disc, in scene units.
    pub center: Vector,
    /// Unit normal of the disc.
    pub normal: Vector,
    /// Radius of the disc, in scene units.
    pub radius: Real,
    /// Index of the shape's material in the scene's list.
    pub material: usize,
}

impl Shape for Sphere {
    #[inline(always)]
    fn meet(&self, ray: &Ray, reach: Real) -> Option<Real> {
        let to_center = self.center - ray.origin;
        let middle = to_center.dot(ray.direction);
        let half_chord_squared = if IS_CAREFUL {
            let aside = to_center - ray.direction * middle;
            self.radius * self.radius - aside.dot(aside)
        } else {
            let beyond = to_center.dot(to_center) - self.radius * self.radius;
            middle * middle - beyond
        };
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
    fn normal(&self, at: Vector) -> Vector {
        (at - self.center).unit()
    }

    fn curvature(&self) -> Real {
        1.0 / self.radius
    }
}

impl Shape for Plane {
    #[inline(always)]
    fn meet(&self, ray: &Ray, reach: Real) -> Option<Real> {
        let distance = self.normal.dot(self.point - ray.origin) / self.normal.dot(ray.direction);
        (distance > 0.0 && distance < reach).then_some(distance)
    }

    #[inline]
    fn normal(&self, _: Vector) -> Vector {
        self.normal
    }

    fn curvature(&self) -> Real {
        0.0
    }
}

impl Shape for Cylinder {
    /// Returns the distance to the nearest hit on the open cylinder, as for a sphere but in the plane
    /// perpendicular to the axis. There the direction's length (`speed_squared` is its square) is below
    /// one.
    #[inline(always)]
    fn meet(&self, ray: &Ray, reach: Real) -> Option<Real> {
        let from_center = ray.origin - self.center;
        let climb = self.axis.dot(ray.direction);
        let height = self.axis.dot(from_center);
        let direction = ray.direction - self.axis * climb;
        let origin = from_center - self.axis * height;
        let speed_squared = direction.dot(direction);
        let middle = -origin.dot(direction);
        let discriminant = if IS_CAREFUL {
            let aside = origin.cross(direction);
            self.radius * self.radius * speed_squared - aside.dot(aside)
        } else {
            let beyond = origin.dot(origin) - self.radius * self.radius;
            middle * middle - speed_squared * beyond
        };
        if discriminant < 0.0 {
            return None;
        }
        let root = square_root(discriminant);
        for way in [middle - root, middle + root] {
            // For a ray along the axis both `way` and `speed_squared` are zero, so it has no hit.
            if way > 0.0 {
                let distance = way / speed_squared;
                if distance >= reach {
                    return None;
                }
                if (height + distance * climb).abs() <= self.half_height {
                    return Some(distance);
                }
            }
        }
        None
    }

    #[inline]
    fn normal(&self, at: Vector) -> Vector {
        (at - self.center).across(self.axis).unit()
    }

    fn curvature(&self) -> Real {
        1.0 / self.radius
    }
}

impl Shape for Disc {
    #[inline(always)]
    fn meet(&self, ray: &Ray, reach: Real) -> Option<Real> {
        let to_center = self.center - ray.origin;
        let distance = self.normal.dot(to_center) / self.normal.dot(ray.direction);
        if !(distance > 0.0 && distance < reach) {
            return None;
        }
        let aside = to_center - ray.direction * distance;
        (aside.dot(aside) <= self.radius * self.radius).then_some(distance)
    }

    #[inline]
    fn normal(&self, _: Vector) -> Vector {
        self.normal
    }

    fn curvature(&self) -> Real {
        0.0
    }
}
