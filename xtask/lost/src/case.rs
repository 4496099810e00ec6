//! One scene to be drawn by the reference and by each quality. Never reads a file.

use clap::ValueEnum;
use embedded_graphics::geometry::Size;
use reflet::host::file::{FileError, FileScene, built};
use reflet::host::painted;
use reflet::host::reference::{Camera, Scene};
use reflet::quality::{self, Exact};
use reflet::shading::{BlinnPhong, Shading, Unshadowed};

use crate::count::{Cause, Counts, Pixel, RIGHT, causes, difference, lost};
use crate::truth::{Truth, truth};

/// A quality that interpolates, and so may lose pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Quality {
    /// [`quality::Fast`].
    Fast,
    /// [`quality::Fine`].
    Fine,
    /// [`quality::Draft`], which guesses.
    Draft,
}

impl Quality {
    /// The qualities that lose nothing.
    pub const SURE: [Self; 2] = [Self::Fast, Self::Fine];

    /// Returns the quality's name in tables and on the command line.
    pub fn name(self) -> String {
        format!("{self:?}").to_lowercase()
    }
}

/// A scene with its camera and its number of reflections.
#[derive(Clone, Debug, PartialEq)]
pub struct Case {
    /// Name of the scene in tables and of its files.
    pub name: String,
    /// The scene in double precision.
    pub scene: Scene,
    /// The camera in double precision.
    pub camera: Camera,
    /// Number of reflections that paths follow.
    pub reflections: u8,
}

/// What the qualities lose of a scene.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Name of the scene.
    pub name: String,
    /// Width and height of the pictures.
    pub size: Size,
    /// Percentage of the pixels that `Exact` has within 1.
    pub exact: f64,
    /// What each tested quality loses.
    pub lost: Vec<Lost>,
}

/// What one quality loses of a scene.
#[derive(Clone, Debug)]
pub struct Lost {
    /// The tested quality.
    pub quality: Quality,
    /// Numbers of lost pixels.
    pub counts: Counts,
    /// The picture of this quality.
    pub pixels: Vec<Pixel>,
    /// Why each pixel is lost, or `None`.
    pub causes: Vec<Option<Cause>>,
}

impl Lost {
    /// Tests whether any pixel is lost, apart or not.
    pub fn is_any(&self) -> bool {
        self.causes.iter().any(Option::is_some)
    }
}

impl Case {
    /// Draws the scene and counts what the qualities lose. The reference is drawn once.
    ///
    /// # Errors
    ///
    /// The library refuses the scene or the camera.
    pub fn judge(&self, size: Size, qualities: &[Quality]) -> Result<Judged, FileError> {
        let (lit, plain) = (self.drawing(size)?, self.plain().drawing(size)?);
        let truth = self.truth(size);
        let exact = lit.drawn::<BlinnPhong, Exact>();
        let judge = |&quality: &Quality| {
            let pixels = lit.drawn_in::<BlinnPhong>(quality);
            let is_lost = lost(&truth.lit, &exact, &pixels);
            let causes = causes(&is_lost, &truth.is_apart, || {
                let exact = plain.drawn::<Unshadowed, Exact>();
                lost(&truth.plain, &exact, &plain.drawn_in::<Unshadowed>(quality))
            });
            Lost {
                quality,
                counts: Counts::of(&causes),
                causes,
                pixels,
            }
        };
        Ok(Judged {
            name: self.name.clone(),
            size,
            lost: qualities.iter().map(judge).collect(),
            exact: share_right(&exact, &truth.lit),
        })
    }

    /// Returns the percentage of pixels that `Exact` has within 1 without shadows and highlights.
    ///
    /// # Errors
    ///
    /// The library refuses the scene or the camera.
    pub fn plain_exact(&self, size: Size) -> Result<f64, FileError> {
        let exact = self.plain().drawing(size)?.drawn::<Unshadowed, Exact>();
        Ok(share_right(&exact, &self.truth(size).plain))
    }

    /// Returns the case without highlights.
    fn plain(&self) -> Self {
        let mut plain = self.clone();
        let materials = &mut plain.scene.materials;
        materials.iter_mut().for_each(|it| it.specular = 0.0);
        plain
    }

    fn truth(&self, size: Size) -> Truth {
        let reflections = self.reflections.into();
        truth(&self.scene, &self.camera, size.into(), reflections)
    }

    fn drawing(&self, size: Size) -> Result<Drawing, FileError> {
        let eye = &self.camera;
        let scene = built(&self.scene, eye)?;
        let camera = reflet::Camera::new(eye.position, eye.target, eye.up, eye.fov);
        Ok(Drawing {
            scene,
            camera: camera.expect("the scene was built with this camera"),
            reflections: self.reflections,
            size,
        })
    }
}

fn share_right(exact: &[Pixel], truth: &[Pixel]) -> f64 {
    let pairs = exact.iter().zip(truth);
    let right = pairs.filter(|(a, b)| difference(**a, **b) <= RIGHT).count();
    100.0 * right as f64 / truth.len().max(1) as f64
}

/// A scene that the library draws.
struct Drawing {
    scene: Box<FileScene>,
    camera: reflet::Camera,
    reflections: u8,
    size: Size,
}

impl Drawing {
    fn drawn<K: Shading, Q: quality::Quality>(&self) -> Vec<Pixel> {
        let frame = self.scene.frame(&self.camera).reflections(self.reflections);
        let frame = frame.quality::<Q>().shading::<K>().prepare(self.size);
        painted(&frame.on(&*self.scene).expect("the frame is this scene's")).pixels
    }

    fn drawn_in<K: Shading>(&self, quality: Quality) -> Vec<Pixel> {
        match quality {
            Quality::Fast => self.drawn::<K, quality::Fast>(),
            Quality::Fine => self.drawn::<K, quality::Fine>(),
            Quality::Draft => self.drawn::<K, quality::Draft>(),
        }
    }
}
