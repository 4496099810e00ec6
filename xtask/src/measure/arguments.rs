//! The command line of `cargo xtask measure`.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use command_line::Chosen;

use super::build_profile::BuildProfile;
use super::cores::Core;
use super::scene::Scene;
use super::speed::Board;
use super::task::{Settings, Task};

/// Builds a firmware that renders one scene, runs it on an emulated core and counts.
#[derive(Args, Debug)]
#[command(after_long_help = include_str!("help.txt").trim_end())]
pub struct Arguments {
    #[command(flatten)]
    pub(super) choice: Choice,

    #[command(flatten)]
    pub(super) board: Board,

    /// Print a line of JSON instead of a table
    #[arg(long)]
    pub(super) json: bool,

    /// Move the first sphere, or the first bounded shape, of the scene before the frame
    #[arg(long, conflicts_with_all = ["is_whole", "all", "profiles"])]
    pub(super) moving: bool,

    /// Measure everything again, on --core or on all, and write docs/measured and docs/boards.md
    #[arg(long, conflicts_with_all = ["scene", "chosen", "size"])]
    #[arg(conflicts_with_all = ["reflections", "shading", "quality", "json", "is_whole"])]
    pub(super) all: bool,

    /// Estimate the frames a second of boards that people own again, and write
    /// docs/measured/frames.jsonl, the table in README.md and docs/boards.md
    #[arg(long, conflicts_with_all = ["all", "core", "scene", "chosen", "size", "clock", "moving"])]
    #[arg(conflicts_with_all = ["reflections", "shading", "quality", "json", "is_whole", "profiles"])]
    pub(super) frames: bool,

    /// Measure two scenes in several build profiles again, write docs/measured/profiles.jsonl, and put
    /// the figures into docs/sizes.md and src/lib.rs
    #[arg(long, conflicts_with_all = ["all", "core", "scene", "chosen", "size"])]
    #[arg(conflicts_with_all = ["reflections", "shading", "quality", "json", "is_whole"])]
    pub(super) profiles: bool,

    /// Measure the scenes after published ray tracers again, and write docs/measured/yardstick.jsonl and
    /// the table in docs/yardstick.md
    #[arg(long, conflicts_with_all = ["all", "core", "scene", "chosen", "size", "clock", "moving", "frames"])]
    #[arg(conflicts_with_all = ["reflections", "shading", "quality", "json", "is_whole", "profiles"])]
    pub(super) yardstick: bool,

    /// Measure what a ray, a bounce, a light or an interpolated pixel takes, on --core or on all, and write
    /// docs/measured/units.jsonl and docs/internals/units.md if m3 is measured
    #[arg(long, conflicts_with_all = ["all", "scene", "chosen", "size", "clock", "moving", "frames", "yardstick"])]
    #[arg(conflicts_with_all = ["reflections", "shading", "quality", "json", "is_whole", "profiles"])]
    pub(super) units: bool,
}

/// One measurement, as the command line says it.
#[derive(Args, Debug)]
pub struct Choice {
    /// The core [default: m3]
    #[arg(long, value_parser = Core::parser())]
    pub(super) core: Option<&'static Core>,

    /// A built-in scene or a scene file
    #[arg(value_name = "SCENE|FILE.json", default_value = "castle")]
    scene: PathBuf,

    #[command(flatten)]
    chosen: Chosen,

    #[command(flatten)]
    settings: Settings,
}

impl Choice {
    /// Returns the measurement that the arguments ask for.
    pub fn task(&self) -> Result<Task> {
        Ok(Task {
            core: self.core.unwrap_or(Core::M3),
            scene: Scene::open(&self.scene, &self.chosen)?,
            settings: self.settings,
            profile: BuildProfile::RECOMMENDED,
        })
    }
}
