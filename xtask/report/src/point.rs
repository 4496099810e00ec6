//! What is known of one setting: what it costs, what it loses, and why.

use crate::error::Errors;
use crate::settings::Setting;

/// A setting with all that is known of it.
#[derive(Clone, Debug)]
pub struct Point {
    pub setting: Setting,
    /// The core it was measured on.
    pub core: &'static str,
    pub cost: Cost,
    /// Of the picture.
    pub pixels: u64,
    pub errors: Errors,
    /// Whether no other setting of its contestant is cheaper and has less error.
    pub is_on_front: bool,
}

/// What a picture takes.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// Instructions a pixel, or percents of the reference's time: the median.
    pub middle: f64,
    /// Its quartiles, where it was not counted.
    pub quartiles: Option<(f64, f64)>,
    /// Instructions of the preparation, where they were counted.
    pub prepare: Option<u64>,
    /// Of the picture, as the core drew it.
    pub hash: String,
}

impl Point {
    /// The number that fronts are made by: the peak signal-to-noise ratio.
    pub fn psnr(&self) -> f64 {
        self.errors.psnr
    }

    /// In words, with where it ran if that is not the report's core.
    pub fn words(&self) -> String {
        self.setting.words()
    }
}

/// Marks the points that no other one is cheaper than and has less error.
pub fn mark_front(points: &mut [Point]) {
    let on_front: Vec<bool> = points
        .iter()
        .map(|point| {
            !points.iter().any(|other| {
                let is_cheaper = other.cost.middle < point.cost.middle;
                let is_better = other.psnr() > point.psnr();
                is_cheaper && other.psnr() >= point.psnr()
                    || is_better && other.cost.middle <= point.cost.middle
            })
        })
        .collect();
    for (point, is_on_front) in points.iter_mut().zip(on_front) {
        point.is_on_front = is_on_front;
    }
}

/// The points of a front, the cheapest first; each is at least `gain` decibels better than the last.
pub fn front(points: &[Point], gain: f64) -> Vec<&Point> {
    let mut front: Vec<&Point> = points.iter().filter(|it| it.is_on_front).collect();
    front.sort_by(|a, b| a.cost.middle.total_cmp(&b.cost.middle));
    let best = front.last().map_or(0.0, |it| it.psnr());
    let mut kept: Vec<&Point> = Vec::new();
    for point in front {
        let is_new = kept
            .last()
            .is_none_or(|last| point.psnr() >= last.psnr() + gain);
        if is_new || point.psnr() == best && kept.last().is_none_or(|last| last.psnr() < best) {
            kept.push(point);
        }
    }
    kept
}
