//! Bounds the error of each pixel of a fixed-point picture, from paths followed in double precision.
//! This module draws nothing in fixed point.
//!
//! The bound of a pixel is the sum of three bounds and one step of 8 bits. The step is there because
//! each of the two compared pictures is rounded by up to half a step:
//!
//! - **Truncation**: the light that a path loses by ending early. It is at most the path's weight Π αₖ
//!   at its end times max |c|, the brightest colour that a surface can have.
//! - **Between traced pixels**: the error of interpolated pixels: the distance of the quality's curves,
//!   laid through the exact colours of the traced pixels, from the exact colours. A pixel is
//!   interpolated only if the curve passes the quality's tolerance. Where rounding may change that
//!   decision, the larger error of both cases counts.
//! - **Rounding**: a running error analysis (Wilkinson, "Rounding Errors in Algebraic Processes", 1963;
//!   Higham, "Accuracy and Stability of Numerical Algorithms", section 3.3), to the first order.
//!
//! Along a path the analysis tracks the error of the ray's origin (P, in scene units) and of its
//! direction (D, in radians). With g for a step of the scene's grid:
//!
//! | where | error | reason |
//! |---|---|---|
//! | at the camera | P = 2 g + 2⁻²⁸ · distance from the scene, D = 2⁻²⁶ | positions to a step, far ones to 29 bits; directions Q2.30 through a root of 27 bits |
//! | at a hit t away, c the cosine there | H = (P + t D + 6 g) / c + 2⁻²⁶ t | shapes are rounded to the grid, a reciprocal has 26 bits; a hit moves along its surface |
//! | the normal there | M = H κ + 6 g κ + 2⁻¹⁶ for curvature κ, 2⁻²⁹ on a plane | the length of curved normals is one to within 2⁻¹⁶ |
//! | a light at distance r | L = (H + ε M + 5 g) / r + 2⁻²⁶ | a root of 27 bits |
//! | diffuse light | M + L + 2⁻²⁸, times the coefficient | |
//! | a highlight | the largest change of its power while its cosine changes by its error | the power itself is exact to (shininess + 4) 2⁻²⁸ |
//! | the share s of a light that falls off | 2 s (1 - s) L + 2⁻²⁴ | Q2.30, from the squares of distance and range |
//! | a colour | 2⁻²² for the strength of each light, 2⁻²⁰ for each product, 2⁻²⁵ of the light that is multiplied | each light and the ambient share have 20 fraction bits, 26 in `Exact` |
//! | the colour's share of the sum | 2⁻²⁴, and 2⁻³⁰ for each weight before it | Q8.24, weights Q2.30 rounded down |
//! | the mirrored ray | P = H + ε M + 2 g, D = D + 2 M + 2⁻²⁶ | a mirror that turns by an angle turns the ray by twice that angle |
//!
//! Errors of second order are left out. So at the rim of a curved shape, where the hit may move so far
//! that the cosine changes, the bound may not hold: such a pixel is marked *unsure*. A pixel is also
//! unsure if a ray a 32nd of a pixel beside it hits another shape or is lit by another light.

mod between;
mod edges;
mod path;

use std::vec::Vec;

use rayon::prelude::*;

pub use self::path::{Followed, Precision, Stage};
use super::model::{Vector, View, quantised};
use super::prepared::{self, Prepared};
use super::{Camera, Picture, Scene, Shading};
use crate::render::block_of;

/// The paths of all pixels of a picture, followed in double precision.
///
/// ```
/// use reflet::host::reference::bound::{Bound, Ending, Followed, Paths, Precision, Stage};
/// use reflet::host::reference::{Camera, Material, Plane, Scene, Shading};
///
/// // A mirror under a sky of 0.5.
/// let glass = Material {
///     color: [1.0; 3], ambient: 1.0, diffuse: 0.0, specular: 0.0, shininess: 1.0, mirror: 0.5, checker: None,
/// };
/// let scene = Scene {
///     planes: vec![Plane { point: [0.0; 3], normal: [0.0, 0.0, 1.0], material: 0 }],
///     materials: vec![glass],
///     background: [0.5; 3],
///     ..Scene::default()
/// };
/// let (position, up) = ([0.0, 0.0, 2.0], [0.0, 1.0, 0.0]);
/// let camera = Camera { position, target: [0.0; 3], up, fov: 40.0 };
/// let grid = Precision { step: 1.0 / 1_048_576.0, middle: [0.0; 3], dimness: 1.0 };
/// let paths = Paths::follow(&scene, &camera, (5, 5), 4, Shading::BlinnPhong, &grid);
///
/// let path: &Followed = paths.path(2, 2);
/// assert_eq!(path.stages.len(), 2); // the plane, then the sky
/// let hit: &Stage = path.ended(0, 0.0);
/// assert_eq!((hit.color, hit.weight, hit.is_unsure), ([0.5; 3], 0.5, false));
/// assert_ne!(hit.trail, path.ended(4, 0.0).trail);
///
/// let ending = Ending { reflections: 0, smallest_weight: 0.0, block: 1, tolerance: 0.0 };
/// let bound: Bound = paths.bounds(&ending)[12];
/// assert_eq!((bound.truncation, bound.between, bound.is_unsure), (0.5, 0.0, false));
/// assert!(bound.rounding < 1e-5 && bound.share() > 0.5 && bound.levels() > 128.0);
/// assert_eq!((paths.brightest(), paths.picture(&ending).pixels[12]), (1.0, [128; 3]));
/// ```
#[derive(Clone, Debug)]
pub struct Paths {
    width: u32,
    height: u32,
    /// The paths, row by row.
    paths: Vec<Followed>,
    brightest: f64,
    dimness: f64,
}

/// The settings of a fixed-point picture: where paths end, and which pixels are traced.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ending {
    /// Largest number of reflections of a path.
    pub reflections: usize,
    /// Weight below which a path ends: the `SMALLEST_WEIGHT` of the quality. In a scene brighter than
    /// white it is a share of white, so it is divided by the brightest colour.
    pub smallest_weight: f64,
    /// Number of columns of the blocks into which a row is divided: a power of two, 1 if every pixel is
    /// traced. [`Ending::block_of`] returns it.
    pub block: u32,
    /// Tolerance for interpolated pixels, as a share of white: the `TOLERANCE` of the quality.
    pub tolerance: f64,
}

/// The error bound of one pixel in three parts, each as a share of white.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// Bound of the light that is lost because the path ends early.
    pub truncation: f64,
    /// Bound of the error by rounding to the fixed-point formats.
    pub rounding: f64,
    /// Bound of the error by interpolation between traced pixels.
    pub between: f64,
    /// Whether the bound may not hold. Rounding may change which shape is hit or which light shines, at
    /// this pixel or at one that it is interpolated from.
    pub is_unsure: bool,
}

impl Bound {
    /// Returns the sum of the three bounds, as a share of white. It is at most 1, the range of a
    /// display.
    pub fn share(&self) -> f64 {
        (self.truncation + self.rounding + self.between).min(1.0)
    }

    /// Returns the bound in steps of 8 bits, at most 255. It includes one step for the rounding of both
    /// compared pictures.
    pub fn levels(&self) -> f64 {
        (255.0 * self.share() + 1.0).min(255.0)
    }
}

/// Distance in pixels from a pixel's ray to four rays beside it. Where one of the four takes another path,
/// the pixel is unsure.
const BESIDE: f64 = 1.0 / 32.0;

/// Smallest value of the distance [`BESIDE`] as an angle, in radians: 2⁻¹⁴, four times the error 2⁻¹⁶ of
/// a curved normal.
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
        let pixel = |index: u32| {
            let at = |index: u32| f64::from(index) + 0.5;
            let (x, y) = (at(index % width), at(index / width));
            let mut own = follow(x, y);
            for (right, down) in [(aside, 0.0), (-aside, 0.0), (0.0, aside), (0.0, -aside)] {
                own.doubt(&follow(x + right, y + down));
            }
            own
        };
        Self {
            width,
            height,
            paths: (0..width * height).into_par_iter().map(pixel).collect(),
            brightest: brightest(scene),
            dimness: precision.dimness,
        }
    }

    /// Returns the path of the pixel in column `x` and row `y`.
    pub fn path(&self, x: u32, y: u32) -> &Followed {
        &self.paths[(y * self.width + x) as usize]
    }

    /// Returns max |c|: an upper bound of the components of all colours of surfaces and of the
    /// background.
    pub fn brightest(&self) -> f64 {
        self.brightest
    }

    /// Returns the picture in double precision whose paths end as `ending` says.
    pub fn picture(&self, ending: &Ending) -> Picture {
        let Self { width, height, .. } = *self;
        let color = |path| quantised(Vector(self.ended(path, ending).color));
        Picture {
            width,
            height,
            pixels: self.paths.iter().map(color).collect(),
        }
    }

    /// Returns the error bound of every pixel of a fixed-point picture with these settings, row by row.
    pub fn bounds(&self, ending: &Ending) -> Vec<Bound> {
        let row = |row: &[Followed]| {
            let stages: Vec<&Stage> = row.iter().map(|path| self.ended(path, ending)).collect();
            let slacks = between::slacks(&stages, ending.block as usize);
            let bound = |x: u32| self.bound((&stages, &slacks), x as usize, ending);
            (0..self.width).map(bound).collect::<Vec<_>>()
        };
        let rows = self.paths.par_chunks(self.width as usize);
        rows.flat_map_iter(row).collect()
    }

    fn ended<'a>(&self, path: &'a Followed, ending: &Ending) -> &'a Stage {
        path.ended(ending.reflections, ending.smallest_weight * self.dimness)
    }

    fn bound(&self, (row, slacks): (&[&Stage], &[Vec<f64>]), x: usize, ending: &Ending) -> Bound {
        let own = row[x];
        let (between, is_unsure) = between::error((row, slacks), x, ending);
        Bound {
            truncation: own.weight * self.brightest,
            rounding: own.rounding,
            between,
            is_unsure: own.is_unsure || is_unsure,
        }
    }
}

impl Ending {
    /// Returns the number of columns of a block in a picture of `width` columns, in a quality with this
    /// tolerance that does not leave out the code for speed.
    pub fn block_of(width: u32, tolerance: f64) -> u32 {
        if tolerance == 0.0 { 1 } else { block_of(width, false) }
    }
}

impl Followed {
    /// Marks each stage as unsure at which the path `beside` this one has another trail or has ended.
    fn doubt(&mut self, beside: &Self) {
        for (index, stage) in self.stages.iter_mut().enumerate() {
            let other = beside.stages.get(index).map(|it| it.trail);
            stage.is_unsure |= other != Some(stage.trail);
        }
    }
}

/// Returns the largest colour component in a scene: the background's, or a material's
/// (ambient + (diffuse + specular) · Σ lights) · colour.
fn brightest(scene: &Scene) -> f64 {
    let own = |material: usize, axis: usize| {
        let material = &scene.materials[material];
        let light: f64 = scene.lights.iter().map(|it| it.color[axis]).sum();
        let strongest = material.diffuse + material.specular;
        let color = material.checker.map_or(0.0, |it| it.color[axis]);
        (material.ambient + strongest * light) * material.color[axis].max(color)
    };
    let materials = scene.shapes().map(|it| it.material);
    let colors = materials.flat_map(|material| (0..3).map(move |axis| own(material, axis)));
    let sky = scene.sky.iter();
    let sky = sky.flat_map(|it| it.below.into_iter().chain(it.horizon).chain(it.above));
    colors
        .chain(scene.background)
        .chain(sky)
        .fold(0.0, f64::max)
}

/// Returns the largest absolute value of the components of a vector.
fn largest(Vector(components): Vector) -> f64 {
    components.into_iter().map(f64::abs).fold(0.0, f64::max)
}
