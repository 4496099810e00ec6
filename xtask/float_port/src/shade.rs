//! The light at one hit.

use crate::float::power;
use crate::scene::{Light, Material, Scene};
use crate::shape::Ray;
use crate::vector::Vector;

/// How light shines on a surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// The highlight by the vector half-way from the light to the viewer.
    BlinnPhong,
    /// The highlight by the mirrored light.
    Phong,
    /// No light: normals as colours.
    Normals,
}

/// A place that a ray has met.
pub struct Surface<'a> {
    /// Epsilon above the place, where rays leave it.
    pub outside: Vector,
    pub normal: Vector,
    pub material: &'a Material,
}

/// Ambient, diffuse and specular light.
#[inline]
pub fn own_color(scene: &Scene, surface: &Surface, viewer: Vector, shading: Shading) -> Vector {
    let ambient = surface.material.ambient;
    let mut light = Vector::new(ambient, ambient, ambient);
    for lamp in scene.lights {
        light = light + lamp.color * strength(scene, surface, viewer, lamp, shading);
    }
    surface.material.color.filtered(light)
}

#[inline]
fn strength(
    scene: &Scene,
    surface: &Surface,
    viewer: Vector,
    lamp: &Light,
    shading: Shading,
) -> f32 {
    let to_lamp = lamp.position - surface.outside;
    let facing = surface.normal.dot(to_lamp);
    if facing <= 0.0 {
        return 0.0;
    }
    let distance = to_lamp.length();
    let direction = to_lamp * (1.0 / distance);
    let ray = Ray {
        origin: surface.outside,
        direction,
    };
    if is_blocked(scene, &ray, distance - scene.epsilon) {
        return 0.0;
    }
    let material = surface.material;
    let diffuse = material.diffuse * (facing / distance);
    let cosine = match shading {
        Shading::Phong => (direction * -1.0).mirrored(surface.normal).dot(viewer),
        _ => (direction + viewer).unit().dot(surface.normal),
    };
    if material.specular == 0.0 {
        return diffuse;
    }
    diffuse + material.specular * power(cosine.max(0.0), material.shininess)
}

#[inline]
fn is_blocked(scene: &Scene, ray: &Ray, reach: f32) -> bool {
    scene
        .spheres
        .iter()
        .any(|sphere| sphere.meet(ray, reach).is_some())
        || scene
            .planes
            .iter()
            .any(|plane| plane.meet(ray, reach).is_some())
        || scene
            .cylinders
            .iter()
            .any(|cylinder| cylinder.meet(ray, reach).is_some())
}
