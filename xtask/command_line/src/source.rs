//! Scenes that commands can draw: built-in scenes and scene files, with the same type.

use std::path::Path;

use clap::Args;
use embedded_graphics::geometry::Size;
use reflet::host::file::{FileError, FileScene, Problem, SceneFile, built};
use reflet::host::painted;
use reflet::host::reference::{self, Picture};
use reflet::quality::Quality;
use reflet::scenes::{self, BuiltIn, Visitor};
use reflet::shading::Shading;
use reflet::{Camera, Error};

use crate::Failure;

/// The option `--scene NAME`, which selects one scene of a file.
#[derive(Args, Clone, Debug, Default)]
pub struct Chosen {
    /// The scene to take from a file that holds several
    #[arg(id = "chosen", long = "scene", value_name = "NAME")]
    pub name: Option<String>,
}

/// How the command line names a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Named {
    BuiltIn(&'static str),
    /// A scene file; its name is the path.
    File,
}

impl Named {
    /// Decides whether `scene` names a built-in scene or a file. A name with a dot or a slash is a
    /// file.
    ///
    /// # Errors
    /// Fails if there is no such built-in scene, or if `chosen` is given with a built-in scene.
    pub fn of(scene: &Path, chosen: &Chosen) -> Result<Self, Failure> {
        let text = scene.to_string_lossy();
        let built_in = scenes::NAMES.into_iter().find(|&name| name == text);
        match (built_in, &chosen.name) {
            (Some(name), Some(_)) => Err(format!(
                "--scene chooses from a file, and {name} is built in: \
                 write FILE.json --scene NAME, or NAME alone"
            )
            .into()),
            (Some(name), None) => Ok(Self::BuiltIn(name)),
            (None, _) if text.contains(['.', '/', '\\']) => Ok(Self::File),
            (None, _) => {
                let names = scenes::NAMES.join(", ");
                Err(format!("there is no built-in scene {text}, only {names}").into())
            }
        }
    }
}

/// A scene with its name and the camera it was made for. Built-in scenes and files are drawn by the same
/// code: a built-in scene is filled at run time, which changes no pixel.
pub struct Source {
    name: String,
    exact: (reference::Scene, reference::Camera),
    scene: Box<FileScene>,
}

impl Source {
    /// Opens the scene that the command line names.
    pub fn open(scene: &Path, chosen: &Chosen) -> Result<Self, Failure> {
        match Named::of(scene, chosen)? {
            Named::BuiltIn(name) => Ok(Self::known(name)),
            Named::File => Self::read(scene, chosen),
        }
    }

    /// Returns the built-in scene of this name, or `None` if there is none.
    pub fn built_in(name: &str) -> Option<Self> {
        let known = scenes::NAMES.contains(&name);
        known.then(|| Self::known(name))
    }

    fn known(name: &str) -> Self {
        let exact = scenes::visit(name, Describe).expect("the name was found in the list of names");
        let source = Self::described(name.to_owned(), exact.0, exact.1);
        source.expect("a built-in scene is valid")
    }

    /// Returns a scene from its description in double precision.
    pub fn described(
        name: String,
        scene: reference::Scene,
        camera: reference::Camera,
    ) -> Result<Self, FileError> {
        let built = built(&scene, &camera)?;
        Ok(Self {
            name,
            exact: (scene, camera),
            scene: built,
        })
    }

    fn read(path: &Path, chosen: &Chosen) -> Result<Self, Failure> {
        let file = SceneFile::read(path, chosen.name.as_deref()).map_err(with_advice)?;
        let scene = file.build()?;
        let stem = || {
            path.file_stem()
                .unwrap_or(path.as_os_str())
                .to_string_lossy()
                .into_owned()
        };
        let name = file.name().map_or_else(stem, str::to_owned);
        Ok(Self {
            name,
            exact: file.reference(),
            scene,
        })
    }

    pub fn name(&self) -> &str {
        &self.name
    }

    /// Returns the scene, ready to draw.
    pub fn scene(&self) -> &FileScene {
        &self.scene
    }

    /// Returns the camera that the scene was made for.
    pub fn camera(&self) -> Camera {
        exact(&self.exact.1).expect("the scene was built with this camera")
    }

    /// Draws the scene through its own camera, with tables as a board does.
    pub fn painted<Q: Quality, K: Shading>(&self, size: Size, reflections: u8) -> Picture {
        let camera = self.camera();
        let scene = self.scene.tabled();
        let frame = scene.frame(&camera).reflections(reflections);
        let frame = frame.quality::<Q>().shading::<K>().prepare(size);
        painted(&frame.on(&scene).expect("the scene never changes"))
    }

    /// Returns the scene and its camera in double precision.
    pub fn reference(&self) -> (reference::Scene, reference::Camera) {
        self.exact.clone()
    }
}

/// Converts the reference's camera to the library's.
pub fn exact(camera: &reference::Camera) -> Result<Camera, Error> {
    Camera::new(camera.position, camera.target, camera.up, camera.fov)
}

/// Adds the option `--scene` to an error that a file has several scenes. The file's error does not
/// know the option.
pub fn with_advice(error: FileError) -> Failure {
    match error.problem() {
        Problem::Undecided { .. } => format!("{error} (--scene NAME)").into(),
        _ => error.into(),
    }
}

struct Describe;

impl Visitor for Describe {
    type Output = (reference::Scene, reference::Camera);

    fn visit<S: BuiltIn>(self) -> Self::Output {
        let scene = S::with_description(|description| reference::Scene::from(&description));
        (scene, reference::Camera::from(&S::CAMERA.description()))
    }
}
