//! From the text's scenes to the one that is meant, its names resolved; it never judges a number.

use std::borrow::ToOwned;
use std::collections::HashMap;
use std::string::String;
use std::vec::Vec;

use super::document;
use super::error::Problem;
use crate::host::reference::{Camera, Cylinder, Light, Material, Plane, Scene, Sphere};

/// How far above a surface a ray leaves it where a file does not say.
const EPSILON: f64 = 1e-3;

/// The scene called `wanted`, or the only one.
pub(super) fn choose(
    mut scenes: Vec<document::Scene>,
    wanted: Option<&str>,
) -> Result<document::Scene, Problem> {
    let Some(wanted) = wanted else {
        return match scenes.len() {
            0 => Err(Problem::Empty),
            1 => Ok(scenes.swap_remove(0)),
            _ => Err(Problem::Undecided {
                names: names(&scenes),
            }),
        };
    };
    let mut found = (0..scenes.len()).filter(|&at| scenes[at].name.as_deref() == Some(wanted));
    match (found.next(), found.next()) {
        (Some(at), None) => Ok(scenes.swap_remove(at)),
        (Some(first), Some(second)) => Err(Problem::Repeated {
            place: format!("scene {second}"),
            name: wanted.to_owned(),
            first: format!("scene {first}"),
        }),
        (None, _) if scenes.is_empty() => Err(Problem::Empty),
        (None, _) => Err(Problem::NotFound {
            wanted: wanted.to_owned(),
            names: names(&scenes),
        }),
    }
}

fn names(scenes: &[document::Scene]) -> Vec<String> {
    let name = |scene: &document::Scene| scene.name.clone().unwrap_or("(one without name)".into());
    scenes.iter().map(name).collect()
}

/// The scene with materials by number, and its camera.
pub(super) fn resolve(scene: document::Scene) -> Result<(Scene, Camera), Problem> {
    let numbers = material_numbers(&scene.materials)?;
    let number = |list: &str, index: usize, name: &str| {
        let unknown = || Problem::UnknownMaterial {
            place: format!("{list}[{index}]"),
            name: name.to_owned(),
        };
        numbers.get(name).copied().ok_or_else(unknown)
    };
    let spheres = each(&scene.spheres, |index, sphere| {
        Ok(Sphere {
            center: sphere.center,
            radius: sphere.radius,
            material: number("spheres", index, &sphere.material)?,
        })
    })?;
    let planes = each(&scene.planes, |index, plane| {
        Ok(Plane {
            point: plane.center,
            normal: plane.normal,
            material: number("planes", index, &plane.material)?,
        })
    })?;
    let cylinders = each(&scene.cylinders, |index, cylinder| {
        Ok(Cylinder {
            center: cylinder.center,
            axis: cylinder.axis,
            radius: cylinder.radius,
            height: cylinder.height,
            material: number("cylinders", index, &cylinder.material)?,
        })
    })?;
    let resolved = Scene {
        spheres,
        planes,
        cylinders,
        lights: scene.lights.iter().map(light).collect(),
        materials: scene.materials.iter().map(material).collect(),
        background: scene.background,
        epsilon: scene.epsilon.unwrap_or(EPSILON),
    };
    Ok((resolved, camera(&scene.camera)))
}

fn each<D, R>(
    list: &[D],
    mut resolve: impl FnMut(usize, &D) -> Result<R, Problem>,
) -> Result<Vec<R>, Problem> {
    let numbered = list.iter().enumerate();
    numbered.map(|(index, item)| resolve(index, item)).collect()
}

fn material_numbers(materials: &[document::Material]) -> Result<HashMap<&str, usize>, Problem> {
    let mut numbers = HashMap::new();
    for (number, material) in materials.iter().enumerate() {
        if let Some(first) = numbers.insert(material.name.as_str(), number) {
            return Err(Problem::Repeated {
                place: format!("materials[{number}]"),
                name: material.name.clone(),
                first: format!("materials[{first}]"),
            });
        }
    }
    Ok(numbers)
}

fn material(material: &document::Material) -> Material {
    Material {
        color: material.color,
        ambient: material.ambient,
        diffuse: material.diffuse,
        specular: material.specular,
        shininess: material.shininess,
        mirror: material.mirror,
    }
}

fn light(light: &document::Light) -> Light {
    Light {
        position: light.position,
        color: light.color,
    }
}

fn camera(camera: &document::Camera) -> Camera {
    Camera {
        position: camera.position,
        target: camera.target,
        up: camera.up,
        fov: camera.fov,
    }
}
