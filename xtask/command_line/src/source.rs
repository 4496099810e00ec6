//! What can be drawn: a built-in scene or a scene file, behind the same calls.

use std::path::Path;

use reflet::host::file::{FileError, FileScene, Problem, SceneFile};
use reflet::host::reference;
use reflet::scenes::{self, BuiltIn, Visitor};

use crate::Failure;

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
    pub fn open(scene: &Path, chosen: Option<&str>) -> Result<Self, Failure> {
        let text = scene.to_string_lossy();
        let built_in = Self::built_in(&text);
        match chosen {
            Some(_) if built_in.is_some() => {
                Err(format!("--scene chooses from a file, and {text} is built in").into())
            }
            _ if built_in.is_none() && text.contains(['.', '/', '\\']) => Self::read(scene, chosen),
            _ => built_in.ok_or_else(|| {
                let names = scenes::NAMES.join(", ");
                format!("there is no built-in scene {text}, only {names}").into()
            }),
        }
    }

    /// The built-in scene of this name.
    pub fn built_in(name: &str) -> Option<Self> {
        let known = scenes::NAMES.contains(&name);
        known.then(|| Self {
            name: name.to_owned(),
            kind: Kind::BuiltIn,
        })
    }

    fn read(path: &Path, chosen: Option<&str>) -> Result<Self, Failure> {
        let file = SceneFile::read(path, chosen).map_err(with_advice)?;
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

/// A file does not know the option that chooses from it.
fn with_advice(error: FileError) -> Failure {
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
