//! `cargo xtask size`: measures the flash and RAM of every built-in scene, and lists what is left
//! out of its firmware.
//!
//! It builds every scene in every quality for the smallest cores: with four reflections and, if the
//! scene has mirrors, also with none. [`Figures`] is one line in docs/measured/sizes.jsonl, which is
//! also the budget in the tests. [`page`] writes docs/sizes.md from these lines.

mod page;

use std::thread;

use anyhow::{Context, Result};
use clap::{Args, builder::PossibleValuesParser};
use reflet::needs::Needs;
use reflet::scenes;
use reflet::scenes::{BuiltIn, Visitor};
use serde::{Deserialize, Serialize};

use crate::measure::{Core, Quality, Scene, Size, Task, outcome, profiles, weigh, weight};
use crate::{board, kept, print, root, table, toolchain};

/// Weighs the firmware of every built-in scene and quality; without options it also writes
/// docs/sizes.md and the budget that the tests hold the scenes to.
#[derive(Args, Debug)]
#[command(after_long_help = include_str!("help.txt").trim_end())]
pub struct Arguments {
    /// One target only
    #[arg(long, value_parser = PossibleValuesParser::new(TARGETS.map(|(target, _)| target)))]
    target: Option<String>,

    /// One built-in scene only
    #[arg(value_name = "SCENE", value_parser = PossibleValuesParser::new(scenes::NAMES))]
    scene: Option<String>,

    /// Print a line of JSON for each firmware instead of a table
    #[arg(long)]
    json: bool,
}

/// Figures of all tasks, which the tests hold them to.
const BUDGET: &str = "docs/measured/sizes.jsonl";

/// Targets of the smallest chips, each with the core that runs it.
const TARGETS: [(&str, &str); 2] = [(toolchain::M0, "m0"), (toolchain::M3, "m3")];

/// The measured qualities: all but the float port.
pub const QUALITIES: [Quality; 3] = [Quality::FAST, Quality::SMALL, Quality::EXACT];

/// Numbers of reflections of a scene with mirrors. A scene without mirrors is built with the first
/// only.
const REFLECTIONS: [u8; 2] = [4, 0];

/// Size of the picture in pixels. The use of stack hardly depends on it.
const SIZE: Size = Size::new(64, 16);

/// Example that is the whole firmware of the default board, with the castle as its only scene.
pub const BOARD: &str = "board_castle";

/// Sizes of one firmware: a line of the file. The JSON keys are the names of the fields.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Figures {
    /// Target triple of the core.
    pub target: String,
    pub scene: String,
    pub quality: String,
    pub reflections: u8,
    pub code: u64,
    pub constants: u64,
    /// Flash in bytes: code and constants.
    pub flash: u64,
    pub ram: u64,
    /// Most bytes of stack in use at a time.
    pub stack: u64,
    /// Names of the [`Needs`] that the scene does not have.
    pub left_out: Vec<String>,
}

pub fn run(arguments: &Arguments) -> Result<()> {
    let tasks: Vec<_> = tasks()
        .into_iter()
        .filter(|task| {
            let is_target = |target: &String| target == task.core.target;
            let is_scene = |scene: &String| scene == task.scene.name();
            arguments.target.as_ref().is_none_or(is_target)
                && arguments.scene.as_ref().is_none_or(is_scene)
        })
        .collect();
    let figures = weighed(&tasks)?;
    if arguments.json {
        for figures in &figures {
            print(figures.json()? + "\n")?;
        }
        return Ok(());
    }
    let (head, rows) = page::table(&figures);
    print(table::markdown(4, &head, rows) + "\n")?;
    if arguments.target.is_none() && arguments.scene.is_none() {
        let board = weigh(&board::build_example(BOARD)?)?;
        kept::write_lines(BUDGET, &figures)?;
        let page = page::write(&figures, board, &profiles::read()?);
        kept::write(&root().join("docs/sizes.md"), &page)?;
    }
    Ok(())
}

pub fn tasks() -> Vec<Task> {
    let mut tasks = Vec::new();
    for (_, core) in TARGETS {
        let core = Core::find(core).expect("it is in the list");
        for name in scenes::NAMES {
            for reflections in REFLECTIONS {
                if reflections != REFLECTIONS[0] && needs(name, u8::MAX).reflections == 0 {
                    continue;
                }
                tasks.extend(QUALITIES.map(|quality| {
                    let mut task = Task::new(core, Scene::BuiltIn(name), SIZE, quality);
                    task.settings.reflections = reflections;
                    task
                }));
            }
        }
    }
    tasks
}

/// Returns the figures of all tasks, in their order. Tasks for different targets run at the same
/// time.
fn weighed(tasks: &[Task]) -> Result<Vec<Figures>> {
    let of_target = |target: &str| -> Result<Vec<_>> {
        let tasks = tasks.iter().filter(|task| task.core.target == target);
        tasks.map(Figures::of).collect()
    };
    let results = thread::scope(|scope| {
        let threads = TARGETS.map(|(target, _)| scope.spawn(move || of_target(target)));
        threads.map(|thread| thread.join().expect("no weighing panics"))
    });
    let figures: Result<Vec<_>> = results.into_iter().collect();
    Ok(figures?.concat())
}

impl Figures {
    pub fn of(task: &Task) -> Result<Self> {
        let (outcome, weight) = (outcome(task)?, weight(task)?);
        let (reflections, quality) = (task.settings.reflections, task.settings.quality);
        let left_out = needs(task.scene.name(), reflections).list();
        let left_out = left_out.iter().filter(|it| !it.is_needed);
        Ok(Self {
            target: task.core.target.to_owned(),
            scene: task.scene.name().to_owned(),
            quality: quality.name().to_owned(),
            reflections,
            code: weight.code,
            constants: weight.flash - weight.code,
            flash: weight.flash,
            ram: weight.ram,
            stack: outcome.stack,
            left_out: left_out.map(|need| need.name.to_owned()).collect(),
        })
    }

    pub fn json(&self) -> Result<String> {
        serde_json::to_string(self).context("figures are plain")
    }

    pub fn are_of(&self, task: &Task) -> bool {
        (&*self.target, &*self.scene) == (task.core.target, task.scene.name())
            && self.quality == task.settings.quality.name()
            && self.reflections == task.settings.reflections
    }

    /// Returns a message if the task needs more than 1.02 times the flash of these figures, else
    /// `None`.
    pub fn excess(&self, task: &Task) -> Result<Option<String>> {
        let flash = weight(task)?.flash;
        let is_within = flash * 100 <= self.flash * 102;
        Ok((!is_within).then(|| {
            format!(
                "{} {} {} N = {}: {flash} bytes, and the budget is {}",
                self.target, self.scene, self.quality, self.reflections, self.flash
            )
        }))
    }
}

/// Returns what a built-in scene needs with at most this many reflections.
fn needs(name: &str, reflections: u8) -> Needs {
    struct Derive;

    impl Visitor for Derive {
        type Output = Needs;

        fn visit<S: BuiltIn>(self) -> Needs {
            Needs::of::<S>()
        }
    }

    let needs = scenes::visit(name, Derive).expect("the name was found in the list of names");
    needs.both(&Needs::ALL.with_reflections(reflections))
}

pub fn kept() -> Result<Vec<Figures>> {
    kept::read(BUDGET, "size")
}
