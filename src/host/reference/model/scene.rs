//! What a ray meets in a whole scene, and the one place that steps off a surface; it knows no
//! colour but hands on the material.

use super::{Cylinder, Plane, Ray, Real, Shape, Sphere, Vector};

/// A scene made ready for rays. Shapes name their material by its place.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The spheres.
    pub spheres: &'a [Sphere],
    /// The infinite planes.
    pub planes: &'a [Plane],
    /// The open cylinders.
    pub cylinders: &'a [Cylinder],
    /// The point lights.
    pub lights: &'a [Light],
    /// What the shapes are made of.
    pub materials: &'a [Material],
    /// Linear colour where a ray meets nothing.
    pub background: Vector,
    /// How far from a surface, along its normal, shadow and reflected rays start.
    pub epsilon: Real,
}

/// A point light that does not fall off with distance.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    /// Where it stands.
    pub position: Vector,
    /// Its linear colour.
    pub color: Vector,
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Linear colour.
    pub color: Vector,
    /// Share of the colour that is there without any light.
    pub ambient: Real,
    /// Share of the light that is scattered evenly.
    pub diffuse: Real,
    /// Strength of the highlight, which has the material's colour too.
    pub specular: Real,
    /// The highlight's exponent.
    pub shininess: Real,
    /// α, 0 to 1: the share of the picture in this surface.
    pub mirror: Real,
}

/// Which shape a ray meets: its kind and its place in the list of its kind.
#[derive(Clone, Copy, Debug)]
pub enum Met {
    /// A sphere.
    Sphere(usize),
    /// A plane.
    Plane(usize),
    /// A cylinder.
    Cylinder(usize),
}

/// What a ray met.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// The point that was met, moved off the surface by epsilon, towards where the ray came from.
    pub outside: Vector,
    /// Unit length, on the side the ray came from.
    pub normal: Vector,
    /// Unit length, from the surface to where the ray came from.
    pub viewer: Vector,
    /// What it is made of.
    pub material: &'a Material,
    /// How far the ray has come.
    pub distance: Real,
    /// Which of the scene's shapes it is.
    pub shape: Met,
    /// Whether it is seen from the side that its shape's normal leaves.
    pub is_inside: bool,
}

impl<'a> Scene<'a> {
    /// The nearest surface ahead.
    #[inline]
    pub fn nearest(&self, ray: &Ray) -> Option<Surface<'a>> {
        let mut reach = Real::INFINITY;
        let sphere = nearest_of(self.spheres, ray, &mut reach).map(Met::Sphere);
        let plane = nearest_of(self.planes, ray, &mut reach).map(Met::Plane);
        let cylinder = nearest_of(self.cylinders, ray, &mut reach).map(Met::Cylinder);
        // Each of them is nearer than those before.
        let shape = cylinder.or(plane).or(sphere)?;
        Some(match shape {
            Met::Sphere(index) => self.surface(ray, reach, shape, &self.spheres[index]),
            Met::Plane(index) => self.surface(ray, reach, shape, &self.planes[index]),
            Met::Cylinder(index) => self.surface(ray, reach, shape, &self.cylinders[index]),
        })
    }

    #[inline]
    fn surface(&self, ray: &Ray, distance: Real, shape: Met, it: &impl Shape) -> Surface<'a> {
        let at = ray.at(distance);
        let normal = it.normal(at);
        let is_inside = normal.dot(ray.direction) > 0.0;
        let normal = if is_inside { -normal } else { normal };
        Surface {
            outside: at + normal * self.epsilon,
            normal,
            viewer: -ray.direction,
            material: &self.materials[it.material()],
            distance,
            shape,
            is_inside,
        }
    }

    /// Whether the ray meets anything nearer than `reach`.
    #[inline]
    pub fn is_blocked(&self, ray: &Ray, reach: Real) -> bool {
        blocks(self.spheres, ray, reach)
            || blocks(self.planes, ray, reach)
            || blocks(self.cylinders, ray, reach)
    }
}

/// The nearest before `reach`, which becomes its distance.
#[inline]
fn nearest_of(shapes: &[impl Shape], ray: &Ray, reach: &mut Real) -> Option<usize> {
    let mut met = None;
    for (index, shape) in shapes.iter().enumerate() {
        if let Some(distance) = shape.meet(ray, *reach) {
            (*reach, met) = (distance, Some(index));
        }
    }
    met
}

#[inline]
fn blocks(shapes: &[impl Shape], ray: &Ray, reach: Real) -> bool {
    shapes.iter().any(|shape| shape.meet(ray, reach).is_some())
}

impl Surface<'_> {
    /// The ray that a mirror sends on.
    #[inline]
    pub fn reflected(&self) -> Ray {
        Ray {
            origin: self.outside,
            direction: self.viewer.mirrored(self.normal),
        }
    }
}
