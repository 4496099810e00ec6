//! What can be drawn: a built-in scene or a scene file, behind the same calls.

use std::path::Path;

use clap::Args;
use reflet::host::file::{FileError, FileScene, Problem, SceneFile};
use reflet::host::reference;
use reflet::scenes::{self, BuiltIn, Visitor};

use crate::Failure;

/// The option that takes one scene from a file.
#[derive(Args, Clone, Debug, Default)]
pub struct Chosen {
    /// The scene to take from a file that holds several
    #[arg(id = "chosen", long = "scene", value_name = "NAME")]
    pub name: Option<String>,
}

/// What a command line calls a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Named {
    BuiltIn(&'static str),
    /// A scene file; its path is the name.
    File,
}

impl Named {
    /// A name with a dot or a slash in it is a file.
    ///
    /// # Errors
    ///
    /// There is no such built-in scene, or one is to be taken from a built-in scene.
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

/// A scene and the view it was made for.
pub struct Source {
    name: String,
    pub kind: Kind,
}

/// Where a scene comes from.
pub enum Kind {
    BuiltIn,
    File(Box<SceneFile>, Box<FileScene>),
}

impl Source {
    /// The scene that the command line names.
    pub fn open(scene: &Path, chosen: &Chosen) -> Result<Self, Failure> {
        match Named::of(scene, chosen)? {
            Named::BuiltIn(name) => Ok(Self::known(name)),
            Named::File => Self::read(scene, chosen),
        }
    }

    /// The built-in scene of this name.
    pub fn built_in(name: &str) -> Option<Self> {
        let known = scenes::NAMES.contains(&name);
        known.then(|| Self::known(name))
    }

    fn known(name: &str) -> Self {
        Self {
            name: name.to_owned(),
            kind: Kind::BuiltIn,
        }
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
            kind: Kind::File(Box::new(file), scene),
        })
    }

    /// What the scene is called.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The scene and the camera in double precision.
    pub fn reference(&self) -> (reference::Scene, reference::Camera) {
        match &self.kind {
            Kind::BuiltIn => self.visit(Describe),
            Kind::File(file, _) => file.reference(),
        }
    }

    /// Visits a built-in scene.
    pub fn visit<V: Visitor>(&self, visitor: V) -> V::Output {
        scenes::visit(&self.name, visitor).expect("the name was found in the list of names")
    }
}

/// The error with the option that chooses from a file, which the file does not know.
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
