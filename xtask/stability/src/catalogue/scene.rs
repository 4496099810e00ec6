//! A scene file that the library has accepted, and its pictures. Judges nothing.

use embedded_graphics::geometry::Size;
use float_picture::single;
use reflet::Camera;
use reflet::host::file::{FileScene, SceneFile};
use reflet::host::painted;
use reflet::host::reference::{self, Picture, Shading, render};
use reflet::quality::Quality;

/// A scene that the library has accepted.
pub struct Scene {
    /// The scene that the library draws.
    pub built: Box<FileScene>,
    /// The library's camera.
    pub camera: Camera,
    /// The scene in double precision.
    pub exact: reference::Scene,
    /// The camera in double precision.
    pub eye: reference::Camera,
}

impl Scene {
    /// Reads the text of a scene file. The error says why the library refuses it.
    pub fn read(text: &str) -> Result<Self, String> {
        let file = SceneFile::parse(text, None).map_err(|error| error.to_string())?;
        let built = file.build().map_err(|error| error.to_string())?;
        let (_, camera) = file.runtime().map_err(|error| error.to_string())?;
        let (exact, eye) = file.reference();
        Ok(Self {
            built,
            camera,
            exact,
            eye,
        })
    }

    /// Draws a picture with the library.
    pub fn drawn<Q: Quality>(&self, reflections: u8, (width, height): (u32, u32)) -> Picture {
        let frame = self.built.frame(&self.camera).reflections(reflections);
        let frame = frame.quality::<Q>().prepare(Size::new(width, height));
        painted(&frame.on(&*self.built).expect("the frame is this scene's"))
    }

    /// Draws a picture in double precision, seen from `eye`.
    pub fn truth(&self, eye: &reference::Camera, reflections: u8, side: u32) -> Picture {
        let shading = Shading::BlinnPhong;
        render(&self.exact, eye, side, side, reflections.into(), shading)
    }

    /// Draws a picture in single precision.
    pub fn single(&self, reflections: u8, side: u32) -> Picture {
        let (size, shading) = ((side, side), Shading::BlinnPhong);
        single::render(&self.exact, &self.eye, size, reflections.into(), shading)
    }
}
