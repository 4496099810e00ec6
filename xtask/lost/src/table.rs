//! Lines and tables for people: what each scene loses, and the worst and the mean of many. Never
//! prints.

use crate::case::{Judged, Quality};
use crate::count::Counts;

/// Worst and mean of a percentage over many pictures.
#[derive(Clone, Debug)]
pub struct Summary {
    /// Largest percentage.
    pub worst: f64,
    /// Name of the picture with the largest percentage. Empty if all are 0.
    pub worst_name: String,
    /// Mean percentage, 0 of no picture.
    pub mean: f64,
}

impl Summary {
    /// Sums up a percentage of what a quality loses in each picture.
    pub fn of(judged: &[&Judged], quality: Quality, percent: fn(&Counts) -> f64) -> Self {
        let (mut worst, mut worst_name, mut sum) = (0.0, String::new(), 0.0);
        for judged in judged {
            for lost in judged.lost.iter().filter(|it| it.quality == quality) {
                let found = percent(&lost.counts);
                sum += found;
                if found > worst {
                    (worst, worst_name) = (found, judged.name.clone());
                }
            }
        }
        let mean = sum / judged.len().max(1) as f64;
        Self {
            worst,
            worst_name,
            mean,
        }
    }
}

/// Head of a table of [`row`]s.
pub const HEAD: &str =
    "          quality   n  lost: worst       mean  apart: worst      mean  worst scene";

/// Returns what a quality loses over many pictures, as a line. `title` says what the pictures are.
pub fn row(title: &str, quality: Quality, judged: &[&Judged]) -> String {
    let lost = Summary::of(judged, quality, Counts::lost);
    let apart = Summary::of(judged, quality, |it| it.percent(it.apart));
    let line = format!(
        "{title:<9} {:<5} {:>5} {:>9.3} % {:>8.4} % {:>9.3} % {:>8.4} %  {}",
        quality.name(),
        judged.len(),
        lost.worst,
        lost.mean,
        apart.worst,
        apart.mean,
        lost.worst_name,
    );
    line.trim_end().to_owned()
}

/// Head of the lines of [`lines`].
pub const LINES_HEAD: &str = "scene                      quality pixels  exact within 1 |  seen            light           apart";

/// Returns a line for each quality that loses a pixel of a picture.
pub fn lines(judged: &Judged) -> impl Iterator<Item = String> {
    let any = judged.lost.iter().filter(|it| it.is_any());
    any.map(|lost| {
        let counts = lost.counts;
        let share = |count| format!("{count:>6} {:>6.3} %", counts.percent(count));
        format!(
            "{:<26} {:<5} {:>8} {:>11.2} %  | {} {} {}",
            judged.name,
            lost.quality.name(),
            counts.pixels,
            judged.exact,
            share(counts.seen),
            share(counts.light),
            share(counts.apart),
        )
    })
}
