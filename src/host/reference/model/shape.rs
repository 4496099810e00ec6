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
    /// described normal on a plane or disc, and the cross product of a triangle's sides.
    fn normal(&self, at: Vector) -> Vector;

    /// Returns the curvature: 1 / radius of a sphere or cylinder, 0 of a flat shape.
    fn curvature(&self) -> Real {
        0.0
    }
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

/// A triangle that is visible from both sides, prepared for tracing.
#[derive(Clone, Copy, Debug)]
pub struct Triangle {
    /// First corner of the triangle, in scene units.
    pub corner: Vector,
    /// Vectors from the first corner to the second and to the third.
    pub sides: [Vector; 2],
    /// Unit normals at the corners, `None` if the triangle is flat.
    pub normals: Option<[Vector; 3]>,
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
        let distance = if near > 0.0 { near } else { middle + half_chord };
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
}

impl Shape for Triangle {
    /// Returns the distance by Cramer's rule, as Möller and Trumbore do.
    #[inline(always)]
    fn meet(&self, ray: &Ray, reach: Real) -> Option<Real> {
        let [one, other] = self.sides;
        let across = ray.direction.cross(other);
        let volume = one.dot(across);
        let from_corner = ray.origin - self.corner;
        let second = from_corner.dot(across) / volume;
        // Not a number for a ray along the triangle.
        if !(0.0..=1.0).contains(&second) {
            return None;
        }
        let aside = from_corner.cross(one);
        let third = ray.direction.dot(aside) / volume;
        if third < 0.0 || second + third > 1.0 {
            return None;
        }
        let distance = other.dot(aside) / volume;
        (distance > 0.0 && distance < reach).then_some(distance)
    }

    #[inline]
    fn normal(&self, _: Vector) -> Vector {
        let [one, other] = self.sides;
        one.cross(other).unit()
    }

    /// Returns how fast the normal turns, with a reserve: the largest difference of two normals over the smallest
    /// altitude.
    fn curvature(&self) -> Real {
        let Some([first, second, third]) = self.normals else {
            return 0.0;
        };
        let [one, other] = self.sides;
        let longest = one.length().max(other.length()).max((other - one).length());
        let turn = (second - first).length() + (third - first).length();
        2.0 * turn * longest / one.cross(other).length()
    }
}

impl Triangle {
    /// Returns the normal with which a point is shaded. `flat` is the triangle's own normal on the viewer's side, and
    /// the viewer looks along `view`.
    ///
    /// If a mirror with this normal reflects the view into the triangle, it is bent until the reflection runs along it.
    #[inline]
    pub fn shaded(&self, at: Vector, flat: Vector, view: Vector) -> Vector {
        let Some([first, second, third]) = self.normals else {
            return flat;
        };
        let ([one, other], place) = (self.sides, at - self.corner);
        let across = one.cross(other);
        let weight = |area: Vector| (area.dot(across) / across.dot(across)).clamp(0.0, 1.0);
        let (b, c) = (weight(place.cross(other)), weight(one.cross(place)));
        let c = c.min(1.0 - b);
        let sum = first * (1.0 - b - c) + second * b + third * c;
        if sum.dot(sum) < 1e-6 {
            return flat;
        }
        let normal = sum.unit();
        let normal = if normal.dot(flat) < 0.0 { -normal } else { normal };
        let mirrored = (-view).mirrored(normal);
        if mirrored.dot(flat) >= 0.0 {
            return normal;
        }
        let between = mirrored.across(flat).unit() - view;
        if between.dot(between) < 1e-6 { flat } else { between.unit() }
    }
}
