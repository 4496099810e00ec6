//! The page of the report, index.md: pictures and the verdict first, then each scene, then the method.

use crate::arguments::{Arguments, Core};
use crate::contest::{self, Contest};
use crate::error::Promised;
use crate::point::{GAIN, Point, front};
use crate::scene::Measured;
use crate::write::DIFFERENCE_GAIN;

/// All of a report.
pub struct Page<'a> {
    pub arguments: &'a Arguments,
    pub sections: Vec<Section<'a>>,
    /// The furthest that any level in the room of mirrors is from the formula.
    pub furthest: f64,
}

/// A scene.
pub struct Section<'a> {
    pub scene: &'a Measured,
    /// What its files are called.
    pub file: String,
    pub front: Vec<&'a Point>,
    pub samples: Vec<Sample>,
}

/// A picture at a point of the front, and its difference.
pub struct Sample {
    /// Of the point.
    pub index: usize,
    pub files: [String; 2],
}

/// The heads of a scene's table.
const HEADS: [&str; 14] = [
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
    /// The whole page.
    pub fn markdown(&self) -> String {
        let (command, core) = (self.arguments.command(), self.arguments.core);
        let contests = self.sections.iter().map(|it| Contest::new(it.scene, core));
        let contests: Vec<Contest> = contests.collect();
        let mut text = format!(
            "<!-- Written by `{command}`. Do not edit. -->\n\n# Error against run time\n\n"
        );
        if let Some(first) = self.sections.first() {
            text += &first.pictures(core, 1);
        }
        text += &format!("\n**{}**\n\n", contest::verdict(&contests, core));
        if let Some(Section { file, .. }) = self.sections.first() {
            text += &format!("![PSNR against cost]({file}-psnr.svg)\n\n");
        }
        let links = self.sections.iter().map(|it| &it.scene.painter.name);
        let links: Vec<_> = links.map(|name| format!("[{name}](#{name})")).collect();
        text += &format!("Scenes: {}\n\n", links.join(", "));
        text += &folded("How it is measured", &self.method());
        text += &folded(
            "Fixed point against float, scene by scene",
            &list(contests.iter().map(Contest::words)),
        );
        text += &folded("Theory beside measurement", &self.theory());
        text += &folded("What the columns of the tables mean", &self.columns());
        text.extend(self.sections.iter().map(|section| section.markdown(core)));
        text.trim_end().to_owned() + "\n"
    }

    fn method(&self) -> String {
        let size = self.arguments.size_words();
        let cost = match self.arguments.core {
            Core::Host => "The cost is the time on one thread of this machine, in percent of the time of \
                           the double-precision reference with as many reflections. It is the median of \
                           nine rounds, in which all settings take turns. points.csv has the quartiles."
                .to_owned(),
            Core::Emulated(core) => format!(
                "The cost is the number of instructions that a {} executes for a picture of {size}, \
                 divided by its pixels. It includes the preparation of the frame. An emulator counts \
                 them. The float port is counted on a Cortex-M4F, which has an FPU. An instruction is not \
                 a cycle.",
                core.title
            ),
        };
        format!(
            "The settings vary the number of reflections N, the quality, the smallest weight, shadows and \
             the size of a pixel. The competitor is the same model in f32 without this crate, \
             xtask/float_port.\n\n\
             {cost}\n\n\
             The error compares the 8-bit picture with a double-precision picture that follows every \
             reflection. PSNR is the peak signal-to-noise ratio over all channels, in decibels. The \
             largest error is the largest difference of a channel, of 255.\n\n\
             Fast, fine and exact are qualities of the library. Exact traces every pixel and cuts nothing \
             off. \"Cut at\" is fast with a larger smallest weight. \"x tolerance\" is fast with a larger \
             tolerance. \"No shadows\" is the shading Unshadowed. Larger pixels are drawn on an Enlarged \
             display.\n\n\
             A setting is on the front if no other setting has less error for the same cost. Plots and \
             tables give its points the same numbers. They leave out points that gain less than a quarter \
             of a decibel. points.csv has every setting. front.rs has the best settings as constants of \
             the library's type Front."
        )
    }

    fn theory(&self) -> String {
        let points = self.sections.iter().flat_map(|it| &it.scene.points);
        let promises: Vec<_> = points.filter_map(|it| it.errors.promised).collect();
        let broken: usize = promises.iter().map(|it| it.broken).sum();
        format!(
            "Truncation: the reflections after the last one, or after the weight falls below the cut-off, \
             add at most Π αₖ · max |c|. This is the weight of the path there, times the brightest colour \
             of a surface.\n\n\
             Rounding: a running error analysis bounds it along each path. The scene's grid has steps, \
             directions and weights are Q2.30, roots keep 27 bits, reciprocals 26, colours are Q6.26, a \
             product of colours keeps 20 bits behind the point, the sum is Q8.24. Pixels between traced \
             ones may add what the curves of the quality make of exact colours. The documentation of \
             reflet::host::reference::bound has the derivation.\n\n\
             Sure pixels: a pixel is not sure if a ray a 32nd of a pixel beside it, or beside a pixel it is \
             taken from, meets another shape or is lit by another light. Theory promises nothing of it. If \
             it is further than 1 from what its reflections come to, it counts as decided otherwise. All \
             other pixels are sure and keep the bound.\n\n\
             Of the {} pictures with shadows and at full resolution, sure pixels beyond their bound: \
             {broken}.\n\n\
             The formula of a room: in a room of six mirrors that glow with c = 1, every path goes on for \
             ever. After N reflections it shows c (1 − α^(N+1)). For N = 0 to 255, no level is further from \
             that than {:.2} of 255.\n\n\
             ![Levels against reflections](room.svg)",
            promises.len(),
            self.furthest
        )
    }

    fn columns(&self) -> String {
        format!(
            "Cost is in {}, PSNR in dB. \"Sure %\" is the percentage of sure pixels. All others are in 255ths. \
             \"Largest\" is the largest difference of all pixels, \"sure\" that of sure pixels, \"bound\" what \
             theory allows these. The other columns say where the error comes from. Each is a root of the \
             mean square of one part alone: reflections left out (truncation), the weight cut-off, pixels \
             between traced ones, rounding, pixels decided otherwise (with their number), and no shadows or \
             larger pixels (simplified).",
            self.arguments.core.unit()
        )
    }
}

impl Section<'_> {
    fn markdown(&self, core: Core) -> String {
        let (name, file) = (&self.scene.painter.name, &self.file);
        let last = self.scene.last;
        format!(
            "## {name}\n\n{}\nThe second row shows the differences, {DIFFERENCE_GAIN} times as large.\n\n\
             {}\n\n\
             ![PSNR against cost]({file}-psnr.svg)\n\n\
             ![Largest error against cost]({file}-largest.svg)\n\n\
             The last reflection that changes the picture is N = {last}.\n\n{}",
            self.pictures(core, 2),
            list(self.recommendations(core)),
            folded(
                "The points of the front, and where their error comes from",
                &self.table()
            ),
        )
    }

    /// A table of its pictures, with their differences if there are two rows.
    fn pictures(&self, core: Core, rows: usize) -> String {
        let line = |cell: &dyn Fn(&Sample) -> String| {
            let cells: Vec<_> = self.samples.iter().map(cell).collect();
            line(&cells)
        };
        let head = line(&|it| {
            let point = self.front[it.index];
            let (cost, psnr) = (cost(point), decibels(point.psnr()));
            format!("point {}: {cost} {}, {psnr} dB", it.index + 1, core.unit())
        });
        let rows = (0..rows).map(|row| line(&|it| format!("![]({})", it.files[row])));
        head + &line(&|_| ":-:".to_owned()) + &rows.collect::<String>()
    }

    /// What to use for a budget, for each budget that changes it.
    fn recommendations(&self, core: Core) -> Vec<String> {
        let budgets: &[f64] = match core.name() {
            "host" => &[1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0],
            "m0" => &[300.0, 1000.0, 2000.0, 3000.0, 5000.0, 10_000.0, 20_000.0],
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
                point.setting.words(),
                index + 1,
                cost(point),
                decibels(point.psnr()),
                point.errors.largest
            ));
        }
        lines
    }

    fn table(&self) -> String {
        let float = front(&self.scene.float, GAIN);
        let numbered = (1..).zip(&self.front);
        let fixed = numbered.map(|(number, it)| row(number.to_string(), it));
        let others = float.into_iter().chain(&self.scene.soft);
        let others = others.map(|it| row(String::new(), it));
        let heads = line(&HEADS.map(str::to_owned));
        let sides = format!("|--:|---|{}\n", "--:|".repeat(HEADS.len() - 2));
        let rows: String = fixed.chain(others).map(|row| line(&row)).collect();
        (heads + &sides + &rows).trim_end().to_owned()
    }
}

fn row(number: String, point: &Point) -> [String; HEADS.len()] {
    let (errors, parts) = (&point.errors, &point.errors.parts);
    let is_float = point.setting.is_float();
    let words = match is_float {
        true => format!("{} on {}", point.setting.words(), point.core),
        false => point.setting.words(),
    };
    let of_promise = |show: fn(&Promised) -> String| {
        let shown = errors.promised.as_ref().map(show);
        shown.unwrap_or_else(|| "–".to_owned())
    };
    let part = |value: f64| match is_float {
        true => "–".to_owned(),
        false => format!("{value:.2}"),
    };
    let decided = errors.promised.map(|it| format!(" ({})", it.decided));
    [
        number,
        words,
        cost(point),
        decibels(point.psnr()),
        errors.largest.to_string(),
        // Rounded down, so that 100 are all.
        of_promise(|it| format!("{:.1}", (1000.0 * it.sure).floor() / 10.0)),
        of_promise(|it| it.largest.to_string()),
        of_promise(|it| format!("{:.1}", it.bound)),
        format!("{:.2}", parts.truncation),
        part(parts.cut_off),
        part(parts.between),
        part(parts.rounding),
        part(parts.decided) + &decided.unwrap_or_default(),
        part(parts.simplified),
    ]
}

/// The cost of a point, with its quartiles if it was timed.
pub fn cost(point: &Point) -> String {
    match point.cost.quartiles {
        Some((lower, upper)) => format!("{:.2} ({lower:.2} to {upper:.2})", point.cost.middle),
        None => format!("{:.0}", point.cost.middle),
    }
}

/// In decibels; infinite where nothing differs.
pub fn decibels(psnr: f64) -> String {
    match psnr.is_finite() {
        true => format!("{psnr:.1}"),
        false => "∞".to_owned(),
    }
}

fn folded(summary: &str, text: &str) -> String {
    format!("<details><summary>{summary}</summary>\n\n{text}\n\n</details>\n\n")
}

fn list(lines: impl IntoIterator<Item = String>) -> String {
    let lines = lines.into_iter().map(|it| format!("- {it}"));
    lines.collect::<Vec<_>>().join("\n")
}

/// A row of a table.
fn line(cells: &[String]) -> String {
    format!("| {} |\n", cells.join(" | "))
}
