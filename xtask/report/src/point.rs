//! What is known of one setting: its cost, its error, and the sources of the error.

use xtask::sweep::Setting;

use crate::error::Errors;

#[derive(Clone, Debug)]
pub struct Point {
    pub setting: Setting,
    pub core: &'static str,
    pub cost: Cost,
    /// Number of pixels of the picture.
    pub pixels: u64,
    pub errors: Errors,
    /// Whether no other setting of the same contestant is cheaper and has less error.
    pub is_on_front: bool,
}

#[derive(Clone, Debug)]
pub struct Cost {
    /// Instructions a pixel.
    pub instructions: f64,
    /// Instructions of the preparation.
    pub prepare: u64,
    /// Hash of the picture that the core drew.
    pub hash: u64,
}

impl Point {
    /// Returns the peak signal-to-noise ratio in decibels. The front compares points by it.
    pub fn psnr(&self) -> f64 {
        self.errors.psnr
    }
}

/// Sets `is_on_front` of every point: no other point is at least as good in cost and PSNR and better
/// in one of them.
pub fn mark_front(points: &mut [Point]) {
    for index in 0..points.len() {
        let (cost, psnr) = (points[index].cost.instructions, points[index].psnr());
        let is_beaten = points.iter().any(|other| {
            let (other_cost, other_psnr) = (other.cost.instructions, other.psnr());
            other_cost < cost && other_psnr >= psnr || other_psnr > psnr && other_cost <= cost
        });
        points[index].is_on_front = !is_beaten;
    }
}

/// Smallest gain in decibels from one shown point of a front to the next.
pub const GAIN: f64 = 0.25;

/// Returns the points of a front, the cheapest first. Each is at least `gain` decibels better than
/// the one before. The best point is always included.
pub fn front(points: &[Point], gain: f64) -> Vec<&Point> {
    let mut front: Vec<&Point> = points.iter().filter(|it| it.is_on_front).collect();
    front.sort_by(|a, b| a.cost.instructions.total_cmp(&b.cost.instructions));
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
