//! Plots PSNR against cost as a small SVG file: each series is one path, whatever its number of
//! points. Measures nothing.

use std::ops::Range;

use crate::point::{Point, front};
use crate::scene::Measured;

const BLUE: &str = "#0072b2";
const GREY: &str = "#999";

/// Width and height of the chart with its axes, and width of the list beside it, in pixels.
const WIDTH: i32 = 640;
const HEIGHT: i32 = 440;
const LIST: i32 = 300;

/// First and last pixel of the axes: to the right, and upwards.
const ACROSS: [i32; 2] = [64, WIDTH - 10];
const UPRIGHT: [i32; 2] = [HEIGHT - 52, 34];

/// Distance from one line of text to the next, in pixels.
const LINE: i32 = 18;

struct Axis {
    range: Range<f64>,
    is_logarithmic: bool,
    /// First and last pixel.
    pixels: [i32; 2],
    /// Values that have a grid line, and their labels.
    ticks: Vec<(f64, String)>,
}

impl Axis {
    /// Returns a logarithmic axis over all costs, with grid lines at 1, 2 and 5 of each decade.
    fn of_costs(scene: &Measured) -> Self {
        let costs = scene.points.iter().map(Point::cost);
        let least = costs.clone().fold(f64::INFINITY, f64::min);
        let range = least.max(1e-6) / 1.3..costs.fold(0.0, f64::max) * 1.3;
        let decades = range.start.log10().floor() as i32..=range.end.log10().ceil() as i32;
        let ticks = decades.flat_map(|decade| [1.0, 2.0, 5.0].map(|it| it * 10_f64.powi(decade)));
        let label = |value: f64| match value {
            10_000.0.. => format!("{}k", value / 1000.0),
            // Rounded to thousandths, without the extra digits of binary fractions.
            _ => format!("{}", (1000.0 * value).round() / 1000.0),
        };
        let ticks = ticks.filter(|it| range.contains(it));
        Self {
            ticks: ticks.map(|it| (it, label(it))).collect(),
            range,
            is_logarithmic: true,
            pixels: ACROSS,
        }
    }

    /// Returns a linear axis with a grid line every 10 dB. Pictures without any difference are at its
    /// last line.
    fn of_psnr(scene: &Measured) -> Self {
        let psnr = scene.points.iter().map(|it| it.psnr);
        let psnr = psnr.filter(|it| it.is_finite());
        let most = psnr.clone().fold(30.0, f64::max);
        let least = (psnr.fold(most, f64::min) / 5.0).floor() * 5.0;
        let top = (most / 10.0).ceil() * 10.0 + 10.0;
        let tens = ((least / 10.0).ceil() as i32..).map(|it| 10.0 * f64::from(it));
        let tens = tens.take_while(|it| *it < top);
        let ticks = tens.map(|it| (it, it.to_string()));
        Self {
            ticks: ticks.chain([(top, "same".to_owned())]).collect(),
            range: least..top + 2.0,
            is_logarithmic: false,
            pixels: UPRIGHT,
        }
    }

    /// Returns the pixel of a value. Takes values before the axis or after its last line as there.
    fn place(&self, value: f64) -> i32 {
        let scale = |it: f64| if self.is_logarithmic { it.log10() } else { it };
        let Range { start, end } = self.range;
        let last = self.ticks.last().map_or(end, |it| it.0);
        let value = if self.is_logarithmic { value } else { value.clamp(start, last) };
        let share = (scale(value) - scale(start)) / (scale(end) - scale(start));
        let [from, to] = self.pixels;
        from + (share * f64::from(to - from)).round() as i32
    }
}

pub fn scene(scene: &Measured) -> String {
    let (x, y) = (Axis::of_costs(scene), Axis::of_psnr(scene));
    let at = |point: &Point| (x.place(point.cost()), y.place(point.psnr));
    let mut svg = Svg::new();
    let title = format!("{}: PSNR, higher is better", scene.name);
    svg.axes(&title, (&x, &y));

    let shown = front(&scene.points);
    let others = scene.points.iter().filter(|it| !it.is_on_front);
    svg.marks("h0", 4, GREY, others.map(at), "other settings");
    let points = shown.iter().map(|it| at(it));
    svg.line(BLUE, stairs(points.clone()));
    svg.marks("h0", 10, BLUE, points, "the front");
    svg.numbers(&shown, at);
    svg.text.push_str("</svg>\n");
    svg.text
}

/// Returns a front as a staircase: the line stays level until the next point.
fn stairs(front: impl Iterator<Item = (i32, i32)>) -> Vec<(i32, i32)> {
    let mut line: Vec<(i32, i32)> = Vec::new();
    for (x, y) in front {
        line.extend(line.last().map(|last| (x, last.1)));
        line.push((x, y));
    }
    line
}

struct Svg {
    text: String,
    /// Number of lines in the legend.
    legend: i32,
}

impl Svg {
    fn new() -> Self {
        let width = WIDTH + LIST;
        Self {
            text: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {HEIGHT}\" \
                 width=\"{width}\" height=\"{HEIGHT}\" font-family=\"sans-serif\" font-size=\"12\" \
                 fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
                 <path fill=\"#fff\" d=\"M0 0h{width}v{HEIGHT}H0z\"/>\n"
            ),
            legend: 0,
        }
    }

    fn axes(&mut self, title: &str, (x, y): (&Axis, &Axis)) {
        let ([left, right], [bottom, top]) = (ACROSS, UPRIGHT);
        let upright = |it: &(f64, _)| format!("M{} {top}V{bottom}", x.place(it.0));
        let across = |it: &(f64, _)| format!("M{left} {}H{right}", y.place(it.0));
        let upright: String = x.ticks.iter().map(upright).collect();
        let across: String = y.ticks.iter().map(across).collect();
        self.path(&(upright + &across), "#ddd", 1);
        self.path(&format!("M{left} {top}V{bottom}H{right}"), "#000", 1);
        for (value, label) in &x.ticks {
            self.write((x.place(*value), bottom + 18), "middle", label);
        }
        for (value, label) in &y.ticks {
            self.write((left - 6, y.place(*value) + 4), "end", label);
        }
        let (middle, height) = ((left + right) / 2, (top + bottom) / 2);
        self.write((middle, 20), "middle\" font-size=\"17", title);
        let unit = "instructions a pixel (logarithmic)";
        self.write((middle, HEIGHT - 12), "middle", unit);
        let turned = format!("middle\" transform=\"rotate(-90 14 {height})");
        self.write((14, height), &turned, "PSNR in dB");
    }

    /// Marks points by an SVG path relative to each. Points on the same pixel are marked once.
    fn marks(
        &mut self,
        mark: &str,
        width: u8,
        color: &str,
        points: impl Iterator<Item = (i32, i32)>,
        legend: &str,
    ) {
        let mut places: Vec<_> = points.collect();
        places.sort_unstable();
        places.dedup();
        let y = UPRIGHT[1] + self.legend * LINE;
        self.legend += 1;
        self.write((WIDTH + 28, y + 4), "start", legend);
        places.push((WIDTH + 12, y));
        let paths = places.iter().map(|(x, y)| format!("M{x} {y}{mark}"));
        self.path(&paths.collect::<String>(), color, width);
    }

    fn line(&mut self, color: &str, mut places: Vec<(i32, i32)>) {
        places.dedup();
        let places = places.iter().map(|(x, y)| format!("{x} {y}"));
        let path = format!("M{}", places.collect::<Vec<_>>().join("L"));
        if path.len() > 1 {
            self.path(&path, color, 2);
        }
    }

    /// Numbers the points of the front and lists their settings. The numbers stand left and right in
    /// turns, because neighbours are often close to each other.
    fn numbers(&mut self, shown: &[&Point], at: impl Fn(&Point) -> (i32, i32)) {
        for (index, point) in shown.iter().enumerate() {
            let ((x, y), number) = (at(point), (index + 1).to_string());
            match index % 2 {
                1 => self.write((x + 7, y + 13), "start", &number),
                _ => self.write((x - 6, y - 5), "end", &number),
            }
        }
        let top = UPRIGHT[1] + self.legend * LINE + 24;
        let step = ((HEIGHT - top) / (shown.len() as i32 + 1)).min(LINE);
        self.write((WIDTH + 4, top), "start", "The front:");
        for (number, point) in (1..).zip(shown) {
            let words = format!("{number}: {}", point.setting.words());
            self.write((WIDTH + 4, top + number * step), "start", &words);
        }
    }

    fn path(&mut self, path: &str, color: &str, width: u8) {
        self.text += &format!("<path stroke=\"{color}\" stroke-width=\"{width}\" d=\"{path}\"/>\n");
    }

    fn write(&mut self, (x, y): (i32, i32), anchor: &str, words: &str) {
        let words = words.replace('&', "&amp;").replace('<', "&lt;");
        let anchor = match anchor {
            "start" => String::new(),
            _ => format!(" text-anchor=\"{anchor}\""),
        };
        self.text += &format!("<text fill=\"#000\" x=\"{x}\" y=\"{y}\"{anchor}>{words}</text>\n");
    }
}
