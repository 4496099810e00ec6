//! Plots PSNR against cost as an SVG file. Measures nothing.

use anyhow::Result;
use plotters::coord::Shift;
use plotters::prelude::*;

use crate::point::{Point, front};
use crate::scene::Measured;

const BLUE: RGBColor = RGBColor(0x00, 0x72, 0xb2);
const GREY: RGBColor = RGBColor(0x99, 0x99, 0x99);
const FONT: (&str, u32) = ("sans-serif", 14);
const TITLE: (&str, u32) = ("sans-serif", 20);

/// Width and height of the chart with its axes, and width of the list beside it, in pixels.
const WIDTH: u32 = 640;
const HEIGHT: u32 = 440;
const LIST: u32 = 300;

/// Distance from one line of the list to the next, in pixels.
const LINE: usize = 18;

/// What is drawn on, with coordinates in pixels.
type Sheet<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// Returns the text of the file.
pub fn scene(scene: &Measured) -> Result<String> {
    let mut svg = String::new();
    draw(
        scene,
        &SVGBackend::with_string(&mut svg, (WIDTH + LIST, HEIGHT)).into_drawing_area(),
    )?;
    Ok(svg)
}

fn draw(scene: &Measured, sheet: &Sheet<'_>) -> Result<()> {
    sheet.fill(&WHITE)?;
    let (chart, list) = sheet.split_horizontally(WIDTH);
    let shown = front(&scene.points);
    draw_chart(scene, &shown, &chart)?;
    let step = ((HEIGHT as usize - 60) / (shown.len() + 1)).min(LINE);
    let points = (1..).zip(&shown);
    let words = points.map(|(number, it)| format!("{number}: {}", it.setting.words()));
    for (line, words) in ["Blue: the front. Grey: other settings.".to_owned()]
        .into_iter()
        .chain(words)
        .enumerate()
    {
        list.draw(&Text::new(words, (4, (40 + line * step) as i32), FONT))?;
    }
    Ok(sheet.present()?)
}

fn draw_chart(scene: &Measured, shown: &[&Point], sheet: &Sheet<'_>) -> Result<()> {
    let costs = || scene.points.iter().map(Point::cost);
    let [least, most] = [
        costs().fold(f64::INFINITY, f64::min),
        costs().fold(0.0, f64::max),
    ];
    let across = (least.max(1e-6) / 1.3..most * 1.3).log_scale();
    let psnr = scene
        .points
        .iter()
        .map(|it| it.psnr)
        .filter(|it| it.is_finite());
    let most = psnr.clone().fold(30.0, f64::max);
    let least = (psnr.fold(most, f64::min) / 5.0).floor() * 5.0;
    // Pictures without any difference are at the last line.
    let same = (most / 10.0).ceil() * 10.0 + 10.0;
    let at = |point: &Point| (point.cost(), point.psnr.min(same));

    let mut chart = ChartBuilder::on(sheet)
        .caption(format!("{}: PSNR, higher is better", scene.name), TITLE)
        .margin(10)
        .x_label_area_size(40)
        .y_label_area_size(50)
        .build_cartesian_2d(across, least..same + 2.0)?;
    let label = |it: &f64| if *it < same { it.to_string() } else { "same".to_owned() };
    chart
        .configure_mesh()
        .y_max_light_lines(1)
        .x_labels(6)
        .x_label_formatter(&f64::to_string)
        .y_labels(((same - least) / 10.0) as usize + 1)
        .y_label_formatter(&label)
        .x_desc("instructions a pixel (logarithmic)")
        .y_desc("PSNR in dB")
        .label_style(FONT)
        .draw()?;
    let others = scene.points.iter().filter(|it| !it.is_on_front);
    chart.draw_series(others.map(|it| Circle::new(at(it), 2, GREY.filled())))?;
    let stairs = stairs(shown.iter().map(|it| at(it)));
    chart.draw_series(LineSeries::new(stairs, BLUE.stroke_width(2)))?;
    let numbered = (1..).zip(shown).map(|(number, point)| {
        // Left and right in turns, because neighbours are often close to each other.
        let place = if number % 2 == 0 { (7, 2) } else { (-14, -16) };
        let mark = Circle::new((0, 0), 5, BLUE.filled());
        EmptyElement::at(at(point)) + mark + Text::new(format!("{number}"), place, FONT)
    });
    chart.draw_series(numbered)?;
    Ok(())
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
