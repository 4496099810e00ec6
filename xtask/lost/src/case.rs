//! One scene to be drawn by the reference and by each quality. Never reads a file.

use embedded_graphics::geometry::Size;
use reflet::host::file::{FileError, FileScene, built};
use reflet::host::painted;
use reflet::host::reference::{Camera, Scene};
use reflet::quality::{self, Exact};
use reflet::shading::{BlinnPhong, Shading, Unshadowed};

use crate::count::{Cause, Counts, RIGHT, Views, causes};
use crate::truth::{Truth, truth};

/// A quality that interpolates, and so may lose pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// [`quality::Fast`].
    Fast,
    /// [`quality::Fine`].
    Fine,
    /// [`quality::Draft`], which guesses.
    Draft,
}

impl Quality {
    /// All qualities that interpolate.
    pub const ALL: [Self; 3] = [Self::Fast, Self::Fine, Self::Draft];

    /// The qualities that lose nothing.
    pub const SURE: [Self; 2] = [Self::Fast, Self::Fine];

    /// Returns the quality's name in tables and on the command line.
    pub fn name(self) -> &'static str {
        match self {
            Self::Fast => "fast",
            Self::Fine => "fine",
            Self::Draft => "draft",
        }
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
    /// Number of reflections of the scene.
    pub reflections: u8,
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
    pub pixels: Vec<[u8; 3]>,
    /// Why each pixel is lost, or `None`.
    pub causes: Vec<Option<Cause>>,
}

impl Case {
    /// Draws the scene and counts what the qualities lose. The reference is drawn once.
    ///
    /// # Errors
    ///
    /// The library refuses the scene or the camera.
    pub fn judge(&self, size: Size, qualities: &[Quality]) -> Result<Judged, FileError> {
        let lit = Drawing::<BlinnPhong>::new(self.scene.clone(), self, size)?;
        let reflections = u32::from(self.reflections);
        let truth = truth(
            &self.scene,
            &self.camera,
            (size.width, size.height),
            reflections,
        );
        let exact = lit.drawn::<Exact>();
        let mut plain = Plain::new(self, size)?;
        let judge = |&quality: &Quality| {
            let pixels = lit.drawn_in(quality);
            let views = Views {
                truth: &truth.lit,
                exact: &exact,
                tested: &pixels,
            };
            let causes = causes(views, &truth.is_apart, || plain.views(&truth, quality));
            Lost {
                quality,
                counts: Counts::of(&causes),
                causes,
                pixels,
            }
        };
        let lost = qualities.iter().map(judge).collect();
        Ok(Judged {
            name: self.name.clone(),
            reflections: self.reflections,
            size,
            exact: share_right(&exact, &truth.lit),
            lost,
        })
    }

    /// Returns the percentage of pixels that `Exact` has within 1 without shadows and highlights.
    ///
    /// # Errors
    ///
    /// The library refuses the scene or the camera.
    pub fn plain_exact(&self, size: Size) -> Result<f64, FileError> {
        let reflections = u32::from(self.reflections);
        let truth = truth(
            &self.scene,
            &self.camera,
            (size.width, size.height),
            reflections,
        );
        let exact = Plain::new(self, size)?.drawing.drawn::<Exact>();
        Ok(share_right(&exact, &truth.plain))
    }
}

fn share_right(exact: &[[u8; 3]], truth: &[[u8; 3]]) -> f64 {
    let is_near = |(a, b): &(&[u8; 3], &[u8; 3])| {
        let mut channels = a.iter().zip(*b);
        channels.all(|(a, b)| a.abs_diff(*b) <= RIGHT)
    };
    let right = exact.iter().zip(truth).filter(is_near).count();
    100.0 * right as f64 / truth.len().max(1) as f64
}

/// A scene that the library draws in one shading.
struct Drawing<K> {
    scene: Box<FileScene>,
    camera: reflet::Camera,
    reflections: u8,
    size: Size,
    shading: std::marker::PhantomData<K>,
}

impl<K: Shading> Drawing<K> {
    fn new(scene: Scene, case: &Case, size: Size) -> Result<Self, FileError> {
        let eye = &case.camera;
        let built = built(&scene, eye)?;
        let camera = reflet::Camera::new(eye.position, eye.target, eye.up, eye.fov)
            .expect("the scene was built with this camera");
        Ok(Self {
            scene: built,
            camera,
            reflections: case.reflections,
            size,
            shading: std::marker::PhantomData,
        })
    }

    fn drawn<Q: quality::Quality>(&self) -> Vec<[u8; 3]> {
        let frame = self.scene.frame(&self.camera).reflections(self.reflections);
        let frame = frame.quality::<Q>().shading::<K>().prepare(self.size);
        painted(&frame.on(&*self.scene).expect("the frame is this scene's")).pixels
    }

    fn drawn_in(&self, quality: Quality) -> Vec<[u8; 3]> {
        match quality {
            Quality::Fast => self.drawn::<quality::Fast>(),
            Quality::Fine => self.drawn::<quality::Fine>(),
            Quality::Draft => self.drawn::<quality::Draft>(),
        }
    }
}

/// Pictures without shadows and highlights, drawn when they are needed.
struct Plain {
    drawing: Drawing<Unshadowed>,
    exact: Option<Vec<[u8; 3]>>,
    tested: Vec<[u8; 3]>,
}

impl Plain {
    fn new(case: &Case, size: Size) -> Result<Self, FileError> {
        let mut scene = case.scene.clone();
        for material in &mut scene.materials {
            material.specular = 0.0;
        }
        Ok(Self {
            drawing: Drawing::new(scene, case, size)?,
            exact: None,
            tested: Vec::new(),
        })
    }

    fn views<'a>(&'a mut self, truth: &'a Truth, quality: Quality) -> Views<'a> {
        self.tested = self.drawing.drawn_in(quality);
        let drawing = &self.drawing;
        Views {
            truth: &truth.plain,
            exact: self.exact.get_or_insert_with(|| drawing.drawn::<Exact>()),
            tested: &self.tested,
        }
    }
}
