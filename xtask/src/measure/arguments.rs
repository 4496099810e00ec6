//! The command line of `cargo xtask measure`.

use std::path::PathBuf;

use anyhow::Result;
use clap::{Args, value_parser};

use super::cores::Core;
use super::scene::Scene;
use super::task::{Quality, Settings, Shading, Size, Task};

/// Builds a firmware that renders one scene, runs it on an emulated core and counts.
#[derive(Args, Debug)]
#[command(after_long_help = include_str!("help.txt").trim_end())]
pub struct Arguments {
    #[command(flatten)]
    pub(super) choice: Choice,

    /// Print a line of JSON instead of a table
    #[arg(long)]
    pub(super) json: bool,

    /// Measure everything again, on --core or on all, and write docs/measured and docs/boards.md
    #[arg(long, conflicts_with_all = ["scene", "name", "size", "reflections", "shading", "quality", "json"])]
    pub(super) all: bool,
}

/// One measurement, as the command line says it.
#[derive(Args, Debug)]
pub struct Choice {
    /// The core [default: m3]
    #[arg(long, value_parser = Core::parser())]
    pub(super) core: Option<&'static Core>,

    /// A built-in scene, or a scene file
    #[arg(long, value_name = "NAME|FILE.json", default_value = "castle")]
    scene: PathBuf,

    /// The scene to take from a file that holds several
    #[arg(long, value_name = "SCENE")]
    name: Option<String>,

    /// Width and height in pixels
    #[arg(long, value_name = "WxH", default_value = "64x64")]
    size: Size,

    /// How often a ray is reflected, from 0 to 255
    #[arg(
        long,
        value_name = "N",
        default_value_t = 4,
        allow_negative_numbers = true
    )]
    #[arg(value_parser = value_parser!(u8))]
    reflections: u8,

    /// How light shines on a surface
    #[arg(long, value_enum, default_value_t = Shading::BlinnPhong)]
    shading: Shading,

    /// How exactly fixed point computes, or the float port instead
    #[arg(long, value_enum, default_value_t = Quality::FAST)]
    quality: Quality,

    /// Link everything that any scene needs, whether this one does or not
    #[arg(long)]
    whole: bool,
}

impl Choice {
    /// The task that it comes to.
    ///
    /// # Errors
    /// [`Misuse`](crate::misuse::Misuse) where the scene cannot be used.
    pub fn task(&self) -> Result<Task> {
        Ok(Task {
            core: self.core.unwrap_or(Core::M3),
            scene: Scene::open(&self.scene, self.name.as_deref())?,
            settings: Settings {
                size: self.size,
                reflections: self.reflections,
                shading: self.shading,
                quality: self.quality,
                is_whole: self.whole,
            },
        })
    }
}
