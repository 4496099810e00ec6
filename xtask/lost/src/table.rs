//! Lines and tables for people: what each scene loses, and the worst and the mean of many. Never
//! prints.

use crate::case::{Judged, Quality};
use crate::families::Family;

/// Worst and mean of a percentage over many pictures.
#[derive(Clone, Debug, Default)]
pub struct Summary {
    /// Number of pictures.
    pub count: usize,
    /// Largest percentage.
    pub worst: f64,
    /// Name of the picture with the largest percentage. Empty if all are 0.
    pub worst_name: String,
    sum: f64,
}

impl Summary {
    /// Adds a picture.
    pub fn add(&mut self, name: &str, percent: f64) {
        self.count += 1;
        self.sum += percent;
        if percent > self.worst {
            (self.worst, self.worst_name) = (percent, name.to_owned());
        }
    }

    /// Returns the mean percentage, 0 of no picture.
    pub fn mean(&self) -> f64 {
        self.sum / self.count.max(1) as f64
    }
}

/// What a quality loses over many pictures.
#[derive(Clone, Debug)]
pub struct Row {
    /// The quality.
    pub quality: Quality,
    /// Lost pixels that are not apart: seen and light.
    pub lost: Summary,
    /// Lost pixels that are apart.
    pub apart: Summary,
}

impl Row {
    /// Starts a row without pictures.
    pub fn new(quality: Quality) -> Self {
        Self {
            quality,
            lost: Summary::default(),
            apart: Summary::default(),
        }
    }

    /// Adds what this row's quality loses of a scene.
    pub fn add(&mut self, judged: &Judged) {
        let size = judged.size;
        let name = format!("{} {}x{}", judged.name, size.width, size.height);
        for lost in judged.lost.iter().filter(|it| it.quality == self.quality) {
            let counts = lost.counts;
            self.lost.add(&name, counts.lost());
            self.apart.add(&name, counts.percent(counts.apart));
        }
    }

    /// Returns the row as a line. `title` says what the pictures are.
    pub fn line(&self, title: &str) -> String {
        let Self {
            quality,
            lost,
            apart,
        } = self;
        format!(
            "{title:<9} {:<5} {:>5} {:>9.3} % {:>8.4} % {:>9.3} % {:>8.4} %  {}",
            quality.name(),
            lost.count,
            lost.worst,
            lost.mean(),
            apart.worst,
            apart.mean(),
            lost.worst_name,
        )
        .trim_end()
        .to_owned()
    }
}

/// Head of a table of [`Row`]s.
pub const HEAD: &str =
    "          quality   n  lost: worst       mean  apart: worst      mean  worst scene";

/// Head of the lines of [`lines`].
pub const LINES_HEAD: &str = "scene                      size     quality pixels  exact within 1 \
    |  seen            light           apart";

/// Returns a line for each quality. The lines start with the name, the size and the number of
/// reflections.
pub fn lines(judged: &Judged) -> impl Iterator<Item = String> {
    let size = format!("{}x{}", judged.size.width, judged.size.height);
    judged.lost.iter().map(move |lost| {
        let counts = lost.counts;
        let share = |count| format!("{count:>6} {:>6.3} %", counts.percent(count));
        format!(
            "{:<26} {size:<8} {:<5} {:>8} {:>11.2} %  | {} {} {}",
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

/// The rows of all families that were drawn, and of all scenes together.
pub struct FamilyTable {
    families: Vec<(Family, Vec<Row>)>,
    /// Rows over all scenes.
    pub all: Vec<Row>,
}

impl FamilyTable {
    /// Starts a table without scenes.
    pub fn new(families: &[Family], qualities: &[Quality]) -> Self {
        let rows = || qualities.iter().map(|it| Row::new(*it)).collect::<Vec<_>>();
        Self {
            families: families.iter().map(|it| (*it, rows())).collect(),
            all: rows(),
        }
    }

    /// Adds a scene of a family.
    pub fn add(&mut self, family: Family, judged: &Judged) {
        let families = self.families.iter_mut().filter(|(it, _)| *it == family);
        let rows = families.flat_map(|(_, rows)| rows).chain(&mut self.all);
        rows.for_each(|row| row.add(judged));
    }

    /// Returns the lines of the table, with a head.
    pub fn lines(&self) -> Vec<String> {
        let families = self
            .families
            .iter()
            .flat_map(|(family, rows)| rows.iter().map(|row| row.line(family.name())));
        let all = self.all.iter().map(|row| row.line("all"));
        [HEAD.to_owned()]
            .into_iter()
            .chain(families)
            .chain(all)
            .collect()
    }
}
