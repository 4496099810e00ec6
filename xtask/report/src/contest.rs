//! Compares the error of fixed point with that of float at the same cost.

use std::ops::RangeInclusive;

use xtask::measure::Core;

use crate::point::Point;
use crate::scene::Measured;

/// Costs at which fixed point is compared with float, in instructions a pixel.
const RANGE: RangeInclusive<f64> = 300.0..=5000.0;

/// Comparison of the points of a scene's Pareto front with float.
pub struct Contest<'a> {
    name: &'a str,
    compared: usize,
    /// Points where each setting of float that is as cheap has more error.
    less: usize,
}

/// Returns the verdict over all scenes, in one sentence.
pub fn verdict(contests: &[Contest], core: &Core) -> String {
    let compared: usize = contests.iter().map(|it| it.compared).sum();
    let less: usize = contests.iter().map(|it| it.less).sum();
    format!(
        "For the same number of instructions, fixed point on a {} has less error than f32 on a \
         Cortex-M4F with FPU at {less} of {compared} points of the front, from {} to {} instructions a \
         pixel.",
        core.title,
        RANGE.start(),
        RANGE.end()
    )
}

impl<'a> Contest<'a> {
    pub fn new(scene: &'a Measured) -> Self {
        let is_meant = |it: &&Point| it.is_on_front && RANGE.contains(&it.cost.instructions);
        let points = || scene.points.iter().filter(is_meant);
        let is_less = |point: &&Point| {
            let float = scene.float.iter();
            let mut cheap = float.filter(|it| it.cost.instructions <= point.cost.instructions);
            // A point is not counted if no setting of float is as cheap.
            cheap.clone().next().is_some() && cheap.all(|it| it.psnr() < point.psnr())
        };
        Self {
            name: &scene.painter.name,
            compared: points().count(),
            less: points().filter(is_less).count(),
        }
    }

    pub fn words(&self) -> String {
        let (name, compared, less) = (self.name, self.compared, self.less);
        match compared {
            0 => format!("{name}: no point of the front lies there."),
            _ => format!("{name}: less error than float at {less} of {compared} points."),
        }
    }
}
