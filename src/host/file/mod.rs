//! Scene files: JSON in, the reference's scene and a run-time scene out; it owns the format and
//! the place of every mistake, and never draws.
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
//!   "background": [0, 0, 0],
//!   "epsilon": 0.001
//! }
//! ```
//!
//! `name`, `background`, `epsilon` and every list may be left out; a list is empty then, and the
//! rest as above. An unknown key is an error. `docs/scene.schema.json` in the repository is a JSON
//! Schema of all this.

mod document;
mod error;
mod fill;
mod resolve;

use std::borrow::ToOwned;
use std::boxed::Box;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};
use std::string::String;
use std::vec::Vec;

pub use self::error::{FileError, Problem};
use crate::camera;
use crate::host::reference::{Camera, Scene};
use crate::scene::{Room, RuntimeScene};

/// The most bytes that a scene file may have: 16 MB.
pub const MAX_BYTES: u64 = 16_000_000;

/// The most spheres that a scene of a file may have.
pub const MAX_SPHERES: usize = 512;

/// The most planes that a scene of a file may have.
pub const MAX_PLANES: usize = 32;

/// The most cylinders that a scene of a file may have.
pub const MAX_CYLINDERS: usize = 128;

/// The most discs that a scene of a file may have.
pub const MAX_DISCS: usize = 128;

/// The most lights that a scene of a file may have.
pub const MAX_LIGHTS: usize = 16;

/// The most materials that a scene of a file may have.
pub const MAX_MATERIALS: usize = 256;

/// Room for the most that a file may hold.
pub type FileRoom =
    Room<MAX_SPHERES, MAX_PLANES, MAX_CYLINDERS, MAX_LIGHTS, MAX_MATERIALS, MAX_DISCS>;

/// The scene of a file as it is filled.
pub type FileRuntimeScene = RuntimeScene<FileRoom>;

/// The scene of a file when it is built.
pub type FileScene = crate::Scene<FileRoom>;

/// The reference's scene in the core, seen first with its camera, with as much room as that of a file.
///
/// A scene that was described in plain decimal numbers comes back as it was: each is a double.
///
/// # Errors
///
/// The core refuses a part of the scene or the scene as a whole, or there are more parts than a file
/// may hold.
pub fn built(scene: &Scene, camera: &Camera) -> Result<Box<FileScene>, FileError> {
    let filled = filled(scene, camera).and_then(|(target, _)| build(&target));
    filled.map_err(FileError::new)
}

fn filled(
    scene: &Scene,
    camera: &Camera,
) -> Result<(Box<FileRuntimeScene>, camera::Camera), Problem> {
    let mut target = Box::new(FileRuntimeScene::new());
    fill::scene(&mut target, scene).map_err(Problem::Scene)?;
    let camera = fill::camera(camera).map_err(Problem::Camera)?;
    target.set_camera(camera);
    Ok((target, camera))
}

fn build(scene: &FileRuntimeScene) -> Result<Box<FileScene>, Problem> {
    scene.build().map(Box::new).map_err(Problem::Scene)
}

/// A scene read from a file: every shape has its material; whether the core takes its numbers is
/// found by [`SceneFile::runtime`].
#[derive(Clone, Debug)]
pub struct SceneFile {
    path: Option<PathBuf>,
    name: Option<String>,
    materials: Vec<String>,
    scene: Scene,
    camera: Camera,
}

impl SceneFile {
    /// Reads a scene from `text`: the one called `name`, or the only one.
    ///
    /// # Errors
    ///
    /// The text is no scene, holds no scene of that name or several scenes and no name is given,
    /// has a name twice, or a shape's material is missing.
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
    pub fn parse(text: &str, name: Option<&str>) -> Result<Self, FileError> {
        let scenes = document::read(text).map_err(|error| FileError::json(&error))?;
        let mut chosen = resolve::choose(scenes, name).map_err(FileError::new)?;
        let name = chosen.name.take();
        let materials = chosen.materials.iter().map(|it| it.name.clone()).collect();
        let (scene, camera) = resolve::resolve(chosen)
            .map_err(|problem| FileError::new(problem).in_scene(name.as_deref()))?;
        Ok(Self {
            path: None,
            name,
            materials,
            scene,
            camera,
        })
    }

    /// Reads a scene from the file at `path`: the one called `name`, or the only one.
    ///
    /// # Errors
    ///
    /// The file cannot be read or has more than [`MAX_BYTES`], and all of [`SceneFile::parse`].
    pub fn read(path: impl AsRef<Path>, name: Option<&str>) -> Result<Self, FileError> {
        let path = path.as_ref();
        let read = text_of(path)
            .map_err(FileError::new)
            .and_then(|text| Self::parse(&text, name))
            .map_err(|error| error.in_file(Some(path)))?;
        Ok(Self {
            path: Some(path.to_owned()),
            ..read
        })
    }

    /// The name of the scene, where it has one.
    pub fn name(&self) -> Option<&str> {
        self.name.as_deref()
    }

    /// The names of the materials, in the order of the reference's.
    pub fn materials(&self) -> &[String] {
        &self.materials
    }

    /// The scene and the camera of the double-precision reference.
    pub fn reference(&self) -> (Scene, Camera) {
        (self.scene.clone(), self.camera.clone())
    }

    /// The scene and the camera of the fixed-point core, filled at run time and ready to build.
    ///
    /// # Errors
    ///
    /// The core refuses a part of the scene, or there are more parts than a file may hold.
    pub fn runtime(&self) -> Result<(Box<FileRuntimeScene>, camera::Camera), FileError> {
        filled(&self.scene, &self.camera).map_err(|problem| self.error(problem))
    }

    /// The scene of the fixed-point core, ready to be drawn.
    ///
    /// # Errors
    ///
    /// All of [`SceneFile::runtime`], and the core refuses the scene as a whole.
    pub fn build(&self) -> Result<Box<FileScene>, FileError> {
        let (scene, _) = self.runtime()?;
        build(&scene).map_err(|problem| self.error(problem))
    }

    fn error(&self, problem: Problem) -> FileError {
        FileError::new(problem)
            .in_file(self.path.as_deref())
            .in_scene(self.name())
    }
}

/// All of a file that is not too large. A pipe or a device, whose size nobody knows, is read no
/// further than that.
fn text_of(path: &Path) -> Result<String, Problem> {
    let mut bytes = Vec::new();
    File::open(path)
        .and_then(|file| file.take(MAX_BYTES + 1).read_to_end(&mut bytes))
        .map_err(Problem::Unreadable)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(Problem::TooLarge);
    }
    String::from_utf8(bytes).map_err(|_| {
        let words = "the file is not UTF-8 text";
        Problem::Unreadable(io::Error::new(io::ErrorKind::InvalidData, words))
    })
}

#[cfg(test)]
mod tests;
