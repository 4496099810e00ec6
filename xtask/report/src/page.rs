//! Writes the page of the report, index.md: the verdict and a plot first, then the method, then each
//! scene.

use xtask::table::filled;

use crate::arguments::Arguments;
use crate::point::Point;
use crate::scene::Measured;
use xtask::measure::{Core, words};

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
        let links = self.sections.iter().map(|it| &it.scene.name);
        let links: Vec<_> = links.map(|name| format!("[{name}](#{name})")).collect();
        let values = [
            ("command", self.arguments.command()),
            ("verdict", self.verdict()),
            ("file", self.sections[0].file.clone()),
            ("scenes", links.join(", ")),
            ("core", core.title.to_owned()),
            ("size", words(self.arguments.size)),
            (
                "sections",
                self.sections.iter().map(|it| it.markdown(core)).collect(),
            ),
        ];
        filled(include_str!("page.md"), &values)
    }

    /// Says in how many scenes a good picture is cheap.
    fn verdict(&self) -> String {
        /// Instructions a pixel, and decibels.
        const CHEAP: f64 = 1000.0;
        const GOOD: f64 = 40.0;
        let is_both = |it: &&Point| it.cost() <= CHEAP && it.psnr >= GOOD;
        let good = |it: &&Section| it.front.iter().any(is_both);
        let count = self.sections.iter().filter(good).count();
        format!(
            "With at most {CHEAP} instructions a pixel of a {}, {count} of {} scenes have a PSNR of {GOOD} dB or more.",
            self.arguments.core.title,
            self.sections.len()
        )
    }
}

impl Section<'_> {
    fn markdown(&self, core: &Core) -> String {
        let (name, file) = (&self.scene.name, &self.file);
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
            let fits = |it: &(usize, &&Point)| it.1.cost() <= *budget;
            let best = self.front.iter().enumerate().rfind(fits);
            let Some((index, point)) = best.filter(|it| last != Some(it.0)) else {
                continue;
            };
            last = Some(index);
            lines.push(format!(
                "For {budget} instructions a pixel use {} ({}: {:.0}, {} dB, largest {}).",
                point.setting.words(),
                index + 1,
                point.cost(),
                decibels(point.psnr),
                point.largest
            ));
        }
        lines
    }
}

fn decibels(psnr: f64) -> String {
    if psnr.is_finite() { format!("{psnr:.1}") } else { "∞".to_owned() }
}

fn list(lines: impl IntoIterator<Item = String>) -> String {
    let lines = lines.into_iter().map(|it| format!("- {it}"));
    lines.collect::<Vec<_>>().join("\n")
}
