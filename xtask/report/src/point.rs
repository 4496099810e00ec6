//! What is known of one setting: what it costs, what it loses, and why.

use xtask::sweep::Setting;

use crate::error::Errors;

#[derive(Clone, Debug)]
pub struct Point {
    pub setting: Setting,
    pub core: &'static str,
    pub cost: Cost,
    /// Of the picture.
    pub pixels: u64,
    pub errors: Errors,
    /// Whether no other setting of its contestant is cheaper and has less error.
    pub is_on_front: bool,
}

#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    /// Instructions a pixel, or percents of the reference's time: the median.
    pub middle: f64,
    /// Its quartiles, where it was not counted.
    pub quartiles: Option<(f64, f64)>,
    /// Instructions of the preparation, where they were counted.
    pub prepare: Option<u64>,
    /// Of the picture, as the core drew it.
    pub hash: u64,
}

impl Point {
    /// The number that fronts are made by: the peak signal-to-noise ratio.
    pub fn psnr(&self) -> f64 {
        self.errors.psnr
    }
}

/// Marks the points that no other one is cheaper than and has less error.
pub fn mark_front(points: &mut [Point]) {
    for index in 0..points.len() {
        let (cost, psnr) = (points[index].cost.middle, points[index].psnr());
        let is_beaten = points.iter().any(|other| {
            let (other_cost, other_psnr) = (other.cost.middle, other.psnr());
            other_cost < cost && other_psnr >= psnr || other_psnr > psnr && other_cost <= cost
        });
        points[index].is_on_front = !is_beaten;
    }
}

/// A shown point of a front is this many decibels better than the last.
pub const GAIN: f64 = 0.25;

/// The points of a front, the cheapest first; each is at least `gain` decibels better than the last.
/// The best is always among them.
pub fn front(points: &[Point], gain: f64) -> Vec<&Point> {
    let mut front: Vec<&Point> = points.iter().filter(|it| it.is_on_front).collect();
    front.sort_by(|a, b| a.cost.middle.total_cmp(&b.cost.middle));
    let best = front.last().map_or(0.0, |it| it.psnr());
    let mut kept: Vec<&Point> = Vec::new();
    for point in front {
        let psnr = point.psnr();
        let is_new =
            |last: &&Point| psnr > last.psnr() && (psnr >= last.psnr() + gain || psnr == best);
        if kept.last().is_none_or(is_new) {
            kept.push(point);
        }
    }
    kept
}
