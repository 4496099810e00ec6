//! What a ray meets in a whole scene, and the one place that steps off a surface; it knows no
//! colour but hands on the material.

use std::vec::Vec;

use super::Real;
use super::scene::{Material, Scene};
use super::shape::{Ray, Shape};
use super::vector::Vector;

/// A scene made ready for rays.
pub(super) struct World<'a> {
    pub scene: &'a Scene,
    solids: Vec<Solid<'a>>,
}

struct Solid<'a> {
    shape: Shape,
    material: &'a Material,
}

/// What a ray met.
pub(super) struct Surface<'a> {
    /// The point that was met, moved off the surface by epsilon, towards where the ray came from.
    pub outside: Vector,
    /// Unit length, on the side the ray came from.
    pub normal: Vector,
    /// Unit length, from the surface to where the ray came from.
    pub viewer: Vector,
    pub material: &'a Material,
    /// How far the ray has come.
    pub distance: Real,
    /// Which of the scene's shapes it is, and one over its radius; 0 of a plane.
    pub shape: usize,
    pub curvature: Real,
    /// Whether it is seen from the side that its shape's normal leaves.
    pub is_inside: bool,
}

impl<'a> World<'a> {
    pub fn new(scene: &'a Scene) -> Self {
        let solid = |shape, material: usize| Solid {
            shape,
            material: &scene.materials[material],
        };
        let spheres = scene.spheres.iter().map(|it| solid(it.into(), it.material));
        let planes = scene.planes.iter().map(|it| solid(it.into(), it.material));
        let cylinders = scene
            .cylinders
            .iter()
            .map(|it| solid(it.into(), it.material));
        Self {
            scene,
            solids: spheres.chain(planes).chain(cylinders).collect(),
        }
    }

    /// The nearest surface ahead.
    pub fn nearest(&self, ray: &Ray) -> Option<Surface<'a>> {
        let mut reach = Real::INFINITY;
        let mut met = None;
        for (index, solid) in self.solids.iter().enumerate() {
            if let Some(distance) = solid.shape.meet(ray).filter(|it| *it < reach) {
                reach = distance;
                met = Some((index, solid));
            }
        }
        let (shape, solid) = met?;
        let at = ray.at(reach);
        let normal = solid.shape.normal(at);
        let is_inside = normal.dot(ray.direction) > 0.0;
        let normal = if is_inside { -normal } else { normal };
        Some(Surface {
            outside: at + normal * self.scene.epsilon as Real,
            normal,
            viewer: -ray.direction,
            material: solid.material,
            distance: reach,
            shape,
            curvature: solid.shape.curvature(),
            is_inside,
        })
    }

    /// Whether the ray meets anything nearer than `reach`.
    pub fn is_blocked(&self, ray: &Ray, reach: Real) -> bool {
        let blocks = |solid: &Solid| solid.shape.meet(ray).is_some_and(|it| it < reach);
        self.solids.iter().any(blocks)
    }
}

impl Surface<'_> {
    /// The ray that a mirror sends on.
    pub fn reflected(&self) -> Ray {
        Ray {
            origin: self.outside,
            direction: mirrored(self.viewer, self.normal),
        }
    }
}

/// `leaving` turned to the other side of `normal`: both unit length, both away from the surface.
pub(super) fn mirrored(leaving: Vector, normal: Vector) -> Vector {
    normal * (2.0 * normal.dot(leaving)) - leaving
}
