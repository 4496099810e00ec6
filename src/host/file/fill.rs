//! Fills a run-time scene of the core from a scene of the reference, through the public methods. This
//! file has no checks of its own.

use alloc::vec::Vec;

use super::error::{FileError, Problem};
use super::{MAX_LIGHTS, MAX_SUNS, SceneFile};
use crate::camera::Camera;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::host::reference;
use crate::material::Material;
use crate::scene::{Capacity, RuntimeScene};

macro_rules! fill {
    ($parameters:tt $({
        $list:ident $kind:ident $described:ident $add:ident($($field:ident: $type:ident)*) $($more:tt)*
    })*) => {
        /// Adds every material, light and shape of `scene` to `target`; sets background and epsilon.
        fn scene<R: Capacity>(
            target: &mut RuntimeScene<R>,
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
fn lights<R: Capacity>(
    target: &mut RuntimeScene<R>,
    lights: &[reference::Light],
) -> Result<(), Error> {
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

impl SceneFile {
    /// Adds all parts of the scene to one with a room of your own, and sets its camera, which is returned. A board has no
    /// room for a [`FileScene`](super::FileScene): that takes 400 kB, whatever the file holds.
    ///
    /// # Errors
    ///
    /// The core refuses a part of the scene, or `scene` has no room for it.
    ///
    /// ```
    /// use reflet::host::file::SceneFile;
    /// use reflet::{RuntimeScene, room};
    ///
    /// let file = SceneFile::parse(
    ///     r#"{
    ///         "camera": {"position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50},
    ///         "materials": [{"name": "chalk", "color": [0.9, 0.9, 0.9]}],
    ///         "lights": [{"position": [3, -4, 6], "color": [1, 1, 1]}],
    ///         "spheres": [{"center": [0, 0, 1], "radius": 1, "material": "chalk"}]
    ///     }"#,
    ///     None,
    /// )?;
    /// let mut scene = RuntimeScene::<room!(spheres: 8, lights: 2, materials: 4)>::new();
    /// let camera = file.fill(&mut scene)?;
    /// let scene = scene.build()?;
    /// let frame = scene.frame(&camera);
    ///
    /// let error = file.fill(&mut RuntimeScene::<room!(spheres: 1, materials: 1)>::new()).unwrap_err();
    /// assert_eq!(error.to_string(), "lights[0]: there is room for 0 lights at most");
    /// # let _ = frame;
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[inline]
    pub fn fill<R: Capacity>(&self, scene: &mut RuntimeScene<R>) -> Result<Camera, FileError> {
        let filled = filled(scene, (&self.scene, &self.camera));
        filled.map_err(|problem| self.error(problem))
    }
}

/// Fills a scene, and sets its camera.
#[inline]
pub(super) fn filled<R: Capacity>(
    target: &mut RuntimeScene<R>,
    (from, view): (&reference::Scene, &reference::Camera),
) -> Result<Camera, Problem> {
    scene(target, from).map_err(Problem::Scene)?;
    let camera = camera(view).map_err(Problem::Camera)?;
    target.set_camera(camera);
    Ok(camera)
}

/// Converts a camera of the reference to one of the core.
fn camera(camera: &reference::Camera) -> Result<Camera, Error> {
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
