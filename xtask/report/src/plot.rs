//! Error against run time as SVG, in colours that everybody can tell apart (Okabe and Ito) and with a
//! shape for each, so that they need not be; it measures nothing.

use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::arguments::Core;
use crate::point::{Point, front};
use crate::scene::Measured;
use command_line::Failure;

type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

pub const BLUE: RGBColor = RGBColor(0, 114, 178);
pub const VERMILLION: RGBColor = RGBColor(213, 94, 0);
pub const GREEN: RGBColor = RGBColor(0, 158, 115);
pub const PURPLE: RGBColor = RGBColor(204, 121, 167);
const GREY: RGBColor = RGBColor(150, 150, 150);
const FONT: &str = "sans-serif";

/// Width of the plot, of the list beside it, and height of both.
const PLOT: u32 = 640;
const LIST: u32 = 300;
const HEIGHT: u32 = 440;

/// A point of the front is shown if it is better by this many decibels than the last.
pub const GAIN: f64 = 0.25;

/// What stands on the upright axis.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    Psnr,
    Largest,
}

impl Axis {
    /// Where a point stands.
    fn of(self, point: &Point) -> f64 {
        match self {
            Self::Psnr => point.errors.psnr,
            Self::Largest => f64::from(point.errors.largest).max(LEAST),
        }
    }

    /// The worst that theory allows it.
    fn bound(self, point: &Point) -> Option<f64> {
        let promised = point.errors.promised?;
        Some(match self {
            Self::Psnr => promised.bound_psnr,
            Self::Largest => promised.bound,
        })
    }
}

/// Where no difference is drawn on the logarithmic axis of differences.
const LEAST: f64 = 0.5;

/// A plot of a scene.
pub fn scene(scene: &Measured, core: Core, axis: Axis) -> Result<String, Failure> {
    let shown = front(&scene.points, GAIN);
    let mut svg = String::new();
    {
        let root = SVGBackend::with_string(&mut svg, (PLOT + LIST, HEIGHT)).into_drawing_area();
        root.fill(&WHITE)?;
        let (plot, list) = root.split_horizontally(PLOT);
        legend(&list, &shown)?;
        let name = scene.painter.name();
        match axis {
            Axis::Psnr => {
                let finite = |it: f64| it.is_finite().then_some(it);
                let all = || scene.points.iter().chain(&scene.float);
                let psnr = all().filter_map(|it| finite(it.psnr()));
                let most = psnr.clone().fold(30.0, f64::max);
                let least = psnr.fold(most, f64::min);
                // What differs nowhere is drawn as the top.
                let top = (most / 10.0).ceil() * 10.0 + 10.0;
                let range = (least / 5.0).floor() * 5.0..top + 2.0;
                let mut chart = ChartBuilder::on(&plot)
                    .caption(format!("{name}: PSNR, higher is better"), (FONT, 21))
                    .margin(8)
                    .x_label_area_size(44)
                    .y_label_area_size(56)
                    .build_cartesian_2d(costs(scene).log_scale(), range)?;
                chart
                    .configure_mesh()
                    .light_line_style(WHITE)
                    .label_style((FONT, 14))
                    .axis_desc_style((FONT, 15))
                    .x_desc(format!("{} (logarithmic)", core.unit()))
                    .y_desc("PSNR in dB")
                    .x_label_formatter(&|x| number(*x))
                    .y_label_formatter(&|y| match *y >= top - 0.1 {
                        true => "same".to_owned(),
                        false => format!("{y:.0}"),
                    })
                    .draw()?;
                series(&mut chart, scene, &shown, axis, &|y| y.min(top))?;
            }
            Axis::Largest => {
                let mut chart = ChartBuilder::on(&plot)
                    .caption(
                        format!("{name}: largest error, lower is better"),
                        (FONT, 18),
                    )
                    .margin(8)
                    .x_label_area_size(44)
                    .y_label_area_size(56)
                    .build_cartesian_2d(costs(scene).log_scale(), (0.4..400.0).log_scale())?;
                chart
                    .configure_mesh()
                    .light_line_style(WHITE)
                    .label_style((FONT, 14))
                    .axis_desc_style((FONT, 15))
                    .x_desc(format!("{} (logarithmic)", core.unit()))
                    .y_desc("largest difference of a channel, of 255")
                    .x_label_formatter(&|x| number(*x))
                    .y_label_formatter(&|y| number(*y))
                    .draw()?;
                series(&mut chart, scene, &shown, axis, &|y| y.clamp(LEAST, 255.0))?;
            }
        }
        root.present()?;
    }
    Ok(svg)
}

/// From the cheapest to the dearest of what is shown.
fn costs(scene: &Measured) -> std::ops::Range<f64> {
    let costs = || {
        scene
            .points
            .iter()
            .chain(&scene.float)
            .map(|it| it.cost.middle)
    };
    let least = costs().fold(f64::INFINITY, f64::min);
    let most = costs().fold(0.0, f64::max);
    least.max(1e-6) / 1.3..most * 1.3
}

/// Of the logarithmic axes, 1, 2 and 5 of each decade.
fn number(value: f64) -> String {
    let leading = value / f64::powf(10.0, value.log10().floor());
    let is_shown = [1.0, 2.0, 5.0, 10.0]
        .iter()
        .any(|it| (leading - it).abs() < 1e-6);
    match value {
        _ if !is_shown => String::new(),
        _ if value >= 10_000.0 => format!("{}k", value / 1000.0),
        _ if value >= 1.0 => format!("{}", (10.0 * value).round() / 10.0),
        _ => format!("{}", (1000.0 * value).round() / 1000.0),
    }
}

/// All that is drawn into a chart, whatever its axes.
fn series<'a, 'b: 'a, X, Y>(
    chart: &mut ChartContext<'a, SVGBackend<'b>, Cartesian2d<X, Y>>,
    scene: &Measured,
    shown: &[&Point],
    axis: Axis,
    within: &dyn Fn(f64) -> f64,
) -> Result<(), Failure>
where
    X: Ranged<ValueType = f64>,
    Y: Ranged<ValueType = f64>,
{
    let at = |point: &Point| (point.cost.middle, within(axis.of(point)));
    let others = scene.points.iter().filter(|it| !it.is_on_front);
    let dots = others.map(|it| Circle::new(at(it), 2, GREY.stroke_width(1)));
    chart
        .draw_series(dots)?
        .label("fixed point, other settings")
        .legend(|(x, y)| Circle::new((x + 10, y), 2, GREY.stroke_width(1)));
    let mut float: Vec<&Point> = scene.float.iter().collect();
    float.sort_by(|a, b| a.cost.middle.total_cmp(&b.cost.middle));
    let float_front: Vec<&Point> = front(&scene.float, 0.0);
    let line = stairs(&float_front, &at);
    chart.draw_series(DashedLineSeries::new(
        line,
        6,
        4,
        VERMILLION.stroke_width(2),
    ))?;
    chart
        .draw_series(
            float
                .iter()
                .map(|it| TriangleMarker::new(at(it), 5, VERMILLION.filled())),
        )?
        .label("float port")
        .legend(|(x, y)| TriangleMarker::new((x + 10, y), 5, VERMILLION.filled()));
    // The bound hangs from its point.
    let bounds = shown.iter().filter_map(|it| Some((*it, axis.bound(it)?)));
    for (point, bound) in bounds {
        let (x, y) = at(point);
        let bound = (x, within(bound));
        chart.draw_series([PathElement::new([(x, y), bound], PURPLE.stroke_width(1))])?;
        chart.draw_series([Cross::new(bound, 4, PURPLE.stroke_width(2))])?;
    }
    let example = shown.iter().find(|it| axis.bound(it).is_some());
    chart
        .draw_series(example.map(|it| {
            Cross::new(
                (it.cost.middle, within(axis.bound(it).unwrap_or(1.0))),
                4,
                PURPLE.stroke_width(2),
            )
        }))?
        .label("theory, for sure pixels")
        .legend(|(x, y)| Cross::new((x + 10, y), 4, PURPLE.stroke_width(2)));
    if axis == Axis::Largest {
        let sure = shown.iter().filter_map(|it| {
            let promised = it.errors.promised?;
            Some((it.cost.middle, within(f64::from(promised.largest))))
        });
        chart
            .draw_series(sure.map(|at| {
                EmptyElement::at(at) + Rectangle::new([(-4, -4), (4, 4)], GREEN.stroke_width(2))
            }))?
            .label("front, sure pixels")
            .legend(|(x, y)| {
                Rectangle::new([(x + 6, y - 4), (x + 14, y + 4)], GREEN.stroke_width(2))
            });
    }
    chart.draw_series(LineSeries::new(stairs(shown, &at), BLUE.stroke_width(2)))?;
    chart
        .draw_series(shown.iter().map(|it| Circle::new(at(it), 5, BLUE.filled())))?
        .label("fixed point, front")
        .legend(|(x, y)| Circle::new((x + 10, y), 5, BLUE.filled()));
    // In turn to the left and to the right, as neighbours are often near.
    let style = (FONT, 16).into_font().color(&BLACK);
    let side = |index: usize| match (index % 2, axis) {
        (0, Axis::Psnr) => (HPos::Right, VPos::Bottom, (-5, -3)),
        (0, Axis::Largest) => (HPos::Right, VPos::Top, (-5, 3)),
        (_, Axis::Psnr) => (HPos::Left, VPos::Top, (6, 3)),
        (_, Axis::Largest) => (HPos::Left, VPos::Bottom, (6, -3)),
    };
    chart.draw_series(shown.iter().enumerate().map(|(index, it)| {
        let (horizontal, vertical, aside) = side(index);
        let style = style.pos(Pos::new(horizontal, vertical));
        EmptyElement::at(at(it)) + Text::new((index + 1).to_string(), aside, style)
    }))?;
    chart
        .configure_series_labels()
        .position(match axis {
            Axis::Psnr => SeriesLabelPosition::UpperLeft,
            Axis::Largest => SeriesLabelPosition::LowerLeft,
        })
        .background_style(WHITE.mix(0.85))
        .border_style(GREY)
        .label_font((FONT, 15))
        .draw()?;
    Ok(())
}

/// A front as a line that goes on level until the next point.
fn stairs(front: &[&Point], at: &dyn Fn(&Point) -> (f64, f64)) -> Vec<(f64, f64)> {
    let mut line: Vec<(f64, f64)> = Vec::new();
    for point in front {
        let (x, y) = at(point);
        if let Some((_, level)) = line.last().copied() {
            line.push((x, level));
        }
        line.push((x, y));
    }
    line
}

/// What the numbers in the plot mean.
fn legend(list: &Area, shown: &[&Point]) -> Result<(), Failure> {
    let style = (FONT, 15).into_font().color(&BLACK);
    list.draw(&Text::new(
        "The front",
        (4, 40),
        (FONT, 15).into_font().color(&BLACK),
    ))?;
    let step = ((HEIGHT - 80) / shown.len().max(1) as u32).min(18);
    for (index, point) in shown.iter().enumerate() {
        let words = format!("{:>2}  {}", index + 1, point.words());
        list.draw(&Text::new(
            words,
            (4, 62 + (index as u32 * step) as i32),
            style.clone(),
        ))?;
    }
    Ok(())
}
