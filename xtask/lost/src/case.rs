//! One scene to be drawn by the reference and by each quality. Never reads a file.

use clap::ValueEnum;
use command_line::{Quality as Fixed, Settings, Source};
use embedded_graphics::geometry::Size;
use reflet::host::file::FileError;
use reflet::host::reference::{Camera, Scene};
use reflet::quality::{Draft, Exact, Fast, Small, Smooth};
use reflet::shading::Unshadowed;

use crate::count::{Cause, Counts, Pixel, RIGHT, causes, difference, lost};
use crate::truth::{Truth, truth};

/// A quality that may lose pixels.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Quality {
    /// [`Fast`].
    Fast,
    /// [`Draft`], which guesses.
    Draft,
    /// [`Exact`], which decides by bounds what rays can hit. It is tested against [`Small`].
    Exact,
}

impl Quality {
    /// Returns the quality's name in tables and on the command line.
    pub fn name(self) -> &'static str {
        self.fixed().name()
    }

    fn fixed(self) -> Fixed {
        match self {
            Self::Fast => Fixed::Fast,
            Self::Draft => Fixed::Draft,
            Self::Exact => Fixed::Exact,
        }
    }

    /// Returns the quality that must have a pixel right, if this one is to have lost it.
    fn right(self) -> Fixed {
        match self {
            Self::Exact => Fixed::Small,
            Self::Fast | Self::Draft => Fixed::Exact,
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
        let (lit, plain) = (self.source()?, self.plain().source()?);
        let (truth, how) = (self.truth(size), (size, self.reflections));
        let lit = |quality| {
            let settings = Settings::blinn_phong(quality, self.reflections);
            lit.drawn(size, settings).pixels
        };
        let exact = lit(Fixed::Exact);
        let judge = |&quality: &Quality| {
            let pixels = lit(quality.fixed());
            let right = match quality.right() {
                Fixed::Exact => &exact,
                other => &lit(other),
            };
            let is_lost = lost(&truth.lit, right, &pixels);
            let causes = causes(&is_lost, &truth.is_apart, || {
                let right = unshadowed(&plain, quality.right(), how);
                let drawn = unshadowed(&plain, quality.fixed(), how);
                lost(&truth.plain, &right, &drawn)
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
        let how = (size, self.reflections);
        let exact = unshadowed(&self.plain().source()?, Fixed::Exact, how);
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

    /// Returns the scene as a source of pictures.
    ///
    /// # Errors
    /// The scene is refused.
    pub fn source(&self) -> Result<Source, FileError> {
        Source::described(self.name.clone(), self.scene.clone(), self.camera.clone())
    }
}

fn share_right(exact: &[Pixel], truth: &[Pixel]) -> f64 {
    let pairs = exact.iter().zip(truth);
    let right = pairs.filter(|(a, b)| difference(**a, **b) <= RIGHT).count();
    100.0 * right as f64 / truth.len().max(1) as f64
}

/// Draws a scene without shadows.
fn unshadowed(source: &Source, quality: Fixed, (size, reflections): (Size, u8)) -> Vec<Pixel> {
    let picture = match quality {
        Fixed::Draft => source.painted::<Draft, Unshadowed>(size, reflections),
        Fixed::Fast => source.painted::<Fast, Unshadowed>(size, reflections),
        Fixed::Small => source.painted::<Small, Unshadowed>(size, reflections),
        Fixed::Exact => source.painted::<Exact, Unshadowed>(size, reflections),
        Fixed::Smooth2 => source.painted::<Smooth<2>, Unshadowed>(size, reflections),
        Fixed::Smooth4 => source.painted::<Smooth<4>, Unshadowed>(size, reflections),
    };
    picture.pixels
}
