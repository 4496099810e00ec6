//! `cargo xtask scale`: measures how the cost of a frame grows with the number of spheres.
//!
//! The scenes come from [`benchmark`] and differ only in the number and size of their spheres. Each
//! becomes a constant scene and is measured like any other ([`crate::measure`]). `page.md` is the
//! template of `docs/scale.md`, `mirrors.md` that of `docs/mirrors.md`.

use anyhow::{Context, Result};
use benchmark::{Mirrors, Order};
use clap::Args;
use reflet::host::{file::SceneFile, reference};
use serde::Serialize;

use crate::measure::{Core, Figures, Quality, Scene, Size, Task};
use crate::table::{filled, markdown};
use crate::{kept, measure, print, root};

/// Measures what a frame takes with 1, 2, 4 and so on to 256 spheres; without options it also
/// writes docs/scale.md, and docs/mirrors.md with `--mirrors` alone.
#[derive(Args, Debug)]
#[command(after_long_help = include_str!("help.txt").trim_end())]
pub struct Arguments {
    /// The core [default: m3]
    #[arg(long, value_parser = Core::parser())]
    core: Option<&'static Core>,

    /// Width and height in pixels [default: 64x64]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,

    /// Measure beads that are all mirrors, 4 to 256 of them
    #[arg(long)]
    mirrors: bool,

    /// Print a line of JSON instead of a table
    #[arg(long)]
    json: bool,
}

/// Numbers of spheres of the measured scenes.
pub const COUNTS: [usize; 9] = [1, 2, 4, 8, 16, 32, 64, 128, 256];

/// Number of spheres of the smaller of the two scenes that are compared with each other.
pub const FEW: usize = 16;
/// Number of spheres of the larger of the two compared scenes; see [`FEW`].
pub const MANY: usize = 256;

/// Upper limit of the quotient: [`MANY`] spheres have to cost less than this times the cost of
/// [`FEW`] spheres. A kernel that tests every sphere costs [`MANY`] / [`FEW`] times as much.
pub const BAR: f64 = 6.0;

/// Fewest spheres of the measured scenes in which all are mirrors.
const FEWEST_MIRRORS: usize = 4;

/// [`BAR`] for scenes in which all spheres are mirrors.
pub const MIRRORS_BAR: f64 = 3.5;

/// Default size of the measured pictures, in pixels.
pub const SIZE: Size = Size::new(64, 64);

/// Figures of the scene with one number of spheres. The JSON keys are the names of the fields.
#[derive(Clone, Debug, Serialize)]
struct Member {
    spheres: usize,
    instructions_per_pixel: f64,
    /// Instructions per pixel divided by those of the member before; `None` for the first.
    times: Option<f64>,
    /// Instructions per pixel with the spheres listed in random order.
    shuffled_instructions_per_pixel: f64,
    prepare_instructions: u64,
    flash: u64,
    seen: f64,
}

/// All figures of the command. The JSON keys are the names of the fields.
#[derive(Debug, Serialize)]
struct Scale {
    core: &'static str,
    size: String,
    members: Vec<Member>,
    /// Instructions per pixel with [`MANY`] spheres, divided by those with [`FEW`].
    times: f64,
    /// The quotient of [`MANY`] and [`FEW`] with the spheres listed in random order.
    shuffled_times: f64,
    bar: f64,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let (core, size) = (
        arguments.core.unwrap_or(Core::M3),
        arguments.size.unwrap_or(SIZE),
    );
    let mut members = Vec::new();
    if !arguments.json {
        print(line(&head()) + "\n")?;
    }
    let mirrors = match arguments.mirrors {
        true => Mirrors::All,
        false => Mirrors::EveryOther,
    };
    for count in counts(mirrors) {
        let member = Member::measure(core, size, (count, mirrors), members.last())?;
        if !arguments.json {
            print(line(&member.cells()) + "\n")?;
        }
        members.push(member);
    }
    let scale = Scale::new(core, size, mirrors, members)?;
    match arguments.json {
        true => print(serde_json::to_string(&scale)? + "\n")?,
        false => print(format!("\n{}\n", scale.verdict()))?,
    }
    if arguments.core.is_none() && arguments.size.is_none() && !arguments.json {
        let (page, template) = match mirrors {
            Mirrors::EveryOther => ("docs/scale.md", include_str!("page.md")),
            Mirrors::All => ("docs/mirrors.md", include_str!("mirrors.md")),
        };
        kept::write(&root().join(page), &scale.page(core, template))?;
    }
    Ok(())
}

/// Returns the numbers of spheres of the measured scenes.
fn counts(mirrors: Mirrors) -> impl Iterator<Item = usize> {
    let fewest = match mirrors {
        Mirrors::EveryOther => 1,
        Mirrors::All => FEWEST_MIRRORS,
    };
    COUNTS.into_iter().filter(move |count| *count >= fewest)
}

pub fn count(
    core: &'static Core,
    size: Size,
    (spheres, mirrors): (usize, Mirrors),
    order: Order,
) -> Result<Figures> {
    let scene = Scene::parse(&benchmark::scene(spheres, mirrors, order))?;
    measure::count(&Task::new(core, scene, size, Quality::FAST))
}

fn head() -> Vec<String> {
    let names = "spheres instr/pixel times shuffled prepare flash seen".split(' ');
    names.map(str::to_owned).collect()
}

impl Member {
    fn measure(
        core: &'static Core,
        size: Size,
        (spheres, mirrors): (usize, Mirrors),
        before: Option<&Self>,
    ) -> Result<Self> {
        let figures = count(core, size, (spheres, mirrors), Order::Spiral)?;
        let shuffled = count(core, size, (spheres, mirrors), Order::Shuffled)?;
        let instructions = figures.instructions_per_pixel;
        Ok(Self {
            spheres,
            instructions_per_pixel: instructions,
            times: before.map(|before| instructions / before.instructions_per_pixel),
            shuffled_instructions_per_pixel: shuffled.instructions_per_pixel,
            prepare_instructions: figures.prepare_instructions,
            flash: figures.flash,
            seen: seen(size, spheres)?,
        })
    }

    /// Returns the figures as table cells, in the order of [`head`].
    fn cells(&self) -> Vec<String> {
        let times = self.times.map(|times| format!("{times:.2}"));
        vec![
            self.spheres.to_string(),
            format!("{:.1}", self.instructions_per_pixel),
            times.unwrap_or_else(|| "-".to_owned()),
            format!("{:.1}", self.shuffled_instructions_per_pixel),
            self.prepare_instructions.to_string(),
            self.flash.to_string(),
            format!("{:.0} %", 100.0 * self.seen),
        ]
    }
}

/// Formats a row of the printed table. Each row is printed as soon as it is measured.
fn line(cells: &[String]) -> String {
    let width = head().iter().map(String::len).max().unwrap_or(0);
    let cells: Vec<_> = cells.iter().map(|cell| format!("{cell:>width$}")).collect();
    cells.join("  ")
}

impl Scale {
    fn new(core: &Core, size: Size, mirrors: Mirrors, members: Vec<Member>) -> Result<Self> {
        let member = |spheres| {
            let found = members.iter().find(|member| member.spheres == spheres);
            found.context("a scene was not measured")
        };
        let (few, many) = (member(FEW)?, member(MANY)?);
        Ok(Self {
            core: core.name,
            size: size.to_string(),
            times: many.instructions_per_pixel / few.instructions_per_pixel,
            shuffled_times: many.shuffled_instructions_per_pixel
                / few.shuffled_instructions_per_pixel,
            bar: match mirrors {
                Mirrors::EveryOther => BAR,
                Mirrors::All => MIRRORS_BAR,
            },
            members,
        })
    }

    fn page(&self, core: &Core, template: &str) -> String {
        let rows: Vec<_> = self.members.iter().map(Member::cells).collect();
        let values = [
            ("last", COUNTS[COUNTS.len() - 1].to_string()),
            ("size", self.size.clone()),
            ("title", core.title.to_owned()),
            ("verdict", self.verdict()),
            ("full", (MANY / FEW).to_string()),
            ("table", markdown(0, &head(), &rows)),
        ];
        filled(template, &values)
    }

    fn verdict(&self) -> String {
        let (times, shuffled_times, bar) = (self.times, self.shuffled_times, self.bar);
        format!(
            "{MANY} spheres cost {times:.2} times what {FEW} cost; the bar is less than {bar}. \
             In random order {shuffled_times:.2} times."
        )
    }
}

/// Returns the share of the pixels that show a sphere directly: 0 to 1.
fn seen(size: Size, spheres: usize) -> Result<f64> {
    let text = benchmark::scene(spheres, Mirrors::EveryOther, Order::Spiral);
    let file = SceneFile::parse(&text, None)?;
    let (mut scene, camera) = file.reference();
    scene.planes.clear();
    let shading = reference::Shading::Normals;
    let picture = reference::render(&scene, &camera, size.width, size.height, 0, shading);
    // The colour that this shading gives a ray that hits nothing; no normal has this colour.
    let is_sphere = |pixel: &&[u8; 3]| **pixel != [0, 0, 255];
    let shown = picture.pixels.iter().filter(is_sphere).count();
    Ok(shown as f64 / picture.pixels.len() as f64)
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;

    /// Returns made-up figures: as many instructions as spheres, and their square in random order.
    fn scale() -> Scale {
        let member = |spheres: usize| Member {
            spheres,
            instructions_per_pixel: spheres as f64,
            times: (spheres > 1).then_some(2.0),
            shuffled_instructions_per_pixel: spheres.pow(2) as f64,
            prepare_instructions: 5,
            flash: 6,
            seen: 0.25,
        };
        let members = COUNTS.map(member).to_vec();
        Scale::new(Core::M3, SIZE, Mirrors::EveryOther, members).unwrap()
    }

    #[test]
    fn few_are_held_against_many() {
        assert_eq!(
            scale().verdict(),
            "256 spheres cost 16.00 times what 16 cost; the bar is less than 6. \
             In random order 256.00 times."
        );
    }

    #[test]
    fn json_has_the_keys_that_the_help_names() {
        let json = serde_json::to_value(scale()).unwrap();
        let has = |value: &Value, keys: &str| {
            let found = value.as_object().unwrap().keys().map(String::as_str);
            assert_eq!(found.collect::<Vec<_>>().join(" "), keys);
        };
        has(&json, "bar core members shuffled_times size times");
        let keys = "flash instructions_per_pixel prepare_instructions seen \
                    shuffled_instructions_per_pixel spheres times";
        has(&json["members"][0], keys);
        assert_eq!(json["members"][0]["times"], Value::Null);
        assert_eq!(json["members"][8]["times"], 2.0);
    }

    #[test]
    fn page_has_a_row_for_every_scene() {
        let page = scale().page(Core::M3, include_str!("page.md"));
        for spheres in COUNTS {
            assert!(
                page.contains(&format!("\n| {spheres} | {spheres}.0 | ")),
                "{page}"
            );
        }
        assert!(page.contains(&scale().verdict()));
    }
}
