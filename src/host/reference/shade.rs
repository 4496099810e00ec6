//! The light that a surface itself sends to the viewer; it never asks what the surface mirrors.

use super::Real;
use super::scene::Light;
use super::shape::Ray;
use super::vector::Vector;
use super::world::{Surface, World, mirrored};

/// The cosine that a highlight is a power of, from the surface and the unit vector to the light.
pub(super) type Gleam = fn(&Surface, Vector) -> Real;

/// Between the normal and the vector half-way from the light to the viewer.
pub(super) fn blinn_phong(surface: &Surface, to_light: Vector) -> Real {
    surface.normal.dot((to_light + surface.viewer).unit())
}

/// Between the mirrored light and the viewer.
pub(super) fn phong(surface: &Surface, to_light: Vector) -> Real {
    mirrored(to_light, surface.normal).dot(surface.viewer)
}

/// Ambient, diffuse and specular light at a surface, in the surface's colour.
pub(super) fn own_color(world: &World, surface: &Surface, gleam: Gleam) -> Vector {
    let mut light = Vector::grey(surface.material.ambient as Real);
    for lamp in &world.scene.lights {
        light += Vector::of(lamp.color) * strength(world, surface, lamp, gleam);
    }
    Vector::of(surface.material.color).filtered(light)
}

/// How much of a light's colour comes to the viewer; nothing where it is behind or blocked.
pub(super) fn strength(world: &World, surface: &Surface, lamp: &Light, gleam: Gleam) -> Real {
    let to_lamp = Vector::of(lamp.position) - surface.outside;
    let distance = to_lamp.length();
    let ray = Ray {
        origin: surface.outside,
        direction: to_lamp * (1.0 / distance),
    };
    let facing = surface.normal.dot(ray.direction);
    // A lamp exactly here has no direction, and what is not a number is not above zero.
    let is_lit = facing > 0.0 && !world.is_blocked(&ray, distance - world.scene.epsilon as Real);
    if !is_lit {
        return 0.0;
    }
    let material = surface.material;
    let highlight = gleam(surface, ray.direction)
        .max(0.0)
        .powf(material.shininess as Real);
    material.diffuse as Real * facing + material.specular as Real * highlight
}
