//! From descriptions in doubles to what the model follows rays through: numbers rounded to `Real`,
//! and directions made unit length.

use std::vec::Vec;

use super::{Camera, Real, Scene, model};

/// A scene made ready for rays; it owns the lists of a [`model::Scene`].
#[derive(Clone, Debug)]
pub struct Prepared {
    spheres: Vec<model::Sphere>,
    planes: Vec<model::Plane>,
    cylinders: Vec<model::Cylinder>,
    lights: Vec<model::Light>,
    materials: Vec<model::Material>,
    background: model::Vector,
    epsilon: Real,
}

impl Prepared {
    /// Makes a scene ready.
    ///
    /// # Panics
    ///
    /// A shape names a material that the scene does not have.
    pub fn new(scene: &Scene) -> Self {
        let known = |material: usize| {
            assert!(material < scene.materials.len(), "no material {material}");
            material
        };
        let spheres = scene.spheres.iter().map(|sphere| model::Sphere {
            center: vector(sphere.center),
            radius: sphere.radius as Real,
            material: known(sphere.material),
        });
        let planes = scene.planes.iter().map(|plane| model::Plane {
            point: vector(plane.point),
            normal: vector(plane.normal).unit(),
            material: known(plane.material),
        });
        let cylinders = scene.cylinders.iter().map(|cylinder| model::Cylinder {
            center: vector(cylinder.center),
            axis: vector(cylinder.axis).unit(),
            radius: cylinder.radius as Real,
            half_height: cylinder.height as Real / 2.0,
            material: known(cylinder.material),
        });
        let lights = scene.lights.iter().map(|light| model::Light {
            position: vector(light.position),
            color: vector(light.color),
        });
        let materials = scene.materials.iter().map(|material| model::Material {
            color: vector(material.color),
            ambient: material.ambient as Real,
            diffuse: material.diffuse as Real,
            specular: material.specular as Real,
            shininess: material.shininess as Real,
            mirror: material.mirror as Real,
        });
        Self {
            spheres: spheres.collect(),
            planes: planes.collect(),
            cylinders: cylinders.collect(),
            lights: lights.collect(),
            materials: materials.collect(),
            background: vector(scene.background),
            epsilon: scene.epsilon as Real,
        }
    }

    /// What rays are followed through.
    pub fn scene(&self) -> model::Scene<'_> {
        model::Scene {
            spheres: &self.spheres,
            planes: &self.planes,
            cylinders: &self.cylinders,
            lights: &self.lights,
            materials: &self.materials,
            background: self.background,
            epsilon: self.epsilon,
        }
    }
}

/// A camera, of which a [`model::View`] is made.
pub fn camera(camera: &Camera) -> model::Camera {
    model::Camera {
        position: vector(camera.position),
        target: vector(camera.target),
        up: vector(camera.up),
        fov: camera.fov as Real,
    }
}

fn vector(numbers: [f64; 3]) -> model::Vector {
    model::Vector(numbers.map(|number| number as Real))
}
