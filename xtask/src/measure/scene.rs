//! The scene that is measured: a built-in one, or one from a file.

use std::path::Path;

use anyhow::Result;
use command_line::{Chosen, Named, Source};
use reflet::host::{file::SceneFile, reference};
use reflet::scenes::{self, BuiltIn, Visitor};

use crate::{misuse::Misuse, scene_source};

#[derive(Clone, Debug)]
pub enum Scene {
    /// One that comes with the library, by its name.
    BuiltIn(&'static str),
    File {
        file: Box<SceneFile>,
        source: scene_source::Source,
    },
    /// One of which a shape can move.
    Moving(Box<Moving>),
}

/// A scene with a motion box around one of its shapes.
#[derive(Clone, Debug)]
pub struct Moving {
    source: scene_source::Source,
    shape: scene_source::moving::Moving,
    exact: (reference::Scene, reference::Camera),
    /// Whether the scene is in RAM and the shape is moved before a frame; else it is a constant.
    moves: bool,
}

impl Scene {
    /// The scene that the command line names.
    pub fn open(scene: &Path, chosen: &Chosen) -> Result<Self> {
        match Named::of(scene, chosen).map_err(Misuse::new)? {
            Named::BuiltIn(name) => Ok(Self::BuiltIn(name)),
            Named::File => Ok(scene_source::read(scene, chosen)?.into()),
        }
    }

    /// The scene of a file that is only a text, and need not have been written anywhere.
    pub fn parse(text: &str) -> Result<Self> {
        Ok(scene_source::parse(text)?.into())
    }

    /// The same scene with a motion box around one of its shapes. Unless the shape `moves`, it is a
    /// constant scene.
    pub fn with_motion(&self, moves: bool) -> Result<Self> {
        let exact = self.reference();
        let (source, shape) = scene_source::with_motion(self.name(), (&exact.0, &exact.1))?;
        Ok(Self::Moving(Box::new(Moving {
            source,
            shape,
            exact,
            moves,
        })))
    }

    pub fn name(&self) -> &str {
        match self {
            Self::Moving(moving) => &moving.source.name,
            Self::BuiltIn(name) => name,
            Self::File { source, .. } => &source.name,
        }
    }

    pub fn reference(&self) -> (reference::Scene, reference::Camera) {
        match self {
            Self::BuiltIn(name) => Source::built_in(name).expect(KNOWN).reference(),
            Self::File { file, .. } => file.reference(),
            Self::Moving(moving) => moving.exact.clone(),
        }
    }

    pub(crate) fn source(&self) -> Option<&str> {
        match self {
            Self::BuiltIn(_) => None,
            Self::File { source, .. } => Some(&source.text),
            Self::Moving(moving) => Some(&moving.source.text),
        }
    }

    /// How a firmware names it: the module that has to be declared, if there is one, the scene's type
    /// and its `View`; `file` is where the source of a file's scene lies.
    pub(crate) fn names(&self, file: &Path) -> (String, String, String) {
        let (module, scene, camera) = match self {
            Self::BuiltIn(name) => {
                let scene = format!("reflet::scenes::{}", Self::type_name(name));
                let camera = format!("<{scene} as reflet::scenes::BuiltIn>::CAMERA");
                (String::new(), scene, camera)
            }
            Self::File { source, .. } => of_file(file, source),
            Self::Moving(moving) => {
                let (module, scene, camera) = of_file(file, &moving.source);
                (module + &moving.shape.moves(&scene), scene, camera)
            }
        };
        let view = format!(
            "impl firmware::View for Seen {{\n    const CAMERA: reflet::Camera = {camera};\n}}\n\n"
        );
        (module, scene, view)
    }

    /// The type in the firmware that draws it with a quality of fixed point.
    pub(crate) fn contestant(&self, is_whole: bool) -> &'static str {
        match self {
            Self::Moving(moving) if moving.moves => "Moving",
            _ if is_whole => "Everything",
            _ => "Fixed",
        }
    }

    pub fn type_name(name: &str) -> &'static str {
        scenes::visit(name, TypeName).expect(KNOWN)
    }
}

/// The module, the type and the camera of the scene that is in a file of Rust source.
fn of_file(file: &Path, source: &scene_source::Source) -> (String, String, String) {
    (
        format!("#[path = {file:?}]\nmod scene;\n\n"),
        format!("scene::{}", source.type_name),
        "scene::CAMERA".to_owned(),
    )
}

impl From<(SceneFile, scene_source::Source)> for Scene {
    fn from((file, source): (SceneFile, scene_source::Source)) -> Self {
        let file = Box::new(file);
        Self::File { file, source }
    }
}

const KNOWN: &str = "the name was found in the list of names";

struct TypeName;

impl Visitor for TypeName {
    type Output = &'static str;

    fn visit<S: BuiltIn>(self) -> &'static str {
        let path = std::any::type_name::<S>();
        path.rsplit("::").next().unwrap_or(path)
    }
}
