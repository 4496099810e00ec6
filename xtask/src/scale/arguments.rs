//! The command line of `cargo xtask scale`.

use clap::Args;

use super::SIZE;
use crate::measure::{cores::Core, task::Size};

/// Measures what a frame takes with 1, 2, 4 and so on to 256 spheres; without options it also
/// writes docs/scale.md.
#[derive(Args, Debug)]
#[command(after_long_help = AFTER_HELP)]
pub struct Arguments {
    /// The core [default: m3]
    #[arg(long, value_parser = Core::parser())]
    core: Option<&'static Core>,

    /// Width and height in pixels [default: 64x64]
    #[arg(long, value_name = "WxH")]
    size: Option<Size>,

    /// Print a line of JSON instead of a table
    #[arg(long)]
    pub(super) json: bool,
}

const AFTER_HELP: &str = "\
The scenes are those of xtask/benchmark: beads along a spiral over a mirroring floor, the smaller the
more there are, and one light. Each is measured as `cargo xtask measure` does it, with quality fast,
Blinn-Phong shading and 4 reflections, and once more with its spheres listed in random order.

instr/pixel counts the executed instructions of the whole frame over the number of pixels; times is
the quotient to the row above; shuffled is instr/pixel in random order; prepare is the preparation of
the frame alone; flash is what the firmware has beyond the same firmware with an empty frame; seen is
the share of the pixels that show a sphere.

The JSON keys are core, size, members (with spheres, instructions_per_pixel, times, which is null for
the first, shuffled_instructions_per_pixel, prepare_instructions, flash and seen), times (what 256
spheres cost over what 16 spheres cost), shuffled_times (the same in random order) and bar (what
times has to be below).";

impl Arguments {
    /// The core that is asked for.
    pub(super) fn core(&self) -> &'static Core {
        let m3 = Core::find("m3").expect("it is in the list");
        self.core.unwrap_or(m3)
    }

    /// The size that is asked for.
    pub(super) fn size(&self) -> Size {
        self.size.unwrap_or(SIZE)
    }

    /// Whether nothing is asked for but what the page shows.
    pub(super) fn are_defaults(&self) -> bool {
        self.core.is_none() && self.size.is_none() && !self.json
    }
}
