//! One scene, drawn by the reference and by a quality, and the pixels that the quality loses. Never opens a file.

use command_line::{Quality, Settings, Shading, Source, scene_file};
use embedded_graphics::geometry::Size;
use reflet::host::file::FileError;
use reflet::host::reference::{Camera, Scene, render};

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

/// What a quality loses of a scene.
#[derive(Clone, Debug)]
pub struct Judged {
    /// Percentage of the pixels that `Exact` has within [`RIGHT`].
    pub exact: f64,
    /// Whether each pixel is lost.
    pub is_lost: Vec<bool>,
}

impl Judged {
    /// Returns the percentage of lost pixels.
    pub fn percent(&self) -> f64 {
        let count = self.is_lost.iter().filter(|it| **it).count();
        100.0 * count as f64 / self.is_lost.len() as f64
    }
}

impl Case {
    /// Draws the scene and finds what a quality loses.
    ///
    /// # Errors
    ///
    /// The library refuses the scene or the camera.
    pub fn judge(&self, size: Size, quality: Quality) -> Result<Judged, FileError> {
        let source = self.source()?;
        let (n, shading) = (self.reflections.into(), self.shading.into());
        let truth = render(
            &self.scene,
            &self.camera,
            size.width,
            size.height,
            n,
            shading,
        )
        .pixels;
        let drawn = |quality| {
            let settings = Settings {
                reflections: self.reflections,
                shading: self.shading,
                quality,
            };
            source.drawn(size, settings).pixels
        };
        let exact = drawn(Quality::Exact);
        // `Exact` decides by bounds what rays can hit. It is tested against `Small`, which tests all.
        let is_lost = match quality {
            Quality::Exact => lost(&truth, &drawn(Quality::Small), &exact),
            _ => lost(&truth, &exact, &drawn(quality)),
        };
        let right = exact.iter().zip(&truth);
        let right = right.filter(|(a, b)| difference(**a, **b) <= RIGHT).count();
        Ok(Judged {
            exact: 100.0 * right as f64 / truth.len() as f64,
            is_lost,
        })
    }

    /// Returns the text of a scene file. Materials are named by their numbers. Files do not hold the number of
    /// reflections.
    pub fn json(&self) -> String {
        let materials = 0..self.scene.materials.len();
        let materials: Vec<_> = materials.map(|index| index.to_string()).collect();
        scene_file::text(&self.name, &materials, &self.scene, &self.camera)
    }

    /// Returns the scene as a source of pictures.
    ///
    /// # Errors
    /// The scene is refused.
    pub fn source(&self) -> Result<Source, FileError> {
        Source::described(self.name.clone(), self.scene.clone(), self.camera.clone())
    }
}

/// Returns the largest difference of a channel.
pub fn difference(one: Pixel, other: Pixel) -> u8 {
    let channels = one.iter().zip(other).map(|(a, b)| a.abs_diff(b));
    channels.max().unwrap_or(0)
}

/// Tests for each pixel whether one quality has it right and the tested one visibly wrong.
fn lost(truth: &[Pixel], right: &[Pixel], tested: &[Pixel]) -> Vec<bool> {
    let pixels = truth.iter().zip(right).zip(tested);
    let is_lost = pixels.map(|((truth, right), tested)| {
        difference(*right, *truth) <= RIGHT && difference(*tested, *truth) > VISIBLE
    });
    is_lost.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

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
            let found = lost(&[grey], &[right], &[tested]);
            assert_eq!(found, [expected], "{right:?} {tested:?}");
        }
    }
}
