//! Where a ray meets one shape, and which way the shape faces there; it knows no material's colour.
//!
//! `meet` is always inlined: where the scene is a constant, so is every shape.

use super::{IS_CAREFUL, Real, Vector, square_root};

/// A half line.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts.
    pub origin: Vector,
    /// Length one, so that distances along the ray are scene units.
    pub direction: Vector,
}

impl Ray {
    /// The point at this distance.
    #[inline]
    pub fn at(&self, distance: Real) -> Vector {
        self.origin + self.direction * distance
    }
}

/// What every kind of shape can tell.
pub trait Shape {
    /// The distance to the nearest point ahead and before `reach`, where there is one.
    fn meet(&self, ray: &Ray, reach: Real) -> Option<Real>;

    /// The unit normal at a point of the surface: outwards, or the plane's own.
    fn normal(&self, at: Vector) -> Vector;

    /// One over its radius; 0 of what is flat.
    fn curvature(&self) -> Real;
}

/// A sphere.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    /// Its centre.
    pub center: Vector,
    /// Its radius.
    pub radius: Real,
    /// Its place in the list of materials.
    pub material: usize,
}

/// An infinite plane, seen from both sides.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// Any point in it.
    pub point: Vector,
    /// Unit length.
    pub normal: Vector,
    /// Its place in the list of materials.
    pub material: usize,
}

/// A tube without caps, seen from outside and inside.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    /// The middle of its axis.
    pub center: Vector,
    /// Unit length.
    pub axis: Vector,
    /// Its radius.
    pub radius: Real,
    /// Half of its length along the axis.
    pub half_height: Real,
    /// Its place in the list of materials.
    pub material: usize,
}

/// A flat disc, seen from both sides.
#[derive(Clone, Copy, Debug)]
pub struct Disc {
    /// Its middle.
    pub center: Vector,
    /// Unit length.
    pub normal: Vector,
    /// Its radius.
    pub radius: Real,
    /// Its place in the list of materials.
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
    /// As a sphere, in the plane across the axis, where the ray is slower.
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
            // It is zero for a ray along the axis, whose speed is zero, too.
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
