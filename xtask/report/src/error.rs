//! What a picture is off by, what it may be off by, and where that comes from; it draws nothing.

use anyhow::Result;
use embedded_graphics::geometry::Size;
use reflet::host::compare::compare;
use reflet::host::precision;
use reflet::host::reference::bound::{Bound, Ending, Paths};
use reflet::host::reference::{self, Picture, Shading};
use xtask::sweep::{Contestant, Level, Setting};

use crate::paint::Painter;

/// How many reflections stand for all of them: what is left of a path then is less than a display
/// shows, unless its mirrors keep nearly everything for ever.
const ALL: u32 = 2000;

/// As many as a setting can have, and one.
const FOLLOWED: usize = 256;

/// What a scene's pictures are measured by.
pub struct Truth {
    /// With all reflections.
    pub picture: Picture,
    paths: Paths,
}

#[derive(Clone, Debug)]
pub struct Errors {
    /// Of all pixels, in decibels; infinite where nothing differs.
    pub psnr: f64,
    /// The largest difference of a channel.
    pub largest: u8,
    /// Shares of the pixels that are the same and within 1.
    pub same: f64,
    pub within1: f64,
    /// Where something is promised: in fixed point, with shadows, at full resolution.
    pub promised: Option<Promised>,
    /// Where the error comes from: the root of the mean square in 255ths, of each part alone.
    pub parts: Parts,
}

/// What is promised of a picture, and how it is kept.
#[derive(Clone, Copy, Debug)]
pub struct Promised {
    /// The share of the pixels that are sure: 0 to 1.
    pub sure: f64,
    /// How many pixels that are not sure are further than 1 from what their ending comes to.
    pub decided: usize,
    /// How many were further off although they were sure: none.
    pub broken: usize,
    /// The largest difference of a channel, and the largest bound, of those that are sure.
    pub largest: u8,
    pub bound: f64,
    /// The PSNR of those that are sure, and the least that their bounds allow.
    pub psnr: f64,
    pub bound_psnr: f64,
    /// Π αₖ · max |c| with what is left out, in 255ths, at its largest.
    pub truncation: f64,
    /// What rounding may do, in 255ths, at its largest.
    pub rounding: f64,
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Parts {
    pub truncation: f64,
    pub cut_off: f64,
    /// From pixels that are taken from those beside them.
    pub between: f64,
    /// From the formats.
    pub rounding: f64,
    /// From pixels where rounding decided otherwise what is met.
    pub decided: f64,
    /// From shadows that are left out, and from larger pixels.
    pub simplified: f64,
}

impl Parts {
    pub fn largest(&self) -> &'static str {
        let parts = [
            (self.truncation, "reflections left out"),
            (self.cut_off, "the weight cut-off"),
            (self.between, "pixels between traced ones"),
            (self.rounding, "rounding"),
            (self.decided, "edges that rounding decides otherwise"),
            (self.simplified, "larger pixels or shadows left out"),
        ];
        let largest = parts.iter().max_by(|a, b| a.0.total_cmp(&b.0));
        largest.map_or("nothing", |part| part.1)
    }
}

impl Truth {
    pub fn new(painter: &Painter) -> Self {
        let Size { width, height } = painter.size;
        let (scene, camera) = (&painter.scene, &painter.exact_camera);
        let (shading, size) = (Shading::BlinnPhong, (width, height));
        let precision = precision(&*painter.world);
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
        let Contestant::Fixed { level, shadows } = setting.contestant else {
            let ending = ending(painter, Level::EXACT, reflections);
            errors.parts.truncation = self.apart_from(&self.paths.picture(&ending));
            return Ok(errors);
        };
        let is_plain = shadows && setting.scale == 1;
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

    /// Of a picture with shadows and at full resolution.
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
        // Against the same ending, so that what was cut off hides no wrong decision.
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

/// Where the paths of a level end, and which of them are traced.
fn ending(painter: &Painter, level: Level, reflections: u8) -> Ending {
    let numbers = level.numbers();
    let is_of_planes = painter.scene.shapes().all(|it| it.kind == "plane");
    Ending {
        reflections: reflections.into(),
        smallest_weight: numbers.smallest_weight.to_num(),
        stride: match numbers.stride {
            2.. if is_of_planes => 4,
            stride => stride,
        },
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

/// The root of the mean square, over all pixels, of how far apart those are that are asked for.
fn apart(a: &Picture, b: &Picture, is_asked: impl Fn(usize) -> bool) -> f64 {
    let pixels = a.pixels.iter().zip(&b.pixels).enumerate();
    let asked = pixels.filter(|(index, _)| is_asked(*index));
    let channels = asked.flat_map(|(_, (a, b))| a.iter().zip(b));
    let squares = channels.map(|(a, b)| f64::from(a.abs_diff(*b)).powi(2));
    // Not -0, which an empty sum is.
    let sum = squares.fold(0.0, |sum, it| sum + it);
    (sum / (3 * a.pixels.len()) as f64).sqrt()
}
