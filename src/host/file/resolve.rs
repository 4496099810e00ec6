//! Chooses one scene of a file by name and replaces material names by numbers. This file never checks
//! other values.

use alloc::borrow::ToOwned;
use alloc::collections::BTreeMap;
use alloc::string::String;
use alloc::vec::Vec;

use super::document;
use super::error::Problem;
use crate::host::reference::{self, Camera, EPSILON, Light, Material, Scene};
use crate::number::Number;

/// Returns the scene called `wanted`, or the only scene if `wanted` is `None`.
pub(super) fn choose(
    mut scenes: Vec<document::Scene>,
    wanted: Option<&str>,
) -> Result<document::Scene, Problem> {
    let is_meant = |at: &usize| wanted.is_none_or(|it| scenes[*at].name.as_deref() == Some(it));
    let mut meant = (0..scenes.len()).filter(is_meant);
    let names = names(&scenes);
    match (meant.next(), meant.next(), wanted) {
        (Some(at), None, _) => Ok(scenes.swap_remove(at)),
        _ if scenes.is_empty() => Err(Problem::Empty),
        (_, _, None) => Err(Problem::Undecided { names }),
        (Some(first), Some(second), Some(wanted)) => Err(Problem::Repeated {
            place: format!("scene {second}"),
            name: wanted.to_owned(),
            first: format!("scene {first}"),
        }),
        (None, _, Some(wanted)) => Err(Problem::NotFound {
            wanted: wanted.to_owned(),
            names,
        }),
    }
}

fn names(scenes: &[document::Scene]) -> Vec<String> {
    let name = |scene: &document::Scene| scene.name.clone().unwrap_or("(one without name)".into());
    scenes.iter().map(name).collect()
}

macro_rules! resolve {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident($($field:ident: $type:ident)*) $($more:tt)*
    })*) => {
        /// Returns the scene for the reference, with each material name replaced by its index, and the
        /// camera.
        pub(super) fn resolve(scene: document::Scene) -> Result<(Scene, Camera), Problem> {
            if scene.background.is_some() && scene.sky.is_some() {
                return Err(Problem::TwoBackgrounds);
            }
            let numbers = material_numbers(&scene.materials)?;
            let number = |list: &str, index: usize, name: &str| {
                let unknown = || Problem::UnknownMaterial {
                    place: format!("{list}[{index}]"),
                    name: name.to_owned(),
                };
                numbers.get(name).copied().ok_or_else(unknown)
            };
            $(
                let mut $list = Vec::with_capacity(scene.$list.len());
                for (index, it) in scene.$list.iter().enumerate() {
                    $list.push(reference::$described {
                        $($field: it.$field,)*
                        material: number(stringify!($list), index, &it.material)?,
                    });
                }
            )*
            let resolved = Scene {
                $($list,)*
                lights: scene.lights.into_iter().chain(scene.suns.iter().map(sun)).collect(),
                materials: scene.materials.iter().map(material).collect(),
                background: scene.background.unwrap_or_default(),
                sky: scene.sky,
                epsilon: scene.epsilon.unwrap_or(EPSILON),
            };
            Ok((resolved, scene.camera))
        }
    };
}
kinds!(shapes, resolve);

fn material_numbers(materials: &[document::Material]) -> Result<BTreeMap<&str, usize>, Problem> {
    let mut numbers = BTreeMap::new();
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

/// Returns a sun; without `disc` no disc of it is seen.
fn sun(sun: &document::Sun) -> Light {
    Light {
        position: sun.direction,
        color: sun.color,
        sun: Some(sun.disc.unwrap_or(0.0)),
        range: None,
    }
}

/// Returns the material with the defaults of [`crate::Material::new`] for what the file leaves out.
fn material(material: &document::Material) -> Material {
    const PLAIN: crate::Material = crate::Material::new([0.0; 3]);
    let defaults = PLAIN.described_coefficients().map(Number::to_f64);
    let [ambient, diffuse, specular, shininess, mirror] = defaults;
    Material {
        color: material.color,
        ambient: material.ambient.unwrap_or(ambient),
        diffuse: material.diffuse.unwrap_or(diffuse),
        specular: material.specular.unwrap_or(specular),
        shininess: material.shininess.unwrap_or(shininess),
        mirror: material.mirror.unwrap_or(mirror),
        checker: material.checker,
    }
}
