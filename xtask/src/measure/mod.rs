//! `cargo xtask measure`: what a scene takes on a core, in instructions and bytes.
//!
//! [`task`] says what is measured, on which of the [`cores`]; [`firmware`] builds it, and `images`
//! keeps what was built; [`outcome`](mod@outcome) runs it;
//! [`figures`] is what comes out, [`record`] keeps it, and [`page`] makes `docs/boards.md` of it.
//! [`profiles`] measures the same code in several build profiles, [`speed`] estimates
//! frames a second, [`frames`] keeps those of boards that people own, [`yardstick`] the
//! figures of scenes after ray tracers that others published, and [`units`] the cost of a ray, a bounce or a pixel.

pub mod arguments;
pub mod build_profile;
pub mod cores;
pub mod figures;
pub(crate) mod firmware;
pub(crate) mod float_source;
pub mod frames;
pub(crate) mod images;
pub mod ledger;
pub mod moving;
mod moving_record;
pub(crate) mod outcome;
mod page;
pub mod profiles;
pub mod record;
pub mod scene;
pub mod speed;
pub mod task;
pub mod units;
pub mod yardstick;

use anyhow::Result;
use command_line::json_line;
pub use embedded_graphics::geometry::Size;

pub use self::cores::{CORES, Core};
pub(crate) use self::firmware::fingerprint;
pub use self::firmware::{RUN_LIMIT, Weight, is_counted, weigh, weight, with_program};
pub use self::images::sources;
pub use self::outcome::{Outcome, run as outcome};
pub use self::task::{Quality, Settings, Shading, Task, pixels, words};
pub use self::{arguments::Arguments, figures::Figures, scene::Scene};
use crate::cycles::{self, Estimate};
use crate::{print, table::rounded};

pub fn run(arguments: &Arguments) -> Result<()> {
    if arguments.frames {
        return frames::renew();
    }
    if arguments.profiles {
        return profiles::renew();
    }
    if arguments.yardstick {
        return yardstick::renew();
    }
    if arguments.units {
        return units::run(arguments.choice.core);
    }
    if arguments.all {
        return record::renew(arguments.choice.core);
    }
    if arguments.moving {
        return moving::run(&arguments.choice.task()?, arguments.json);
    }
    let mut task = arguments.choice.task()?;
    if arguments.board.is_given() {
        let core = arguments.board.board.and_then(|it| Core::find(it.core));
        task.core = core.unwrap_or(task.core);
        return print(arguments.board.report(&task, arguments.json)? + "\n");
    }
    let figures = measure(&task)?;
    let text = if arguments.json {
        json_line(&figures.json()?)
    } else {
        figures::table(&[figures])
    };
    print(text + "\n")
}

pub fn measure(task: &Task) -> Result<Figures> {
    let mut figures = count(task)?;
    if let Some(estimate) = estimate(&small(task, figures.instructions_per_pixel))? {
        let cycles = estimate.per_instruction() * figures.instructions_per_pixel;
        figures.cycles_per_pixel = Some(rounded(cycles, 1));
    }
    Ok(figures)
}

/// Measures one scene on one core, without the estimate of cycles.
pub fn count(task: &Task) -> Result<Figures> {
    Ok(Figures::new(task, &outcome(task)?, weight(task)?))
}

/// Estimates the cycles of a frame on a core whose timings are known. Every instruction is looked
/// at, so the task had better be small.
pub fn estimate(task: &Task) -> Result<Option<Estimate>> {
    let Some(timing) = task.core.timing else {
        return Ok(None);
    };
    firmware::with_program(task, |program| {
        let emulator = task.core.emulator().limit(firmware::RUN_LIMIT);
        cycles::estimate(emulator, program, timing, firmware::is_counted).map(Some)
    })
}

/// The same task with so few pixels that every instruction can be looked at: what one takes on
/// average is much the same.
fn small(task: &Task, instructions_per_pixel: f64) -> Task {
    /// Instructions after which an emulated run takes a second or two.
    const INSTRUCTIONS: f64 = 1e6;
    let side = (INSTRUCTIONS / instructions_per_pixel).sqrt();
    let side = side.clamp(4.0, 16.0) as u32;
    let mut task = task.clone();
    let size = &mut task.settings.size;
    (size.width, size.height) = (size.width.min(side), size.height.min(side));
    task
}
