//! Measures how far a picture is off, what its bound promises, and where the error comes from. Draws
//! nothing.

use anyhow::Result;
use embedded_graphics::geometry::Size;
use reflet::host::compare::compare;
use reflet::host::precision;
use reflet::host::reference::bound::{Bound, Ending, Paths};
use reflet::host::reference::{self, Picture, Shading};
use xtask::sweep::{Contestant, Level, Setting};

use crate::paint::Painter;

/// Number of reflections that stands for all of them. The rest of a path is then darker than a
/// display can show, unless its mirrors reflect nearly all light.
const ALL: u32 = 2000;

/// Number of reflections that paths are followed: the most that a setting can have, plus one.
const FOLLOWED: usize = 256;

/// Reference picture and paths of a scene, against which its pictures are measured.
pub struct Truth {
    /// Picture of the double-precision reference with all reflections.
    pub picture: Picture,
    paths: Paths,
}

#[derive(Clone, Debug)]
pub struct Errors {
    /// PSNR of all pixels in decibels; infinite if no pixel differs.
    pub psnr: f64,
    /// Largest difference of a channel, in levels of 255.
    pub largest: u8,
    /// Share of the pixels that are the same as the reference's.
    pub same: f64,
    pub within1: f64,
    /// Promised bounds. `None` except for fixed point with shadows at full resolution.
    pub promised: Option<Promised>,
    /// Sources of the error. Each is the root of the mean square of that source alone, in 255ths.
    pub parts: Parts,
}

/// Bounds that are promised for a picture, and the measured errors that they are compared with.
#[derive(Clone, Copy, Debug)]
pub struct Promised {
    /// Share of the pixels that are sure, 0 to 1: rounding cannot change what their paths hit.
    pub sure: f64,
    /// Number of unsure pixels that differ by more than 1 level from the exact path that ends at the
    /// same reflection.
    pub decided: usize,
    /// Number of sure pixels whose error is larger than their bound; must be 0.
    pub broken: usize,
    /// Largest difference of a channel among the sure pixels, in levels of 255.
    pub largest: u8,
    pub bound: f64,
    /// PSNR of the sure pixels, in decibels.
    pub psnr: f64,
    pub bound_psnr: f64,
    /// Largest truncation bound of the sure pixels, in 255ths: Π αₖ · max |c|, for the reflections
    /// that are left out or cut off.
    pub truncation: f64,
    /// Largest rounding bound of the sure pixels, in 255ths.
    pub rounding: f64,
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Parts {
    pub truncation: f64,
    pub cut_off: f64,
    /// Error of pixels that are interpolated between traced ones.
    pub between: f64,
    /// Error of the fixed-point formats.
    pub rounding: f64,
    /// Error of pixels in which rounding changed what the path hits.
    pub decided: f64,
    /// Error of shadows that are left out, and of larger pixels.
    pub simplified: f64,
}

impl Truth {
    pub fn new(painter: &Painter) -> Self {
        let Size { width, height } = painter.size;
        let (scene, camera) = (&painter.scene, &painter.exact_camera);
        let (shading, size) = (Shading::BlinnPhong, (width, height));
        let precision = precision(painter.source.scene());
        Self {
            picture: reference::render(scene, camera, width, height, ALL, shading),
            paths: Paths::follow(scene, camera, size, FOLLOWED, shading, &precision),
        }
    }

    pub fn errors(
        &self,
        painter: &Painter,
        setting: &Setting,
        picture: &Picture,
    ) -> Result<Errors> {
        let found = compare(picture, &self.picture)?;
        let mut errors = Errors {
            psnr: found.psnr,
            largest: found.max,
            same: found.same,
            within1: found.within1,
            promised: None,
            parts: Parts::default(),
        };
        let reflections = setting.reflections;
        let level = match setting.contestant {
            Contestant::Fixed(level) => level,
            Contestant::Unshadowed => Level::Fast,
            Contestant::Float => {
                let ending = ending(painter, Level::Exact, reflections);
                errors.parts.truncation = self.apart_from(&self.paths.picture(&ending));
                return Ok(errors);
            }
        };
        let is_plain = setting.contestant != Contestant::Unshadowed && setting.scale == 1;
        let full = match is_plain {
            true => picture,
            false => &painter.paint(&Setting::fixed(level, reflections)),
        };
        let (parts, promised) = self.parts(painter, level, reflections, full);
        errors.parts = Parts {
            simplified: apart(picture, full, |_| true),
            ..parts
        };
        errors.promised = is_plain.then_some(promised);
        Ok(errors)
    }

    fn apart_from(&self, picture: &Picture) -> f64 {
        apart(picture, &self.picture, |_| true)
    }

    /// Measures the sources of the error and the promised bounds of a picture with shadows at full
    /// resolution.
    fn parts(
        &self,
        painter: &Painter,
        level: Level,
        reflections: u8,
        picture: &Picture,
    ) -> (Parts, Promised) {
        let ending = ending(painter, level, reflections);
        let (bounds, exact) = (self.paths.bounds(&ending), self.paths.picture(&ending));
        let all = self.paths.picture(&Ending {
            smallest_weight: 0.0,
            ..ending
        });
        let traced = painter.paint_traced(level, reflections);
        let is_sure = |pixel: usize| !bounds[pixel].is_unsure;
        // Compares with the exact picture of the same ending. Otherwise truncated reflections could
        // hide a path that took another way.
        let decided = (0..bounds.len())
            .map(|pixel| bounds[pixel].is_unsure && difference(picture, &exact, pixel) > 1);
        let decided: Vec<bool> = decided.collect();
        let parts = Parts {
            truncation: self.apart_from(&all),
            cut_off: apart(&exact, &all, |_| true),
            between: apart(picture, &traced, |pixel| !decided[pixel]),
            rounding: apart(&traced, &exact, |pixel| !decided[pixel] && is_sure(pixel)),
            decided: apart(picture, &exact, |pixel| decided[pixel]),
            simplified: 0.0,
        };
        let sure: Vec<(u8, &Bound)> = (0..bounds.len())
            .filter(|pixel| is_sure(*pixel))
            .map(|pixel| (difference(picture, &self.picture, pixel), &bounds[pixel]))
            .collect();
        let most = |of: fn(&Bound) -> f64| sure.iter().map(|it| of(it.1)).fold(0.0, f64::max);
        let squares = sure.iter().map(|(_, bound)| bound.levels().powi(2));
        let (all, count) = (bounds.len().max(1) as f64, sure.len().max(1) as f64);
        let broken = |it: &&(u8, &Bound)| f64::from(it.0) > it.1.levels();
        let promised = Promised {
            sure: sure.len() as f64 / all,
            decided: decided.iter().filter(|it| **it).count(),
            broken: sure.iter().filter(broken).count(),
            largest: sure.iter().map(|it| it.0).max().unwrap_or(0),
            bound: most(Bound::levels),
            psnr: decibels(apart(picture, &self.picture, is_sure).powi(2) * (all / count)),
            bound_psnr: decibels(squares.sum::<f64>() / count),
            truncation: most(|bound| (255.0 * bound.truncation).min(255.0)),
            rounding: most(|bound| (255.0 * bound.rounding).min(255.0)),
        };
        (parts, promised)
    }
}

/// Returns where the paths of a level end, and which pixels are traced.
fn ending(painter: &Painter, level: Level, reflections: u8) -> Ending {
    let numbers = level.numbers();
    Ending {
        reflections: reflections.into(),
        smallest_weight: numbers.smallest_weight.to_num(),
        block: Ending::block_of(painter.size.width, numbers.tolerance.to_num()),
        tolerance: numbers.tolerance.to_num(),
    }
}

fn decibels(mean_square: f64) -> f64 {
    10.0 * (255.0_f64.powi(2) / mean_square).log10()
}

fn difference(a: &Picture, b: &Picture, pixel: usize) -> u8 {
    let pairs = a.pixels[pixel].into_iter().zip(b.pixels[pixel]);
    pairs.map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0)
}

/// Returns the root of the mean square of the differences of the pixels for which `is_asked` holds,
/// divided by the number of all pixels.
fn apart(a: &Picture, b: &Picture, is_asked: impl Fn(usize) -> bool) -> f64 {
    let pixels = a.pixels.iter().zip(&b.pixels).enumerate();
    let asked = pixels.filter(|(index, _)| is_asked(*index));
    let channels = asked.flat_map(|(_, (a, b))| a.iter().zip(b));
    let squares = channels.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2));
    // Starts with +0, because the sum of an empty iterator is -0.
    let sum = squares.fold(0.0, |sum, it| sum + it);
    (sum / (3 * a.pixels.len()) as f64).sqrt()
}
