//! One ray to one colour.

use crate::scene::Scene;
use crate::shade::{Shading, Surface, own_color};
use crate::shape::Ray;
use crate::vector::Vector;

/// Follows a ray for at most `reflections` reflections.
#[inline]
pub fn color(scene: &Scene, shading: Shading, mut ray: Ray, reflections: u32) -> Vector {
    let mut color = Vector::ZERO;
    let mut weight = 1.0;
    for _ in 0..=reflections {
        let Some(surface) = nearest(scene, &ray) else {
            return color + scene.background * weight;
        };
        let viewer = ray.direction * -1.0;
        let mirror = surface.material.mirror;
        if mirror < 1.0 {
            let own = own_color(scene, &surface, viewer, shading);
            color = color + own * (weight * (1.0 - mirror));
        }
        weight *= mirror;
        if weight == 0.0 {
            break;
        }
        ray = Ray {
            origin: surface.outside,
            direction: ray.direction.mirrored(surface.normal),
        };
    }
    color
}

/// The normal as a colour, or blue.
pub fn normal(scene: &Scene, ray: &Ray) -> Vector {
    nearest(scene, ray).map_or(Vector::new(0.0, 0.0, 1.0), |surface| {
        (surface.normal + Vector::new(1.0, 1.0, 1.0)) * 0.5
    })
}

enum Met {
    Nothing,
    Sphere(usize),
    Plane(usize),
    Cylinder(usize),
}

fn nearest<'a>(scene: &Scene<'a>, ray: &Ray) -> Option<Surface<'a>> {
    let mut reach = f32::INFINITY;
    let mut met = Met::Nothing;
    for (index, sphere) in scene.spheres.iter().enumerate() {
        if let Some(distance) = sphere.meet(ray, reach) {
            (reach, met) = (distance, Met::Sphere(index));
        }
    }
    for (index, plane) in scene.planes.iter().enumerate() {
        if let Some(distance) = plane.meet(ray, reach) {
            (reach, met) = (distance, Met::Plane(index));
        }
    }
    for (index, cylinder) in scene.cylinders.iter().enumerate() {
        if let Some(distance) = cylinder.meet(ray, reach) {
            (reach, met) = (distance, Met::Cylinder(index));
        }
    }
    let at = ray.at(reach);
    let (normal, material) = match met {
        Met::Nothing => return None,
        Met::Sphere(index) => {
            let sphere = &scene.spheres[index];
            (sphere.normal(at), sphere.material)
        }
        Met::Plane(index) => (scene.planes[index].normal, scene.planes[index].material),
        Met::Cylinder(index) => {
            let cylinder = &scene.cylinders[index];
            (cylinder.normal(at), cylinder.material)
        }
    };
    let normal = if normal.dot(ray.direction) > 0.0 {
        normal * -1.0
    } else {
        normal
    };
    Some(Surface {
        outside: at + normal * scene.epsilon,
        normal,
        material: &scene.materials[material],
    })
}
