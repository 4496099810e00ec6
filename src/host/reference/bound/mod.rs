//! What a picture in fixed point may be off by; it draws nothing in fixed point.
//!
//! Three bounds are added for each pixel, and a step of 8 bits, as both pictures that are compared are
//! rounded by half of one:
//!
//! - **Truncation**: what follows the end of a path adds up to no more than its weight Π αₖ there times
//!   max |c|, the brightest colour that a surface can have.
//! - **Between traced pixels**: what the quality's curves, laid through the exact colours of the
//!   pixels that are traced, are off by. A pixel is taken from a curve only if that passes the
//!   quality's tolerance; where rounding may turn the decision, the worse of both counts.
//! - **Rounding**: a running error analysis (Wilkinson, "Rounding Errors in Algebraic Processes", 1963;
//!   Higham, "Accuracy and Stability of Numerical Algorithms", section 3.3), to the first order.
//!
//! Along a path the analysis carries how far its ray's origin (P, in scene units) and its direction
//! (D, in radians) may be off. With g for a step of the scene's grid:
//!
//! | where | what is added | on account of |
//! |---|---|---|
//! | at the camera | P = 2 g + 2⁻²⁸ · distance from the scene, D = 2⁻²⁶ | positions to a step, far ones to 29 bits; directions Q2.30 through a root of 27 bits |
//! | at a hit t away, c the cosine there | H = (P + t D + 6 g) / c + 2⁻²⁶ t | shapes laid on the grid, a reciprocal of 26 bits; a hit slides along its surface |
//! | its normal | M = H κ + 6 g κ + 2⁻¹⁶ on curvature κ, 2⁻²⁹ on a plane | curved normals have a length of one but for 2⁻¹⁶ |
//! | a light at distance r | L = (H + ε M + 5 g) / r + 2⁻²⁶ | a root of 27 bits |
//! | diffuse light | M + L + 2⁻²⁸, times the coefficient | |
//! | a highlight | the most that its power changes while its cosine does by its error | the power itself is exact to (shininess + 4) 2⁻²⁸ |
//! | a colour | 2⁻²² for the strength of each light, 2⁻²⁰ for each product, 2⁻²⁵ of what is multiplied | each light and the ambient share to 20 bits, 26 in `Exact` behind the point |
//! | its share of the sum | 2⁻²⁴, and 2⁻³⁰ for each weight before it | Q8.24, weights Q2.30 rounded down |
//! | the mirrored ray | P = H + ε M + 2 g, D = D + 2 M + 2⁻²⁶ | a mirror turns a ray by twice what it turns itself |
//!
//! Second order is left out, so where a hit could slide so far that the cosine there is another,
//! at the rim of a curved shape, nothing is promised: such a pixel is `unsure`, and so is one that
//! a ray a 32nd of a pixel beside it decides differently: meets another shape, or is lit by another
//! light.

mod between;
mod path;

use std::vec::Vec;

use rayon::prelude::*;

pub use self::path::{Followed, Precision, Stage};
use super::model::{Vector, View, quantised};
use super::prepared::{self, Prepared};
use super::{Camera, Picture, Scene, Shading};

/// A whole picture of paths, followed in double precision.
#[derive(Clone, Debug)]
pub struct Paths {
    width: u32,
    height: u32,
    /// Each row goes on for some columns to the right of the picture.
    paths: Vec<Followed>,
    brightest: f64,
    dimness: f64,
}

/// When a path of fixed point ends, and which pixels it traces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ending {
    /// After so many reflections.
    pub reflections: usize,
    /// Or when the weight falls below this, as a share of white in a scene brighter than white:
    /// the `SMALLEST_WEIGHT` of the quality.
    pub smallest_weight: f64,
    /// One of so many pixels of a row is traced: 1, 2 or 4.
    pub stride: u32,
    /// How exactly the others must follow a curve, as a share of white.
    pub tolerance: f64,
}

/// What one pixel may be off by, as shares of white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// By what the path was ended before.
    pub truncation: f64,
    /// By the formats.
    pub rounding: f64,
    /// By being taken from pixels beside it.
    pub between: f64,
    /// Rounding may have decided otherwise what is met or lit, here or at a pixel it is taken from:
    /// nothing is promised.
    pub is_unsure: bool,
}

impl Bound {
    /// All of it, as a share of white; no display shows more than 1.
    pub fn share(&self) -> f64 {
        (self.truncation + self.rounding + self.between).min(1.0)
    }

    /// All of it in steps of 8 bits, with the rounding of two pictures; at most 255.
    pub fn levels(&self) -> f64 {
        (255.0 * self.share() + 1.0).min(255.0)
    }
}

/// How many columns to the right of a picture fixed point may look at.
const MARGIN: u32 = 8;

/// How many pixels beside itself a ray has to decide the same for its pixel to be sure.
const BESIDE: f64 = 1.0 / 32.0;

/// The least that is in radians: what a curved normal may be off by, and four times that.
const LEAST_ANGLE: f64 = 1.0 / (1 << 14) as f64;

impl Paths {
    /// Follows the path of every pixel for at most `reflections` reflections.
    ///
    /// # Panics
    ///
    /// A shape names a material that the scene does not have.
    pub fn follow(
        scene: &Scene,
        camera: &Camera,
        size @ (width, height): (u32, u32),
        reflections: usize,
        shading: Shading,
        precision: &Precision,
    ) -> Self {
        let prepared = Prepared::new(scene);
        let view = View::new(&prepared::camera(camera), size);
        let aside = BESIDE.max(LEAST_ANGLE / view.pixel_angle());
        let follow = |x: f64, y: f64| {
            let ray = view.ray_through(x, y);
            path::follow(&prepared.scene(), ray, reflections, shading, precision)
        };
        let columns = width + MARGIN;
        let pixel = |index: u32| {
            let at = |index: u32| f64::from(index) + 0.5;
            let (x, y) = (at(index % columns), at(index / columns));
            let mut own = follow(x, y);
            for (right, down) in [(aside, 0.0), (-aside, 0.0), (0.0, aside), (0.0, -aside)] {
                own.doubt(&follow(x + right, y + down));
            }
            own
        };
        Self {
            width,
            height,
            paths: (0..columns * height).into_par_iter().map(pixel).collect(),
            brightest: brightest(scene),
            dimness: precision.dimness,
        }
    }

    /// The path of a pixel.
    pub fn path(&self, x: u32, y: u32) -> &Followed {
        &self.paths[(y * (self.width + MARGIN) + x) as usize]
    }

    /// The paths of each row, those to the right of the picture, too.
    fn rows(&self) -> impl Iterator<Item = &[Followed]> {
        self.paths.chunks((self.width + MARGIN) as usize)
    }

    /// max |c|: the largest component of any colour that a path can meet.
    pub fn brightest(&self) -> f64 {
        self.brightest
    }

    /// The picture whose paths end so, in double precision.
    pub fn picture(&self, ending: &Ending) -> Picture {
        let Self { width, height, .. } = *self;
        let paths = self.rows().flat_map(|row| &row[..width as usize]);
        let color = |path| quantised(Vector(self.ended(path, ending).color));
        Picture {
            width,
            height,
            pixels: paths.map(color).collect(),
        }
    }

    /// What every pixel may be off by in a picture of fixed point whose paths end so, row by row.
    pub fn bounds(&self, ending: &Ending) -> Vec<Bound> {
        let row = |row: &[Followed]| {
            let stages: Vec<&Stage> = row.iter().map(|path| self.ended(path, ending)).collect();
            let bound = |x: u32| self.bound(&stages, x as usize, ending);
            (0..self.width).map(bound).collect::<Vec<_>>()
        };
        self.rows().flat_map(row).collect()
    }

    fn ended<'a>(&self, path: &'a Followed, ending: &Ending) -> &'a Stage {
        path.ended(ending.reflections, ending.smallest_weight * self.dimness)
    }

    fn bound(&self, row: &[&Stage], x: usize, ending: &Ending) -> Bound {
        let (own, stride) = (row[x], ending.stride as usize);
        // As far as its stretch may reach to both sides.
        let near = |reach: usize| x.saturating_sub(reach)..(x + reach + 1).min(row.len());
        let stretch = &row[near(stride - 1)];
        let is_alike = |stage: &&Stage| stage.trail == own.trail;
        // The curve of its stretch is laid by pixels up to a stretch away from both ends.
        let start = x - x % stride;
        let traced = (start.saturating_sub(stride)..start + 2 * stride + 1).step_by(stride);
        let mut laid_by = traced.filter_map(|column| row.get(column));
        let is_unsure = stretch.iter().any(|it| it.is_unsure)
            || !stretch.iter().all(is_alike)
            || x != start && laid_by.any(|it| it.is_unsure);
        Bound {
            truncation: own.weight * self.brightest,
            rounding: own.rounding,
            between: between::error(row, x, stride, ending.tolerance),
            is_unsure,
        }
    }
}

impl Followed {
    /// Takes for unsure from where a path beside it went another way.
    fn doubt(&mut self, beside: &Self) {
        for (index, stage) in self.stages.iter_mut().enumerate() {
            let other = beside.stages.get(index).map(|it| it.trail);
            stage.is_unsure |= other != Some(stage.trail);
        }
    }
}

/// (ambient + Σ over the lights of (diffuse + specular) · light) · colour, at its brightest in the
/// scene, or the background.
fn brightest(scene: &Scene) -> f64 {
    let own = |material: usize, axis: usize| {
        let material = &scene.materials[material];
        let light: f64 = scene.lights.iter().map(|it| it.color[axis]).sum();
        let strongest = material.diffuse + material.specular;
        (material.ambient + strongest * light) * material.color[axis]
    };
    let materials = scene.shapes().map(|it| it.material);
    let colors = materials.flat_map(|material| (0..3).map(move |axis| own(material, axis)));
    colors.chain(scene.background).fold(0.0, f64::max)
}

/// The largest component, whatever its sign.
fn largest(Vector(components): Vector) -> f64 {
    components.into_iter().map(f64::abs).fold(0.0, f64::max)
}
