//! Converts descriptions of the core to doubles of the reference. It is the only file of the reference
//! that names types of the core.

use super::Camera;
use super::scene::{Checker, Light, Material, Scene, Sky};
use crate::number::Number;
use crate::{background, camera, checker, light, material, scene};

/// Converts a field of the core's description to one double or an array of three.
macro_rules! plain {
    (Position $value:expr) => {
        triple($value.0)
    };
    (Number $value:expr) => {
        $value.to_f64()
    };
    (Corners $value:expr) => {
        $value.positions().map(|it| triple(it.0))
    };
    (Normals $value:expr) => {
        $value.0.map(|normals| normals.map(|it| triple(it.0)))
    };
}

macro_rules! convert {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident($($field:ident: $type:ident)*) $($more:tt)*
    })*) => {
        /// Converts the description of a fixed-point scene; each number becomes the nearest double.
        ///
        /// The description's camera is not part of a scene of the reference. Convert it separately.
        ///
        /// ```
        /// use reflet::host::reference::Scene;
        /// use reflet::{Material, SceneBuilder, room};
        ///
        /// const SCENE: SceneBuilder<room!(spheres: 1)> = SceneBuilder::new()
        ///     .sphere([0.1, 0.2, 0.3], 0.7, Material::new([0.9; 3]).mirror(0.4))
        ///     .background([0.25, 0.5, 1.0]);
        ///
        /// let scene = Scene::from(&SCENE.description());
        /// assert_eq!((scene.spheres[0].center, scene.spheres[0].radius), ([0.1, 0.2, 0.3], 0.7));
        /// assert_eq!(scene.materials[scene.spheres[0].material].mirror, 0.4);
        /// assert_eq!((scene.background, scene.epsilon), ([0.25, 0.5, 1.0], 1e-3));
        /// ```
        impl From<&scene::Description<'_>> for Scene {
            fn from(description: &scene::Description<'_>) -> Self {
                $(
                    let $list = description.$list.iter().map(|it| super::$described {
                        $($field: plain!($type it.$field),)*
                        material: it.material.index(),
                    });
                )*
                Self {
                    $($list: $list.collect(),)*
                    lights: description.lights.iter().map(light).collect(),
                    materials: description.materials.iter().map(material).collect(),
                    background: triple(description.background),
                    sky: description.sky.as_ref().map(sky),
                    epsilon: description.epsilon.to_f64(),
                }
            }
        }
    };
}
kinds!(shapes, convert);

/// Converts the description of a fixed-point camera; each number becomes the nearest double.
impl From<&camera::CameraDescription> for Camera {
    fn from(description: &camera::CameraDescription) -> Self {
        Self {
            position: triple(description.position.0),
            target: triple(description.target.0),
            up: triple(description.up.0),
            fov: description.fov.to_f64(),
        }
    }
}

/// Converts a fixed-point camera back to the numbers it was described with, as doubles.
impl From<&camera::Camera> for Camera {
    fn from(camera: &camera::Camera) -> Self {
        (&camera.description()).into()
    }
}

fn sky(sky: &background::Sky) -> Sky {
    Sky {
        up: triple(sky.up.0),
        below: triple(sky.below),
        horizon: triple(sky.horizon),
        above: triple(sky.above),
    }
}

fn light(light: &light::Light) -> Light {
    Light {
        position: triple(light.position.0),
        color: triple(light.color),
        sun: light.sun.map(Number::to_f64),
        range: light.range.map(Number::to_f64),
    }
}

fn material(material: &material::Material) -> Material {
    let coefficients = material.described_coefficients().map(Number::to_f64);
    let [ambient, diffuse, specular, shininess, mirror] = coefficients;
    Material {
        color: triple(material.described_color()),
        ambient,
        diffuse,
        specular,
        shininess,
        mirror,
        checker: material.described_checker().as_ref().map(checker),
    }
}

fn checker(checker: &checker::Checker) -> Checker {
    Checker {
        color: triple(checker.color),
        size: triple(checker.size),
    }
}

fn triple(numbers: [Number; 3]) -> [f64; 3] {
    numbers.map(Number::to_f64)
}

#[cfg(test)]
mod tests;
