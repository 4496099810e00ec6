//! Scene files: reads JSON and returns a scene for the reference and one for the core. This module owns
//! the format, and reports where in a file each mistake is. It never draws.
//!
//! A file is one scene, or an array of scenes of which one is chosen by its name:
//!
//! ```json
//! {
//!   "name": "ball",
//!   "camera": { "position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50 },
//!   "materials": [
//!     { "name": "gold", "color": [0.7, 0.6, 0], "ambient": 0.2, "diffuse": 0.4,
//!       "specular": 0.8, "shininess": 4, "mirror": 0.4 }
//!   ],
//!   "lights": [ { "position": [3, -4, 6], "color": [1, 1, 1] } ],
//!   "spheres": [ { "center": [0, 0, 1], "radius": 1, "material": "gold" } ],
//!   "planes": [ { "center": [0, 0, 0], "normal": [0, 0, 1], "material": "gold" } ],
//!   "cylinders": [
//!     { "center": [2, 0, 1], "axis": [0, 0, 1], "radius": 0.5, "height": 2, "material": "gold" }
//!   ],
//!   "discs": [ { "center": [2, 0, 2], "normal": [0, 0, 1], "radius": 0.5, "material": "gold" } ],
//!   "triangles": [ { "corners": [[0, 0, 3], [1, 0, 3], [0, 1, 3]], "material": "gold" } ],
//!   "background": [0, 0, 0],
//!   "epsilon": 0.001
//! }
//! ```
//!
//! `name`, `background`, `epsilon` and every list are optional. A list that is left out is empty;
//! `background` and `epsilon` have the values above by default. Of a material, `name` and `color` are
//! enough: the rest has the defaults of [`Material::new`](crate::Material::new). An unknown key is an
//! error. A triangle may have `normals`. `docs/scene.schema.json` in the repository is a JSON Schema of this format. A
//! scene may name it by a key `$schema`, which is ignored here, so that editors complete and check the file.

// What reads a file is `#[inline]`: a program then compiles it as it compiles itself, small or fast.

pub(super) mod document;
mod error;
mod fill;
#[cfg(feature = "host")]
mod read;
mod resolve;
mod source;
mod words;

use alloc::boxed::Box;
use alloc::string::String;
use alloc::vec::Vec;

pub use self::error::{FileError, Problem};
pub use self::source::RustSource;
use crate::camera;
use crate::error_kind::ErrorKind;
use crate::host::reference::{Camera, Scene};
use crate::scene::{Room, RuntimeScene, extent_of};

/// Largest size of a scene file in bytes: 16 MB.
pub const MAX_BYTES: u64 = 16_000_000;

/// Largest number of spheres in a scene that is read from a scene file: 512.
pub const MAX_SPHERES: usize = 512;

/// Largest number of planes in a scene that is read from a scene file: 32.
pub const MAX_PLANES: usize = 32;

/// Largest number of cylinders in a scene that is read from a scene file: 128.
pub const MAX_CYLINDERS: usize = 128;

/// Largest number of discs in a scene that is read from a scene file: 128.
pub const MAX_DISCS: usize = 128;

/// Largest number of triangles in a scene that is read from a scene file: 256.
pub const MAX_TRIANGLES: usize = 256;

/// Largest number of lights in a scene that is read from a scene file: 16.
pub const MAX_LIGHTS: usize = 16;

/// Largest number of suns in a scene that is read from a scene file: 2.
pub const MAX_SUNS: usize = 2;

/// Largest number of materials in a scene that is read from a scene file: 256.
pub const MAX_MATERIALS: usize = 256;

/// Capacity of a scene that is read from a scene file: the `MAX_` limit of each kind of part.
///
/// ```
/// use reflet::host::file::{FileRuntimeScene, FileScene, MAX_CYLINDERS, MAX_DISCS, MAX_LIGHTS};
/// use reflet::host::file::{MAX_MATERIALS, MAX_PLANES, MAX_SPHERES, MAX_SUNS, MAX_TRIANGLES};
/// use reflet::host::reference::Scene;
///
/// /// Tests whether a file with this scene can be read.
/// fn fits(scene: &Scene) -> bool {
///     scene.spheres.len() <= MAX_SPHERES
///         && scene.planes.len() <= MAX_PLANES
///         && scene.cylinders.len() <= MAX_CYLINDERS
///         && scene.discs.len() <= MAX_DISCS
///         && scene.triangles.len() <= MAX_TRIANGLES
///         && scene.lights.len() <= MAX_LIGHTS + MAX_SUNS
///         && scene.materials.len() <= MAX_MATERIALS
/// }
/// assert!(fits(&Scene::default()));
/// let built: FileScene = FileRuntimeScene::new().build()?;
/// assert!(built.needs().is_nothing());
/// # Ok::<(), reflet::Error>(())
/// ```
pub type FileRoom = Room<
    MAX_SPHERES,
    MAX_PLANES,
    MAX_CYLINDERS,
    { MAX_LIGHTS + MAX_SUNS },
    MAX_MATERIALS,
    MAX_DISCS,
    MAX_TRIANGLES,
>;

/// A run-time scene with the capacity [`FileRoom`], to be filled from a scene file.
pub type FileRuntimeScene = RuntimeScene<FileRoom>;

/// A prepared scene of a file. A thread that builds one needs more stack than the 2 MiB that Rust gives it by default.
pub type FileScene = crate::Scene<FileRoom>;

/// Builds a scene of the core, with the capacity [`FileRoom`], from a scene and a camera of the
/// reference.
///
/// The camera is set before the scene is built. A core scene that was described with decimal literals
/// and converted to the reference is built again without a change, because each literal is a double.
///
/// # Errors
///
/// The core refuses a part of the scene or the scene as a whole, or there are more parts than a file
/// may hold.
pub fn built(scene: &Scene, camera: &Camera) -> Result<Box<FileScene>, FileError> {
    let filled = filled(scene, camera).and_then(|(target, _)| build(&target));
    filled.map_err(FileError::new)
}

#[inline]
fn filled(
    scene: &Scene,
    camera: &Camera,
) -> Result<(Box<FileRuntimeScene>, camera::Camera), Problem> {
    let mut target = Box::new(FileRuntimeScene::new());
    let camera = fill::filled(&mut target, (scene, camera))?;
    Ok((target, camera))
}

#[inline]
fn build(scene: &FileRuntimeScene) -> Result<Box<FileScene>, Problem> {
    scene.build().map(Box::new).map_err(|error| {
        let extent = extent_of(&scene.description());
        match extent.filter(|_| error.kind() == ErrorKind::Tiny) {
            Some(extent) => Problem::TooSmall { error, extent },
            None => Problem::Scene(error),
        }
    })
}

/// A scene that was read from a scene file, with every material name resolved.
///
/// The numbers are not checked yet: [`SceneFile::runtime`] tests whether the core accepts them.
///
/// ```
/// use reflet::host::file::{MAX_BYTES, SceneFile};
///
/// let camera = r#"{"position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50}"#;
/// let text = format!(r#"{{"camera": {camera}, "background": [0, 0, 9]}}"#);
/// assert!((text.len() as u64) < MAX_BYTES);
/// let file = SceneFile::parse(&text, None).unwrap();
/// let (scene, camera) = file.runtime().unwrap();
/// assert_eq!(scene.description().background, [0, 0, 9].map(reflet::Number::from));
/// assert_eq!(scene.description().camera, Some(camera));
///
/// let (reference, _) = file.reference();
/// assert_eq!(reference.background, [0.0, 0.0, 9.0]);
/// assert!(file.materials().is_empty() && file.build().is_ok());
/// assert!(SceneFile::read("no such file", None).is_err());
/// ```
#[derive(Clone, Debug)]
pub struct SceneFile {
    #[cfg(feature = "host")]
    path: Option<std::path::PathBuf>,
    name: Option<String>,
    materials: Vec<String>,
    scene: Scene,
    camera: Camera,
}

impl SceneFile {
    /// Reads the scene called `name` from JSON `text`, or the only scene if `name` is `None`.
    ///
    /// # Errors
    ///
    /// The text is not the JSON of a scene; it has no scene of that name; it has several scenes and no
    /// name is given; a name is used twice; or the material of a shape is missing.
    ///
    /// ```
    /// use reflet::host::file::SceneFile;
    ///
    /// let camera = r#"{"position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50}"#;
    /// let text = format!(r#"[{{"name": "a", "camera": {camera}}}, {{"name": "b", "camera": {camera}}}]"#);
    ///
    /// assert_eq!(SceneFile::parse(&text, Some("b")).unwrap().name(), Some("b"));
    /// assert_eq!(
    ///     SceneFile::parse(&text, None).unwrap_err().to_string(),
    ///     "choose one of the scenes a, b"
    /// );
    /// ```
    #[inline]
    pub fn parse(text: &str, name: Option<&str>) -> Result<Self, FileError> {
        let scenes = document::read(text)?;
        let chosen = resolve::choose(scenes, name).map_err(FileError::new)?;
        Self::of(chosen)
    }

    /// Reads every scene of JSON `text`, in the order of the text. Two scenes may have one name.
    ///
    /// # Errors
    ///
    /// The text is not the JSON of a scene or of an array of scenes; or the material of a shape is missing.
    ///
    /// ```
    /// use reflet::host::file::SceneFile;
    ///
    /// let camera = r#"{"position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50}"#;
    /// let text = format!(r#"[{{"name": "a", "camera": {camera}}}, {{"name": "b", "camera": {camera}}}]"#);
    ///
    /// let scenes = SceneFile::parse_all(&text).unwrap();
    /// assert_eq!((scenes.len(), scenes[1].name()), (2, Some("b")));
    /// assert!(SceneFile::parse_all("[]").unwrap().is_empty());
    /// ```
    #[inline]
    pub fn parse_all(text: &str) -> Result<Vec<Self>, FileError> {
        let scenes = document::read(text)?;
        scenes.into_iter().map(Self::of).collect()
    }

    /// Resolves the names in a scene.
    #[inline]
    fn of(mut chosen: document::Scene) -> Result<Self, FileError> {
        let name = chosen.name.take();
        let materials = chosen.materials.iter().map(|it| it.name.clone()).collect();
        let (scene, camera) = resolve::resolve(chosen)
            .map_err(|problem| FileError::new(problem).in_scene(name.as_deref()))?;
        Ok(Self {
            #[cfg(feature = "host")]
            path: None,
            name,
            materials,
            scene,
            camera,
        })
    }

    /// Returns the name of the scene, or `None` if the file gives no name.
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// Returns the names of the materials, in the order of the reference's list of materials.
    pub fn materials(&self) -> &[String] {
        &self.materials
    }

    /// Returns the scene and the camera for the double-precision reference.
    pub fn reference(&self) -> (Scene, Camera) {
        (self.scene.clone(), self.camera.clone())
    }

    /// Returns the scene and the camera for the fixed-point core. The scene is filled but not built yet.
    /// [`SceneFile::fill`] fills one with less room.
    ///
    /// # Errors
    ///
    /// The core refuses a part of the scene, or there are more parts than a file may hold.
    #[inline]
    pub fn runtime(&self) -> Result<(Box<FileRuntimeScene>, camera::Camera), FileError> {
        filled(&self.scene, &self.camera).map_err(|problem| self.error(problem))
    }

    /// Builds the scene for the fixed-point core, ready to be drawn.
    ///
    /// # Errors
    ///
    /// All errors of [`SceneFile::runtime`]; or the core refuses the scene as a whole.
    #[inline]
    pub fn build(&self) -> Result<Box<FileScene>, FileError> {
        let (scene, _) = self.runtime()?;
        build(&scene).map_err(|problem| self.error(problem))
    }

    fn error(&self, problem: Problem) -> FileError {
        let error = FileError::new(problem).in_scene(self.name());
        #[cfg(feature = "host")]
        let error = error.in_file(self.path.as_deref());
        error
    }
}

#[cfg(feature = "host")]
#[cfg(test)]
mod tests;
