//! One scene, drawn by the reference and by qualities, and the pixels that a quality loses. Never reads a file.

use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::geometry::Size;
use reflet::host::file::FileError;
use reflet::host::reference::{Camera, Picture, Scene, pixel, render};

/// A pixel's levels of red, green and blue.
pub type Pixel = [u8; 3];

/// Most that a right pixel differs from the reference, in 255ths of the largest channel.
pub const RIGHT: u8 = 1;

/// Most that a pixel differs from the reference if nobody sees it, in 255ths of the largest channel.
pub const VISIBLE: u8 = 8;

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
    /// How light shines on surfaces.
    pub shading: Shading,
}

/// What the qualities lose of a scene.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Name of the scene.
    pub name: String,
    /// Percentage of the pixels that `Exact` has within [`RIGHT`].
    pub exact: f64,
    /// What each tested quality loses.
    pub lost: Vec<Lost>,
}

/// What one quality loses of a scene.
#[derive(Clone, Debug)]
pub struct Lost {
    /// The tested quality.
    pub quality: Quality,
    /// The picture of this quality.
    pub picture: Picture,
    /// Whether each pixel is lost.
    pub is_lost: Vec<bool>,
}

impl Lost {
    /// Returns the number of lost pixels.
    pub fn count(&self) -> usize {
        self.is_lost.iter().filter(|it| **it).count()
    }

    /// Returns the percentage of lost pixels.
    pub fn percent(&self) -> f64 {
        100.0 * self.count() as f64 / self.is_lost.len().max(1) as f64
    }
}

impl Case {
    /// Draws the scene and finds what the qualities lose. The reference is drawn once.
    ///
    /// # Errors
    ///
    /// The library refuses the scene or the camera.
    pub fn judge(&self, size: Size, qualities: &[Quality]) -> Result<Judged, FileError> {
        let (source, truth) = (self.source()?, self.truth(size));
        let drawn = |quality| source.drawn(size, self.settings(quality));
        let exact = drawn(Quality::Exact);
        let judge = |&quality: &Quality| {
            let picture = drawn(quality);
            // `Exact` decides by bounds what rays can hit. It is tested against `Small`, which tests all.
            let is_lost = match quality {
                Quality::Exact => lost(&truth, &drawn(Quality::Small), &picture),
                _ => lost(&truth, &exact, &picture),
            };
            Lost {
                quality,
                picture,
                is_lost,
            }
        };
        let right = within(&exact, &truth, RIGHT).filter(|it| *it).count();
        Ok(Judged {
            name: self.name.clone(),
            exact: 100.0 * right as f64 / truth.pixels.len().max(1) as f64,
            lost: qualities.iter().map(judge).collect(),
        })
    }

    /// Returns the scene as a source of pictures.
    ///
    /// # Errors
    /// The scene is refused.
    pub fn source(&self) -> Result<Source, FileError> {
        Source::described(self.name.clone(), self.scene.clone(), self.camera.clone())
    }

    /// Returns the settings with which a quality draws the scene.
    pub fn settings(&self, quality: Quality) -> Settings {
        Settings {
            reflections: self.reflections,
            shading: self.shading,
            quality,
        }
    }

    /// Returns the picture in double precision.
    pub fn truth(&self, Size { width, height }: Size) -> Picture {
        let (n, shading) = (self.reflections.into(), self.shading.into());
        render(&self.scene, &self.camera, width, height, n, shading)
    }

    /// Returns one pixel of the picture in double precision.
    pub fn true_pixel(&self, Size { width, height }: Size, at: (u32, u32)) -> Pixel {
        let (n, shading) = (self.reflections.into(), self.shading.into());
        let color = pixel(&self.scene, &self.camera, (width, height), at, n, shading);
        color.map(|it| (255.0 * it).round().clamp(0.0, 255.0) as u8)
    }
}

/// Returns the largest difference of a channel.
pub fn difference(one: Pixel, other: Pixel) -> u8 {
    let channels = one.iter().zip(other).map(|(a, b)| a.abs_diff(b));
    channels.max().unwrap_or(0)
}

/// Tests for each pixel whether two pictures of one size differ by at most this.
pub fn within(one: &Picture, other: &Picture, most: u8) -> impl Iterator<Item = bool> {
    assert_eq!(one.pixels.len(), other.pixels.len());
    let pixels = one.pixels.iter().zip(&other.pixels);
    pixels.map(move |(one, other)| difference(*one, *other) <= most)
}

/// Returns the number of pixels by which two pictures differ by more than this.
pub fn differing(one: &Picture, other: &Picture, most: u8) -> usize {
    within(one, other, most).filter(|is_near| !is_near).count()
}

/// Tests for each pixel whether one quality has it right and the tested one visibly wrong.
fn lost(truth: &Picture, right: &Picture, tested: &Picture) -> Vec<bool> {
    let pixels = within(right, truth, RIGHT).zip(within(tested, truth, VISIBLE));
    let is_lost = pixels.map(|(is_right, is_near)| is_right && !is_near);
    is_lost.collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::families::Family;

    /// Takes a pixel for the seven after it if the next of these eight is alike.
    fn guessed(mut picture: Picture) -> Picture {
        for row in picture.pixels.chunks_mut(picture.width as usize) {
            for first in (0..row.len() - 8).step_by(8) {
                if difference(row[first], row[first + 8]) <= VISIBLE {
                    (first + 1..first + 8).for_each(|at| row[at] = row[first]);
                }
            }
        }
        picture
    }

    #[test]
    fn what_a_guess_loses_is_counted() {
        let (case, size) = (Family::Fences.case(1, 0), Size::new(96, 72));
        let source = case.source().unwrap();
        let exact = source.drawn(size, case.settings(Quality::Exact));
        let is_lost = lost(&case.truth(size), &exact, &guessed(exact.clone()));
        assert!(is_lost.iter().filter(|it| **it).count() > 60);
    }

    #[test]
    fn pixel_is_lost_only_if_one_is_within_1_and_the_other_off_by_more_than_8() {
        let grey = [100; 3];
        for (right, tested, expected) in [
            ([100, 101, 99], [100, 100, 108], false),
            ([101, 99, 100], [109, 100, 100], true),
            ([100, 100, 102], [0; 3], false),
            (grey, [91, 100, 100], true),
            (grey, [92, 108, 100], false),
            (grey, grey, false),
        ] {
            let [truth, one, other] = [grey, right, tested].map(|pixel| Picture {
                width: 1,
                height: 1,
                pixels: vec![pixel],
            });
            let found = lost(&truth, &one, &other);
            assert_eq!(found, [expected], "{right:?} {tested:?}");
        }
    }
}
