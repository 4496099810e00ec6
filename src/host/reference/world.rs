//! What a ray meets in a whole scene, and the one place that steps off a surface; it knows no
//! colour but hands on the material.

use std::vec::Vec;

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
    pub distance: f64,
    /// Which of the scene's shapes it is, and one over its radius; 0 of a plane.
    pub shape: usize,
    pub curvature: f64,
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
        let mut reach = f64::INFINITY;
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
            outside: at + normal * self.scene.epsilon,
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
    pub fn is_blocked(&self, ray: &Ray, reach: f64) -> bool {
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

#[cfg(test)]
mod tests {
    use std::vec;

    use super::*;
    use crate::host::reference::{Cylinder, Plane, Sphere};

    fn material(mirror: f64) -> Material {
        Material {
            color: [1.0; 3],
            ambient: 1.0,
            diffuse: 0.0,
            specular: 0.0,
            shininess: 1.0,
            mirror,
        }
    }

    /// Along y: a sphere from 4 to 6, a plane at 9, a tube's walls at 12 and 14; α numbers them.
    fn row() -> Scene {
        Scene {
            spheres: vec![Sphere {
                center: [0.0, 5.0, 0.0],
                radius: 1.0,
                material: 0,
            }],
            planes: vec![Plane {
                point: [3.0, 9.0, 1.0],
                normal: [0.0, 0.5, 0.0],
                material: 1,
            }],
            cylinders: vec![Cylinder {
                center: [0.0, 13.0, 0.0],
                axis: [0.0, 0.0, 1.0],
                radius: 1.0,
                height: 1.0,
                material: 2,
            }],
            materials: vec![material(0.0), material(0.1), material(0.2)],
            epsilon: 0.25,
            ..Scene::default()
        }
    }

    fn along_y(from: f64, way: f64) -> Ray {
        Ray {
            origin: Vector([0.0, from, 0.0]),
            direction: Vector([0.0, way, 0.0]),
        }
    }

    #[test]
    fn nearest_surface_ahead_is_met_and_faces_the_ray() {
        let scene = row();
        let world = World::new(&scene);
        let cases = [
            (0.0, 1.0, 4.0, 0.0),
            (5.0, 1.0, 6.0, 0.0),
            (7.0, -1.0, 6.0, 0.0),
            (7.0, 1.0, 9.0, 0.1),
            (11.0, -1.0, 9.0, 0.1),
            (11.0, 1.0, 12.0, 0.2),
            (13.0, 1.0, 14.0, 0.2),
            (15.0, -1.0, 14.0, 0.2),
        ];
        for (from, way, expected, mirror) in cases {
            let surface = world.nearest(&along_y(from, way)).unwrap();
            let back = Vector([0.0, -way, 0.0]);
            assert_eq!(surface.material.mirror, mirror);
            assert_eq!((surface.normal, surface.viewer), (back, back));
            assert_eq!(surface.outside, Vector([0.0, expected - way * 0.25, 0.0]));
        }
        assert!(world.nearest(&along_y(0.0, -1.0)).is_none());
        assert!(world.nearest(&along_y(15.0, 1.0)).is_none());
    }

    #[test]
    fn only_what_is_nearer_than_the_reach_blocks() {
        let scene = row();
        let world = World::new(&scene);
        let ray = along_y(0.0, 1.0);
        assert!(!world.is_blocked(&ray, 4.0));
        assert!(world.is_blocked(&ray, 4.0 + 1e-12));
        assert!(!world.is_blocked(&along_y(15.0, 1.0), f64::INFINITY));
    }

    #[test]
    fn reflected_ray_leaves_as_steeply_as_the_ray_came() {
        let ground = material(1.0);
        let surface = Surface {
            outside: Vector([1.0, 2.0, 3.0]),
            normal: Vector([0.0, 0.0, 1.0]),
            viewer: Vector([-0.6, 0.0, 0.8]),
            material: &ground,
            distance: 1.0,
            shape: 0,
            curvature: 0.0,
            is_inside: false,
        };
        let Ray { origin, direction } = surface.reflected();
        assert_eq!(origin, surface.outside);
        assert!(
            (direction - Vector([0.6, 0.0, 0.8])).length() < 1e-15,
            "{direction:?}"
        );
    }
}
