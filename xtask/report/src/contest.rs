//! Compares the error of fixed point with that of float at the same cost, and says why float has
//! less error where it has.

use std::cmp::Ordering;
use std::ops::RangeInclusive;

use crate::arguments::Core;
use crate::page::{cost, decibels};
use crate::point::Point;
use crate::scene::Measured;

/// Costs at which fixed point is compared with float, in instructions a pixel.
const RANGE: RangeInclusive<f64> = 300.0..=5000.0;

/// Largest number of points with less error in float that are explained.
const MOST_LOST: usize = 4;

/// Comparison of the points of a scene's Pareto front with float. Each point is counted in one of
/// the fields below; fixed point has less error at the points that are left.
pub struct Contest<'a> {
    name: &'a str,
    compared: usize,
    /// Points where float has the same error.
    same: usize,
    /// Points at which every setting of float costs more.
    alone: usize,
    /// Reasons of the points where float has less error, one text for each.
    lost: Vec<String>,
}

/// Returns the verdict over all scenes, in one sentence.
pub fn verdict(contests: &[Contest], core: Core) -> String {
    let compared: usize = contests.iter().map(|it| it.compared).sum();
    let less: usize = contests.iter().map(Contest::less).sum();
    let at = format!("{less} of {compared} points of the front");
    match core {
        Core::Host => format!(
            "In the same time, fixed point has less error than f32 at {at}, both on this machine."
        ),
        Core::Emulated(_) if compared == 0 => format!(
            "No point of the front lies between {} and {} instructions a pixel, where fixed point \
             is compared with f32.",
            RANGE.start(),
            RANGE.end()
        ),
        Core::Emulated(core) => format!(
            "For the same number of instructions, fixed point on a {} has less error than f32 on a \
             Cortex-M4F with FPU at {at}, from {} to {} instructions a pixel.",
            core.title,
            RANGE.start(),
            RANGE.end()
        ),
    }
}

impl<'a> Contest<'a> {
    pub fn new(scene: &'a Measured, core: Core) -> Self {
        let is_meant = |point: &&Point| {
            point.is_on_front && (core == Core::Host || RANGE.contains(&point.cost.middle))
        };
        let mut points: Vec<_> = scene.points.iter().filter(is_meant).collect();
        points.sort_by(|a, b| a.cost.middle.total_cmp(&b.cost.middle));
        let mut contest = Self {
            name: &scene.painter.name,
            compared: points.len(),
            same: 0,
            alone: 0,
            lost: Vec::new(),
        };
        for point in points {
            let float = scene.float.iter();
            let cheap = float.filter(|it| it.cost.middle <= point.cost.middle);
            let Some(best) = cheap.max_by(|a, b| a.psnr().total_cmp(&b.psnr())) else {
                contest.alone += 1;
                continue;
            };
            match point.psnr().total_cmp(&best.psnr()) {
                Ordering::Greater => (),
                Ordering::Equal => contest.same += 1,
                Ordering::Less => contest.lost.push(why(point, best)),
            }
        }
        contest
    }

    fn less(&self) -> usize {
        self.compared - self.same - self.alone - self.lost.len()
    }

    pub fn words(&self) -> String {
        let (name, compared, less) = (self.name, self.compared, self.less());
        if compared == 0 {
            return format!("{name}: no point of the front lies there.");
        }
        let mut words = format!("{name}: less error than float at {less} of {compared} points");
        if self.same > 0 {
            words += &format!(", the same at {}", self.same);
        }
        if self.alone > 0 {
            words += &format!(", no setting of float as cheap at {}", self.alone);
        }
        if !self.lost.is_empty() {
            words += &format!(", more at {}", self.lost.len());
        }
        words += ".";
        for why in self.lost.iter().take(MOST_LOST) {
            words += why;
        }
        words
    }
}

fn why(point: &Point, float: &Point) -> String {
    let beyond = |point: &Point| ((1.0 - point.errors.within1) * point.pixels as f64).round();
    let show = |point: &Point| format!("{}, {} dB", point.setting.words(), decibels(point.psnr()));
    format!(
        " At cost {} ({}; {}), most of the error comes from {}. {} pixels of fixed point \
         and {} of float are further than 1 from the truth.",
        cost(point),
        show(point),
        show(float),
        point.errors.parts.largest(),
        beyond(point),
        beyond(float)
    )
}
