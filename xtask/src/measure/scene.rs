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
}

impl Scene {
    /// The scene that the command line names.
    ///
    /// # Errors
    /// [`Misuse`] where there is no such scene or it cannot be used.
    pub fn open(scene: &Path, chosen: &Chosen) -> Result<Self> {
        match Named::of(scene, chosen).map_err(Misuse::new)? {
            Named::BuiltIn(name) => Ok(Self::BuiltIn(name)),
            Named::File => Ok(scene_source::read(scene, chosen)?.into()),
        }
    }

    /// The scene of a file that is only a text, and need not have been written anywhere.
    ///
    /// # Errors
    /// [`Misuse`] where the text cannot be used.
    pub fn parse(text: &str) -> Result<Self> {
        Ok(scene_source::parse(text)?.into())
    }

    pub fn name(&self) -> &str {
        match self {
            Self::BuiltIn(name) => name,
            Self::File { source, .. } => &source.name,
        }
    }

    pub fn reference(&self) -> (reference::Scene, reference::Camera) {
        match self {
            Self::BuiltIn(name) => Source::built_in(name).expect(KNOWN).reference(),
            Self::File { file, .. } => file.reference(),
        }
    }

    pub(crate) fn source(&self) -> Option<&str> {
        match self {
            Self::BuiltIn(_) => None,
            Self::File { source, .. } => Some(&source.text),
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
            Self::File { source, .. } => (
                format!("#[path = {file:?}]\nmod scene;\n\n"),
                format!("scene::{}", source.type_name),
                "scene::CAMERA".to_owned(),
            ),
        };
        let view = format!(
            "impl firmware::View for Seen {{\n    const CAMERA: reflet::Camera = {camera};\n}}\n\n"
        );
        (module, scene, view)
    }

    pub fn type_name(name: &str) -> &'static str {
        scenes::visit(name, TypeName).expect(KNOWN)
    }
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
