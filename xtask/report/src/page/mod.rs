//! The index page: what it says; [`markdown`] and [`html`] say it.

pub mod html;
pub mod markdown;

use std::cmp::Ordering;

use crate::arguments::{Arguments, Core};
use crate::point::Point;
use crate::scene::Measured;

/// All of a report.
pub struct Page<'a> {
    pub arguments: &'a Arguments,
    pub size: String,
    pub sections: Vec<Section<'a>>,
    /// The plot of the room of mirrors, and the furthest that any level is from the formula.
    pub room: String,
    pub furthest: f64,
}

/// A scene.
pub struct Section<'a> {
    pub scene: &'a Measured,
    /// What its files are called.
    pub file: String,
    pub front: Vec<&'a Point>,
    pub samples: Vec<Sample>,
    pub psnr: String,
    pub largest: String,
}

/// A picture at a point of the front, and its difference.
pub struct Sample {
    /// Of the point.
    pub number: usize,
    pub files: [String; 2],
    pub pictures: [Vec<u8>; 2],
}

/// The heads of a scene's table.
pub const HEADS: [&str; 14] = [
    "",
    "setting",
    "cost",
    "PSNR",
    "largest",
    "sure %",
    "sure",
    "bound",
    "truncation",
    "cut-off",
    "between",
    "rounding",
    "decided",
    "simplified",
];

impl Page<'_> {
    /// How it was made, in sentences.
    pub fn introduction(&self) -> Vec<String> {
        let (size, core) = (&self.size, self.arguments.core);
        let how = match core {
            Core::Host => {
                "The cost is the time on one thread of this machine, in percent of the time \
                           that the double-precision reference takes with as many reflections: the \
                           median of nine rounds in which all settings take turns; points.csv has \
                           the quartiles."
                    .to_owned()
            }
            _ => format!(
                "The cost is what a {} executes for a picture of {size} with its preparation, in \
                 instructions a pixel, counted by an emulator; that of the float port is counted on a \
                 Cortex-M4F, which has hardware for it. An instruction is not a cycle.",
                core.title()
            ),
        };
        vec![
            format!(
                "What each setting costs and what it loses, at {size}: the number of reflections N, \
                 the weight cut-off, the quality, shadows, larger pixels; and the same model in f32 \
                 without this crate (xtask/float_port) as the competitor."
            ),
            how,
            "The error is that of the 8-bit picture against a double-precision picture that follows \
             every reflection (N → ∞): the peak signal-to-noise ratio over all channels in decibels, \
             and the largest difference of a channel, of 255."
                .to_owned(),
            "Fast, fine and exact are the library's qualities, of which exact traces every pixel and cuts \
             nothing off, and \"cut at\" and \"x tolerance\" are fast with another smallest weight or \
             tolerance, each a Quality of one's own. Without shadows is the shading \
             Unshadowed, and larger pixels are drawn on an Enlarged display."
                .to_owned(),
            "The front is what pays: whoever wants less error has to spend more. Its points are \
             numbered, the same in plots and tables; those that gain less than a quarter of a decibel \
             are left out. points.csv has all that was measured, front.rs the points that the \
             library's Front takes as a constant."
                .to_owned(),
        ]
    }

    /// What theory says, in sentences.
    pub fn theory(&self) -> Vec<String> {
        vec![
            "What is left out after the last reflection, or where the weight falls below the cut-off, \
             is at most Π αₖ · max |c|: the weight of the path there, times the brightest colour a \
             surface can have."
                .to_owned(),
            "What rounding does is bounded by a running error analysis along each path: steps of the \
             scene's grid, directions and weights in Q2.30, roots of 27 and reciprocals of 26 bits, \
             colours in Q6.26 of which a product keeps 20 bits behind the point, the sum in Q8.24. \
             What pixels between traced ones add is what the curves of the quality make of exact \
             colours. The documentation of reflet::host::reference::bound has the derivation."
                .to_owned(),
            "Nothing is promised of a pixel whose path a ray a 32nd of a pixel beside it, or one of \
             the pixels it is taken from, decides otherwise: meets another shape, or is lit by another \
             light. All others are sure, and keep the bound. One of the former that is further than 1 \
             from what its reflections come to counts as decided otherwise."
                .to_owned(),
        ]
    }

    /// How the bounds were kept.
    pub fn verdict(&self) -> String {
        let promises = self
            .sections
            .iter()
            .flat_map(|section| &section.scene.points);
        let promises: Vec<_> = promises.filter_map(|point| point.errors.promised).collect();
        let broken: usize = promises.iter().map(|it| it.broken).sum();
        format!(
            "Of the {} pictures here with shadows and at full resolution, sure pixels beyond their \
             bound: {broken}.",
            promises.len()
        )
    }

    /// What the columns of the tables are.
    pub fn columns(&self) -> String {
        format!(
            "In the tables cost is in {}, PSNR in dB, and all others in 255ths but the percentage of \
             the pixels that are sure: the largest difference of all pixels, of those that are sure, and \
             what theory allows these; then, each alone, the \
             root of the mean square of what is due to truncation (reflections left out), to the weight \
             cut-off, to pixels between traced ones, to rounding, to pixels decided otherwise (with \
             their number), and to what is simplified (no shadows, larger pixels).",
            self.arguments.core.unit()
        )
    }

    /// How the room of mirrors was met.
    pub fn room_words(&self) -> String {
        format!(
            "A room of six mirrors that glow with c = 1, in which every path goes on for ever: after N \
             reflections it shows c (1 − α^(N+1)). Of N = 0 to 255, no level is further from that than \
             {:.2} of 255.",
            self.furthest
        )
    }

    /// Fixed point against float at the same count, scene by scene.
    pub fn contest(&self) -> Vec<String> {
        let sentences = self.sections.iter().map(|section| {
            let Contest {
                compared,
                same,
                alone,
                lost,
            } = section.contest(self.arguments.core);
            let name = section.scene.painter.name();
            if compared == 0 {
                return format!("{name}: no point of the front lies there.");
            }
            let less = compared - same - alone - lost.len();
            let mut words = format!("{name}: less error than float at {less} of {compared} points");
            if same > 0 {
                words += &format!(", the same at {same}");
            }
            if alone > 0 {
                words += &format!(", no setting of float as cheap at {alone}");
            }
            if lost.is_empty() {
                return words + ".";
            }
            let shown = lost.len().min(MOST_LOST);
            words += &format!(", more at {}: {}", lost.len(), lost[..shown].join("; "));
            match lost.len() - shown {
                0 => words + ".",
                more => format!("{words}; and {more} more."),
            }
        });
        sentences.collect()
    }

    /// The range that is compared, in words.
    pub fn contest_head(&self) -> String {
        match self.arguments.core {
            Core::Host => {
                "At every point of the front, fixed point against the best that the float \
                           port does in the same time, both on this machine."
                    .to_owned()
            }
            core => format!(
                "At every point of the front from {} to {} instructions a pixel, fixed point on the {} \
                 against the best that the float port does for the same count or less on a Cortex-M4F.",
                RANGE.start,
                RANGE.end,
                core.title()
            ),
        }
    }
}

/// Where fixed point has to stand against float, in instructions a pixel.
const RANGE: std::ops::Range<f64> = 300.0..5000.0;

/// So many of the points at which float has less error are explained.
const MOST_LOST: usize = 4;

/// Of the points that are compared; float has more error at all that are not named here.
struct Contest {
    compared: usize,
    /// With as much error as float.
    same: usize,
    /// With no float as cheap.
    alone: usize,
    lost: Vec<String>,
}

impl Section<'_> {
    fn contest(&self, core: Core) -> Contest {
        let is_meant = |cost: f64| core == Core::Host || (RANGE.start..=RANGE.end).contains(&cost);
        let points = self.scene.points.iter().filter(|it| it.is_on_front);
        let mut points: Vec<_> = points.filter(|it| is_meant(it.cost.middle)).collect();
        points.sort_by(|a, b| a.cost.middle.total_cmp(&b.cost.middle));
        let (mut same, mut alone, mut lost) = (0, 0, Vec::new());
        for point in &points {
            let Some(best) = self.float_within(point.cost.middle) else {
                alone += 1;
                continue;
            };
            match point.psnr().total_cmp(&best.psnr()) {
                Ordering::Greater => (),
                Ordering::Equal => same += 1,
                Ordering::Less => lost.push(format!(
                    "{} ({}, {} dB; {}, {} dB): {}",
                    cost(point),
                    point.words(),
                    decibels(point.psnr()),
                    best.words(),
                    decibels(best.psnr()),
                    self.why(point, best),
                )),
            }
        }
        Contest {
            compared: points.len(),
            same,
            alone,
            lost,
        }
    }

    /// Why float has less error.
    fn why(&self, point: &Point, float: &Point) -> String {
        let pixels = self.scene.truth.picture.pixels.len() as f64;
        let count = |share: f64| ((1.0 - share) * pixels).round();
        let beyond = |point: &Point| count(point.errors.within1);
        let parts = &point.errors.parts;
        match (beyond(point), beyond(float)) {
            (0.0, 0.0) if parts.is_rounding() => format!(
                "no pixel of either is further than 1 from the truth; {} of fixed point's and {} of \
                 float's lie so near to half way between two levels that they are rounded the other way, \
                 as a product of colours keeps 20 bits and f32 24",
                count(point.errors.same),
                count(float.errors.same)
            ),
            (own, other) => format!(
                "most of it is due to {}; {own} pixels of fixed point's and {other} of float's are further \
                 than 1 from the truth",
                parts.largest()
            ),
        }
    }

    fn float_within(&self, cost: f64) -> Option<&Point> {
        let cheap = self.scene.float.iter().filter(|it| it.cost.middle <= cost);
        cheap.max_by(|a, b| a.psnr().total_cmp(&b.psnr()))
    }

    /// What to use for a budget, for each budget that changes it.
    pub fn recommendations(&self, core: Core) -> Vec<String> {
        let budgets: &[f64] = match core {
            Core::Host => &[1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0],
            Core::M0 => &[300.0, 1000.0, 2000.0, 3000.0, 5000.0, 10_000.0, 20_000.0],
            _ => &[
                100.0, 200.0, 300.0, 500.0, 700.0, 1000.0, 1500.0, 2000.0, 3000.0, 5000.0,
            ],
        };
        let mut lines = Vec::new();
        let mut last = None;
        for budget in budgets {
            let fits = |it: &(usize, &&Point)| it.1.cost.middle <= *budget;
            let best = self.front.iter().enumerate().rfind(fits);
            let Some((index, point)) = best.filter(|it| last != Some(it.0)) else {
                continue;
            };
            last = Some(index);
            lines.push(format!(
                "For {budget} {} use {} ({}: {}, {} dB, largest {}).",
                core.unit(),
                point.words(),
                index + 1,
                cost(point),
                decibels(point.psnr()),
                point.errors.largest
            ));
        }
        lines
    }

    /// The rows of its table.
    pub fn rows(&self) -> Vec<[String; 14]> {
        let float = front_of_float(&self.scene.float);
        let soft = self.scene.soft.iter();
        let all = self.front.iter().copied().chain(float).chain(soft);
        all.enumerate()
            .map(|(index, point)| self.row(index, point))
            .collect()
    }

    fn row(&self, index: usize, point: &Point) -> [String; 14] {
        let (errors, parts) = (&point.errors, &point.errors.parts);
        let number = match index < self.front.len() {
            true => (index + 1).to_string(),
            false => String::new(),
        };
        let words = match point.setting.is_float() {
            true => format!("{} on {}", point.words(), point.core),
            false => point.words(),
        };
        let of_promise = |show: fn(&crate::error::Promised) -> String| {
            errors
                .promised
                .as_ref()
                .map_or_else(|| "–".to_owned(), show)
        };
        let part = |value: f64| match point.setting.is_float() {
            true => "–".to_owned(),
            false => format!("{value:.2}"),
        };
        let decided = of_promise(|it| format!(" ({})", it.decided));
        [
            number,
            words,
            cost(point),
            decibels(point.psnr()),
            errors.largest.to_string(),
            of_promise(|it| percent(it.sure)),
            of_promise(|it| it.largest.to_string()),
            of_promise(|it| format!("{:.1}", it.bound)),
            format!("{:.2}", parts.truncation),
            part(parts.cut_off),
            part(parts.between),
            part(parts.rounding),
            part(parts.decided) + if decided == "–" { "" } else { &decided },
            part(parts.simplified),
        ]
    }
}

fn front_of_float(points: &[Point]) -> Vec<&Point> {
    crate::point::front(points, crate::plot::GAIN)
}

fn cost(point: &Point) -> String {
    match point.cost.quartiles {
        Some((lower, upper)) => format!("{:.2} ({lower:.2} to {upper:.2})", point.cost.middle),
        None => format!("{:.0}", point.cost.middle),
    }
}

/// Rounded down, so that 100 are all.
fn percent(share: f64) -> String {
    format!("{:.1}", (1000.0 * share).floor() / 10.0)
}

/// In decibels, or that there is nothing to be measured.
fn decibels(psnr: f64) -> String {
    match psnr.is_finite() {
        true => format!("{psnr:.1}"),
        false => "∞".to_owned(),
    }
}
