//! A scene file that the library has accepted, and its pictures. Judges nothing.

use command_line::{Quality, Shading, Source};
use embedded_graphics::geometry::Size;
use float_picture::single;
use lost::case::Case;
use reflet::host::file::SceneFile;
use reflet::host::reference::Picture;

use super::draft::Draft;

/// A scene that the library has accepted.
pub struct Scene {
    /// The scene in double precision.
    pub case: Case,
    /// The scene that the library draws.
    pub source: Source,
}

impl Scene {
    /// Reads a scene file. The error says why the library refuses it.
    pub fn read(draft: &Draft) -> Result<Self, String> {
        let file = SceneFile::parse(&draft.file.to_string(), None).map_err(|it| it.to_string())?;
        let (scene, camera) = file.reference();
        let case = Case {
            name: String::new(),
            scene,
            camera,
            reflections: draft.reflections,
            shading: Shading::BlinnPhong,
        };
        let source = case.source().map_err(|it| it.to_string())?;
        Ok(Self { case, source })
    }

    /// Draws a picture with the library.
    pub fn drawn(&self, quality: Quality, size: Size) -> Picture {
        self.source.drawn(size, self.case.settings(quality))
    }

    /// Draws a picture in single precision.
    pub fn single(&self, Size { width, height }: Size) -> Picture {
        let (case, size) = (&self.case, (width, height));
        let (n, shading) = (case.reflections.into(), case.shading.into());
        single::render(&case.scene, &case.camera, size, n, shading)
    }
}
