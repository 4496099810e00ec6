//! Lines and tables for people: what each scene loses, and the worst and the mean of many. Never
//! prints.

use command_line::Quality;

use crate::case::Judged;

/// Worst and mean of the percentage of lost pixels over many pictures.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// Largest percentage.
    pub worst: f64,
    /// Name of the picture with the largest percentage. Empty if all are 0.
    pub worst_name: String,
    /// Mean percentage, 0 of no picture.
    pub mean: f64,
}

impl Summary {
    /// Sums up what a quality loses in each picture.
    pub fn of(judged: &[&Judged], quality: Quality) -> Self {
        let mut summary = Self::default();
        for judged in judged {
            for lost in judged.lost.iter().filter(|it| it.quality == quality) {
                let percent = lost.percent();
                summary.mean += percent;
                if percent > summary.worst {
                    (summary.worst, summary.worst_name) = (percent, judged.name.clone());
                }
            }
        }
        summary.mean /= judged.len().max(1) as f64;
        summary
    }
}

/// Head of a table of [`row`]s.
pub const HEAD: &str = "          quality   n  lost: worst       mean  worst scene";

/// Returns what a quality loses over many pictures, as a line. `title` says what the pictures are.
pub fn row(title: &str, quality: Quality, judged: &[&Judged]) -> String {
    let lost = Summary::of(judged, quality);
    let line = format!(
        "{title:<9} {:<5} {:>5} {:>9.3} % {:>8.4} %  {}",
        quality.name(),
        judged.len(),
        lost.worst,
        lost.mean,
        lost.worst_name,
    );
    line.trim_end().to_owned()
}

/// Head of the lines of [`lines`].
pub const LINES_HEAD: &str = "scene                      quality pixels  exact within 1 |  lost";

/// Returns a line for each quality that loses a pixel of a picture.
pub fn lines(judged: &Judged) -> impl Iterator<Item = String> {
    let any = judged.lost.iter().filter(|it| it.count() > 0);
    any.map(|lost| {
        format!(
            "{:<26} {:<5} {:>8} {:>11.2} %  | {:>6} {:>6.3} %",
            judged.name,
            lost.quality.name(),
            lost.is_lost.len(),
            judged.exact,
            lost.count(),
            lost.percent(),
        )
    })
}
