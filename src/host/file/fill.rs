//! Fills a run-time scene of the core from a scene of the reference, through the public methods. This
//! file has no checks of its own.

use alloc::vec::Vec;

use super::{FileRuntimeScene, MAX_LIGHTS, MAX_SUNS};
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::host::reference;
use crate::material::Material;

macro_rules! fill {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident($($field:ident: $type:ident)*) $($more:tt)*
    })*) => {
        /// Adds every material, light and shape of `scene` to `target`; sets background and epsilon.
        pub(super) fn scene(
            target: &mut FileRuntimeScene,
            scene: &reference::Scene,
        ) -> Result<(), Error> {
            let mut ids = Vec::with_capacity(scene.materials.len());
            for (index, plain) in scene.materials.iter().enumerate() {
                ids.push(target.add_material(material(index, plain)?)?);
            }
            lights(target, &scene.lights)?;
            $(
                for it in &scene.$list {
                    target.$add($(it.$field,)* ids[it.material])?;
                }
            )*
            match scene.sky {
                Some(it) => target.set_sky(it.up, [it.below, it.horizon, it.above])?,
                None => target.set_background(scene.background)?,
            }
            target.set_epsilon(scene.epsilon)
        }
    };
}
kinds!(shapes, fill);

/// Adds the lights. Lamps and suns are counted apart, as in a file.
fn lights(target: &mut FileRuntimeScene, lights: &[reference::Light]) -> Result<(), Error> {
    let (mut lamps, mut suns) = (0, 0);
    for light in lights {
        let (part, count, most) = match light.sun {
            None => ("light", &mut lamps, MAX_LIGHTS),
            Some(_) => ("sun", &mut suns, MAX_SUNS),
        };
        let at = |kind| Error::at(part, *count, kind);
        if *count == most {
            return Err(at(ErrorKind::TooManyLights));
        }
        let (position, color) = (light.position, light.color);
        let added = match (light.sun, light.range) {
            (None, None) => target.add_light(position, color),
            (None, Some(range)) => target.add_light_with_range(position, color, range),
            (Some(disc), None) => target.add_sun(position, color, disc),
            (Some(_), Some(_)) => return Err(at(ErrorKind::Range)),
        };
        added.map_err(|error| at(error.kind()))?;
        *count += 1;
    }
    Ok(())
}

/// Converts a camera of the reference to one of the core.
pub(super) fn camera(camera: &reference::Camera) -> Result<Camera, Error> {
    Camera::new(camera.position, camera.target, camera.up, camera.fov)
}

fn material(index: usize, plain: &reference::Material) -> Result<Material, Error> {
    let highlight = (plain.specular, plain.shininess);
    let made = Material::from_numbers(
        plain.color,
        plain.ambient,
        plain.diffuse,
        highlight,
        plain.mirror,
    );
    let made = made.and_then(|made| match &plain.checker {
        Some(checker) => made.with_checker(checker.color, checker.size),
        None => Ok(made),
    });
    made.map_err(|error| Error::at("material", index, error.kind()))
}
