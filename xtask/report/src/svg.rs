//! Draws a chart as a small SVG file: each series is one path, whatever its number of points. This
//! module does not know what the chart shows.

use std::ops::Range;

/// Blue of a series. These colours can be told apart by colour-blind people (Okabe and Ito).
pub const BLUE: &str = "#0072b2";
pub const VERMILLION: &str = "#d55e00";
pub const GREEN: &str = "#009e73";
pub const PURPLE: &str = "#cc79a7";
pub const GREY: &str = "#999";

/// Height of a chart in pixels. `WIDTH` is the width of its plot, `LIST` that of the list beside it.
const HEIGHT: i32 = 440;
const WIDTH: i32 = 640;
const LIST: i32 = 300;

/// Left edge of the plot without axes and title, in pixels. `RIGHT`, `TOP` and `BOTTOM` are the
/// other edges.
const LEFT: i32 = 64;
const RIGHT: i32 = WIDTH - 10;
const TOP: i32 = 34;
const BOTTOM: i32 = HEIGHT - 52;

/// Distance from one line of text to the next, in pixels.
const LINE: i32 = 18;

/// An axis: its title, its range, and the values that have a grid line and a label.
pub struct Axis {
    pub title: String,
    pub range: Range<f64>,
    pub ticks: Vec<(f64, String)>,
    pub is_logarithmic: bool,
}

impl Axis {
    /// Returns a logarithmic axis with grid lines at 1, 2 and 5 of each decade.
    pub fn logarithmic(title: &str, range: Range<f64>) -> Self {
        let decades = range.start.log10().floor() as i32..=range.end.log10().ceil() as i32;
        let ticks = decades.flat_map(|decade| [1.0, 2.0, 5.0].map(|it| it * 10_f64.powi(decade)));
        let label = |value: f64| match value {
            10_000.0.. => format!("{}k", value / 1000.0),
            // Rounded to thousandths, without the extra digits of binary fractions.
            _ => format!("{}", (1000.0 * value).round() / 1000.0),
        };
        Self {
            title: format!("{title} (logarithmic)"),
            ticks: ticks
                .filter(|it| range.contains(it))
                .map(|it| (it, label(it)))
                .collect(),
            range,
            is_logarithmic: true,
        }
    }

    /// Returns an axis with a grid line at each multiple of `step`.
    pub fn linear(title: &str, range: Range<f64>, step: f64) -> Self {
        let first = (range.start / step).ceil() as i32;
        let ticks = (first..).map(|it| f64::from(it) * step);
        let ticks = ticks.take_while(|it| *it < range.end);
        Self {
            title: title.to_owned(),
            ticks: ticks.map(|it| (it, format!("{it}"))).collect(),
            range,
            is_logarithmic: false,
        }
    }

    /// Returns the pixel of a value on an axis that runs from pixel `from` to pixel `to`.
    fn place(&self, value: f64, from: i32, to: i32) -> i32 {
        let scale = |it: f64| if self.is_logarithmic { it.log10() } else { it };
        let Range { start, end } = self.range;
        let share = (scale(value) - scale(start)) / (scale(end) - scale(start));
        from + (share * f64::from(to - from)).round() as i32
    }
}

/// How a point is marked: an SVG path relative to the point, and the width of its stroke.
pub struct Mark(&'static str, u8);

pub const DOT: Mark = Mark("h0", 10);
pub const SMALL_DOT: Mark = Mark("h0", 4);
pub const TRIANGLE: Mark = Mark("m0-2l2 4h-4z", 5);
pub const OPEN_TRIANGLE: Mark = Mark("m0-5l5 9h-10z", 2);
pub const CROSS: Mark = Mark("m-4-4l8 8m0-8l-8 8", 2);
pub const SQUARE: Mark = Mark("m-4-4h8v8h-8z", 2);
pub const DIAMOND: Mark = Mark("m0-6l6 6l-6 6l-6-6z", 2);

pub struct Chart {
    x: Axis,
    y: Axis,
    svg: String,
    legend: i32,
}

impl Chart {
    pub fn new(title: &str, x: Axis, y: Axis) -> Self {
        let width = WIDTH + LIST;
        let mut chart = Self {
            svg: format!(
                "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {HEIGHT}\" \
                 width=\"{width}\" height=\"{HEIGHT}\" font-family=\"sans-serif\" font-size=\"12\" \
                 fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\">\n\
                 <path fill=\"#fff\" d=\"M0 0h{width}v{HEIGHT}H0z\"/>\n"
            ),
            legend: 0,
            x,
            y,
        };
        chart.axes(title);
        chart
    }

    fn axes(&mut self, title: &str) {
        let middle = (LEFT + RIGHT) / 2;
        let (mut grid, mut labels) = (String::new(), Vec::new());
        for (value, label) in &self.x.ticks {
            let x = self.x.place(*value, LEFT, RIGHT);
            grid += &format!("M{x} {TOP}V{BOTTOM}");
            labels.push(((x, BOTTOM + 18), "middle", label.clone()));
        }
        for (value, label) in &self.y.ticks {
            let y = self.y.place(*value, BOTTOM, TOP);
            grid += &format!("M{LEFT} {y}H{RIGHT}");
            labels.push(((LEFT - 6, y + 4), "end", label.clone()));
        }
        self.path(&grid, "#ddd", 1, "");
        self.path(&format!("M{LEFT} {TOP}V{BOTTOM}H{RIGHT}"), "#000", 1, "");
        for (at, anchor, label) in labels {
            self.text(at, anchor, &label);
        }
        let (x, y) = (self.x.title.clone(), self.y.title.clone());
        self.text((middle, 20), "middle\" font-size=\"17", title);
        self.text((middle, HEIGHT - 12), "middle", &x);
        let height = (TOP + BOTTOM) / 2;
        let turned = format!("middle\" transform=\"rotate(-90 14 {height})");
        self.text((14, height), &turned, &y);
    }

    /// Marks points in one colour. Points on the same pixel are marked once. `label` is the text in
    /// the legend.
    pub fn marks(
        &mut self,
        mark: Mark,
        color: &str,
        points: impl IntoIterator<Item = (f64, f64)>,
        label: &str,
    ) {
        let mut places: Vec<_> = points.into_iter().map(|it| self.at(it)).collect();
        places.sort_unstable();
        places.dedup();
        let y = TOP + self.legend * LINE;
        self.legend += 1;
        self.text((WIDTH + 28, y + 4), "start", label);
        places.push((WIDTH + 12, y));
        let paths = places.iter().map(|(x, y)| format!("M{x} {y}{}", mark.0));
        self.path(&paths.collect::<String>(), color, mark.1, "");
    }

    pub fn line<P>(&mut self, color: &str, is_dashed: bool, points: P)
    where
        P: IntoIterator<Item = (f64, f64)>,
    {
        let mut places: Vec<_> = points.into_iter().map(|it| self.at(it)).collect();
        places.dedup();
        let places = places.iter().map(|(x, y)| format!("{x} {y}"));
        let path = format!("M{}", places.collect::<Vec<_>>().join("L"));
        let dashes = ["", " stroke-dasharray=\"6 5\""][usize::from(is_dashed)];
        if path.len() > 1 {
            self.path(&path, color, 2, dashes);
        }
    }

    /// Writes text to the left or right of a point, above or below it.
    pub fn label(&mut self, point: (f64, f64), is_right: bool, is_below: bool, words: &str) {
        let (x, y) = self.at(point);
        let (right, anchor) = [(-6, "end"), (7, "start")][usize::from(is_right)];
        let down = [-5, 13][usize::from(is_below)];
        self.text((x + right, y + down), anchor, words);
    }

    pub fn finish(mut self, lines: &[String]) -> String {
        let top = TOP + self.legend * LINE + 24;
        let step = ((HEIGHT - top) / lines.len().max(1) as i32).min(LINE);
        for (index, line) in (0..).zip(lines) {
            self.text((WIDTH + 4, top + index * step), "start", line);
        }
        self.svg + "</svg>\n"
    }

    fn at(&self, (x, y): (f64, f64)) -> (i32, i32) {
        (self.x.place(x, LEFT, RIGHT), self.y.place(y, BOTTOM, TOP))
    }

    fn path(&mut self, path: &str, color: &str, width: u8, more: &str) {
        if !path.is_empty() {
            self.svg += &format!(
                "<path stroke=\"{color}\" stroke-width=\"{width}\"{more} d=\"{path}\"/>\n"
            );
        }
    }

    fn text(&mut self, (x, y): (i32, i32), anchor: &str, words: &str) {
        let words = words.replace('&', "&amp;").replace('<', "&lt;");
        let anchor = match anchor {
            "start" => String::new(),
            _ => format!(" text-anchor=\"{anchor}\""),
        };
        self.svg += &format!("<text fill=\"#000\" x=\"{x}\" y=\"{y}\"{anchor}>{words}</text>\n");
    }
}
