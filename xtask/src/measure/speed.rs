//! Estimates the frames a second that a board draws, from the counted instructions of each row.
//!
//! Each core traces every second row if there are two, so the slower half counts. The bus is added,
//! because a display's driver waits until a row is sent. Flash that is slower than RAM is not counted.

use anyhow::Result;
use clap::Args;
use command_line::{json_line, one_line};
use serde_json::json;

use super::outcome::Outcome;
use super::task::Task;
use super::{Figures, estimate, outcome, small};
use crate::misuse::Misuse;

/// Bits of a pixel on the bus: RGB565.
const BITS: f64 = 16.0;

/// A board: its clock, its cores and the bus of its display.
#[derive(Args, Clone, Copy, Debug)]
pub struct Board {
    /// Estimate frames a second at this clock of the core, at 240x240 unless --size is given
    #[arg(long, value_name = "MHZ", value_parser = megahertz)]
    #[arg(conflicts_with_all = ["moving", "all", "profiles"])]
    pub(super) clock: Option<f64>,

    /// Cores that trace rows by turns, 1 or 2
    #[arg(long, requires = "clock", default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=2))]
    cores: u8,

    /// Add the time of 16 bits a pixel on the display's bus
    #[arg(long, requires = "clock", value_name = "MHZ", value_parser = megahertz)]
    bus: Option<f64>,
}

fn megahertz(text: &str) -> Result<f64, &'static str> {
    let number = text.parse().ok();
    let number = number.filter(|it: &f64| (0.001..=100_000.0).contains(it));
    number.ok_or("not a number of MHz from 0.001 to 100000")
}

/// Estimated time of a frame in seconds.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Speed {
    /// Preparation, and the rows of the slower core.
    pub tracing: f64,
    /// All pixels on the bus.
    pub bus: f64,
}

impl Board {
    /// A board with a clock in MHz.
    pub fn new(clock: f64, cores: u8) -> Self {
        Self {
            clock: Some(clock),
            cores,
            bus: None,
        }
    }

    /// Measures a task and estimates the time of its frame on this board.
    ///
    /// # Errors
    /// [`Misuse`] if no timings are published for the core.
    pub fn speed(&self, task: &Task) -> Result<Speed> {
        let outcome = outcome(task)?;
        let estimate = estimate(&small(task, &Figures::new(task, &outcome)))?;
        let estimate = estimate.ok_or_else(|| {
            let title = task.core.title;
            Misuse::new(format!(
                "no timings of instructions are published for the {title}"
            ))
        })?;
        let hertz = 1e6 * self.clock.unwrap_or(1.0);
        let cycles = self.instructions(&outcome) as f64 * estimate.per_instruction();
        let bits = BITS * task.settings.size.pixels() as f64;
        Ok(Speed {
            tracing: cycles / hertz,
            bus: self.bus.map_or(0.0, |bus| bits / (1e6 * bus)),
        })
    }

    /// Returns the instructions of the core that takes the most.
    fn instructions(&self, outcome: &Outcome) -> u64 {
        let cores = usize::from(self.cores);
        let rows = |first| outcome.rows.iter().skip(first).step_by(cores).sum::<u64>();
        outcome.prepare + (0..cores).map(rows).max().unwrap_or(0)
    }

    /// Returns the estimate in words, or as a line of JSON.
    pub(super) fn report(&self, task: &Task, is_json: bool) -> Result<String> {
        let speed = self.speed(task)?;
        let (scene, size, core) = (task.scene.name(), task.settings.size, task.core);
        let quality = task.settings.quality.name();
        let [clock, bus] = [self.clock, self.bus].map(Option::unwrap_or_default);
        if is_json {
            let line = json!({
                "core": core.name, "scene": scene, "size": size.to_string(), "quality": quality,
                "clock": clock, "cores": self.cores, "bus": self.bus,
                "frames_per_second": rounded(speed.frames_per_second()),
                "tracing_ms": rounded(1e3 * speed.tracing), "bus_ms": rounded(1e3 * speed.bus),
            });
            return Ok(json_line(&line.to_string()));
        }
        let cores = match self.cores {
            1 => "one core".to_owned(),
            _ => "two cores, the slower of even and odd rows".to_owned(),
        };
        let sent = match self.bus {
            Some(_) => format!("{:.1} ms on the bus at {bus} MHz", 1e3 * speed.bus),
            None => "no bus (--bus MHZ)".to_owned(),
        };
        Ok(format!(
            "{}, {size}, {quality}: estimated {:.2} frames a second\n\
             {}, {clock} MHz, {cores}: {:.1} ms, and {sent}\n\
             Instructions are counted; their cycles are published timings. Flash that is slower \
             than RAM is not counted.",
            one_line(scene),
            speed.frames_per_second(),
            core.title,
            1e3 * speed.tracing,
        ))
    }
}

impl Speed {
    pub fn frames_per_second(self) -> f64 {
        1.0 / (self.tracing + self.bus)
    }
}

fn rounded(number: f64) -> f64 {
    (100.0 * number).round() / 100.0
}
