//! Writes the page of the report, index.md: the verdict and a plot first, then the method, then each
//! scene.

use xtask::table::filled;

use crate::arguments::Arguments;
use crate::contest::{self, Contest};
use crate::point::Point;
use crate::scene::Measured;
use xtask::measure::Core;

pub struct Page<'a> {
    pub arguments: &'a Arguments,
    pub sections: Vec<Section<'a>>,
}

pub struct Section<'a> {
    pub scene: &'a Measured,
    /// Name of the plot's file.
    pub file: String,
    pub front: Vec<&'a Point>,
}

impl Page<'_> {
    pub fn markdown(&self) -> String {
        let core = self.arguments.core;
        let contests = self.sections.iter().map(|it| Contest::new(it.scene));
        let contests: Vec<Contest> = contests.collect();
        let links = self.sections.iter().map(|it| &it.scene.painter.name);
        let links: Vec<_> = links.map(|name| format!("[{name}](#{name})")).collect();
        let points = self.sections.iter().flat_map(|it| &it.scene.points);
        let promises: Vec<_> = points.filter_map(|it| it.errors.promised).collect();
        let broken: usize = promises.iter().map(|it| it.broken).sum();
        let values = [
            ("command", self.arguments.command()),
            ("verdict", contest::verdict(&contests, core)),
            ("file", self.sections[0].file.clone()),
            ("scenes", links.join(", ")),
            ("core", core.title.to_owned()),
            ("size", self.arguments.size_words()),
            ("contests", list(contests.iter().map(Contest::words))),
            ("promises", promises.len().to_string()),
            ("broken", broken.to_string()),
            (
                "sections",
                self.sections.iter().map(|it| it.markdown(core)).collect(),
            ),
        ];
        filled(include_str!("page.md"), &values)
    }
}

impl Section<'_> {
    fn markdown(&self, core: &Core) -> String {
        let (name, file) = (&self.scene.painter.name, &self.file);
        let last = self.scene.last;
        format!(
            "## {name}\n\n{}\n\n![PSNR against cost]({file})\n\n\
             The last reflection that changes the picture is N = {last}.\n\n",
            list(self.recommendations(core)),
        )
    }

    /// Returns the best setting for each cost budget, if it differs from that of the budget before.
    fn recommendations(&self, core: &Core) -> Vec<String> {
        let budgets: &[f64] = match core.name {
            "m0" => &[300.0, 1000.0, 2000.0, 3000.0, 5000.0, 10_000.0, 20_000.0],
            _ => &[
                100.0, 200.0, 300.0, 500.0, 700.0, 1000.0, 1500.0, 2000.0, 3000.0, 5000.0,
            ],
        };
        let mut lines = Vec::new();
        let mut last = None;
        for budget in budgets {
            let fits = |it: &(usize, &&Point)| it.1.cost.instructions <= *budget;
            let best = self.front.iter().enumerate().rfind(fits);
            let Some((index, point)) = best.filter(|it| last != Some(it.0)) else {
                continue;
            };
            last = Some(index);
            lines.push(format!(
                "For {budget} instructions a pixel use {} ({}: {:.0}, {} dB, largest {}).",
                point.setting.words(),
                index + 1,
                point.cost.instructions,
                decibels(point.psnr()),
                point.errors.largest
            ));
        }
        lines
    }
}

fn decibels(psnr: f64) -> String {
    match psnr.is_finite() {
        true => format!("{psnr:.1}"),
        false => "∞".to_owned(),
    }
}

fn list(lines: impl IntoIterator<Item = String>) -> String {
    let lines = lines.into_iter().map(|it| format!("- {it}"));
    lines.collect::<Vec<_>>().join("\n")
}
