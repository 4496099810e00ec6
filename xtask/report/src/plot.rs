//! Plots error against cost. Every series has a colour that colour-blind people can tell apart, and
//! also its own shape, so that the plot works without colours. Measures nothing.

use std::ops::Range;

use crate::arguments::Core;
use crate::point::{GAIN, Point, front};
use crate::scene::Measured;
use crate::svg::{self, Axis, Chart};

#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Upright {
    Psnr,
    Largest,
}

impl Upright {
    fn of(self, point: &Point) -> f64 {
        match self {
            Self::Psnr => point.psnr(),
            Self::Largest => point.errors.largest.into(),
        }
    }

    /// Returns the bound of this error for a point, if one is promised.
    fn bound(self, point: &Point) -> Option<f64> {
        let promised = point.errors.promised?;
        Some(match self {
            Self::Psnr => promised.bound_psnr,
            Self::Largest => promised.bound,
        })
    }

    fn title(self) -> &'static str {
        match self {
            Self::Psnr => "PSNR, higher is better",
            Self::Largest => "largest error, lower is better",
        }
    }

    /// Returns the vertical axis, and the range to which the points' values are clamped.
    fn axis(self, scene: &Measured) -> (Axis, Range<f64>) {
        if self == Self::Largest {
            let title = "largest difference of a channel, of 255";
            // A difference of 0 is drawn at one half, because the axis is logarithmic.
            return (Axis::logarithmic(title, 0.4..400.0), 0.5..255.0);
        }
        let all = scene.points.iter().chain(&scene.float);
        let psnr = all.map(Point::psnr).filter(|it| it.is_finite());
        let most = psnr.clone().fold(30.0, f64::max);
        let least = (psnr.fold(most, f64::min) / 5.0).floor() * 5.0;
        // Pictures without any difference are drawn at the top.
        let top = (most / 10.0).ceil() * 10.0 + 10.0;
        let mut axis = Axis::linear("PSNR in dB", least..top, 10.0);
        axis.ticks.push((top, "same".to_owned()));
        axis.range.end = top + 2.0;
        (axis, least..top)
    }
}

pub fn scene(scene: &Measured, core: Core, upright: Upright) -> String {
    let shown = front(&scene.points, GAIN);
    let float_front = front(&scene.float, 0.0);
    let (axis, range) = upright.axis(scene);
    let within = |it: f64| it.clamp(range.start, range.end);
    let at = |point: &Point| (point.cost.middle, within(upright.of(point)));
    let title = format!("{}: {}", scene.painter.name, upright.title());
    let costs = Axis::logarithmic(core.unit(), costs(scene));
    let mut chart = Chart::new(&title, costs, axis);

    let others = scene.points.iter().filter(|it| !it.is_on_front);
    chart.marks(
        svg::SMALL_DOT,
        svg::GREY,
        others.map(at),
        "fixed point, other settings",
    );
    let line = stairs(float_front.iter().map(|it| at(it)));
    chart.line(svg::VERMILLION, true, line);
    let float = scene.float.iter().map(at);
    chart.marks(svg::TRIANGLE, svg::VERMILLION, float, "float port");
    let bounds = shown.iter().filter_map(|it| {
        let point = at(it);
        Some([point, (point.0, within(upright.bound(it)?))])
    });
    let bounds: Vec<_> = bounds.collect();
    for bound in &bounds {
        chart.line(svg::PURPLE, false, *bound);
    }
    let bounds = bounds.iter().map(|it| it[1]);
    chart.marks(svg::CROSS, svg::PURPLE, bounds, "theory, for sure pixels");
    if upright == Upright::Largest {
        let sure = shown.iter().filter_map(|it| {
            let largest = it.errors.promised?.largest;
            Some((it.cost.middle, within(largest.into())))
        });
        chart.marks(svg::SQUARE, svg::GREEN, sure, "front, sure pixels");
    }
    chart.line(svg::BLUE, false, stairs(shown.iter().map(|it| at(it))));
    let points = shown.iter().map(|it| at(it));
    chart.marks(svg::DOT, svg::BLUE, points, "fixed point, front");
    for (index, point) in shown.iter().enumerate() {
        // The labels alternate between left and right, because neighbours are often close to each
        // other.
        let is_right = index % 2 == 1;
        let is_below = is_right == (upright == Upright::Psnr);
        chart.label(at(point), is_right, is_below, &(index + 1).to_string());
    }
    let words = (1..).zip(&shown);
    let words = words.map(|(number, it)| format!("{number}: {}", it.setting.words()));
    let list: Vec<String> = ["The front:".to_owned()].into_iter().chain(words).collect();
    chart.finish(&list)
}

/// Returns the range of the cost axis: from the cheapest to the most expensive point, with a margin.
fn costs(scene: &Measured) -> Range<f64> {
    let costs = scene.points.iter().chain(&scene.float);
    let costs = costs.map(|it| it.cost.middle);
    let least = costs.clone().fold(f64::INFINITY, f64::min);
    let most = costs.fold(0.0, f64::max);
    least.max(1e-6) / 1.3..most * 1.3
}

/// Returns a front as a staircase: the line stays level until the next point.
fn stairs(front: impl Iterator<Item = (f64, f64)>) -> Vec<(f64, f64)> {
    let mut line: Vec<(f64, f64)> = Vec::new();
    for (x, y) in front {
        line.extend(line.last().map(|last| (x, last.1)));
        line.push((x, y));
    }
    line
}
