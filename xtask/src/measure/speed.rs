//! Estimates the frames a second that a board draws, from the counted instructions of each row.
//!
//! Each core traces every second row if there are two, so the slower half counts. The time to send the frame
//! is added, because a display's driver waits until a row is sent. Flash that is slower than RAM is not counted.

use anyhow::Result;
use clap::Args;
use command_line::{json_line, one_line};
use serde_json::json;

use super::figures::per_pixel;
use super::outcome::Outcome;
use super::task::Task;
use super::{Size, estimate, outcome, pixels, small, weight, words};
use crate::table::rounded;
use crate::{cycles::Timing, misuse::Misuse, owned::Owned};

/// Bits of a pixel on the bus: RGB565.
const BITS: f64 = 16.0;

/// Size of the boards' displays.
pub(super) const SIZE: Size = Size::new(240, 240);

/// One of the boards that people own, or the clock, the cores and the bus of another one.
#[derive(Args, Clone, Copy, Debug)]
pub struct Board {
    /// Estimate frames a second on this board, at 240x240 unless --size is given
    #[arg(long, value_name = "NAME", value_parser = Owned::parser())]
    #[arg(conflicts_with_all = ["clock", "core", "moving", "all", "profiles", "frames", "yardstick", "units"])]
    pub(super) board: Option<&'static Owned>,

    /// Estimate frames a second at this clock of the core, at 240x240 unless --size is given
    #[arg(long, value_name = "MHZ", value_parser = megahertz)]
    #[arg(conflicts_with_all = ["moving", "all", "profiles"])]
    pub(super) clock: Option<f64>,

    /// Cores that trace rows by turns, 1 or 2
    #[arg(long, requires = "clock", conflicts_with = "board")]
    #[arg(default_value_t = 1, value_parser = clap::value_parser!(u8).range(1..=2))]
    cores: u8,

    /// Add the time of 16 bits a pixel on the display's bus
    #[arg(long, requires = "clock", conflicts_with = "board")]
    #[arg(value_name = "MHZ", value_parser = megahertz)]
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
    /// All pixels on their way to the display.
    pub sending: f64,
    /// The part of it in which the next rows can be traced.
    pub hidden: f64,
}

impl Board {
    /// One of the boards that people own.
    pub fn of(board: &'static Owned) -> Self {
        Self {
            board: Some(board),
            clock: None,
            cores: 1,
            bus: None,
        }
    }

    /// Tests whether a board or a clock is given. If not, nothing is estimated.
    pub(super) fn is_given(&self) -> bool {
        self.board.is_some() || self.clock.is_some()
    }

    fn megahertz(&self) -> f64 {
        let clock = self.board.map(|it| it.board.clock() as f64 / 1e6);
        clock.or(self.clock).unwrap_or(1.0)
    }

    fn cores(&self) -> u8 {
        self.board.map_or(self.cores, |it| it.cores)
    }

    /// Returns the seconds in which a number of pixels is sent.
    fn sending(&self, pixels: u64) -> f64 {
        let pixels = pixels as f64;
        match self.board {
            Some(board) => 1e-3 * board.sending * pixels / self::pixels(SIZE) as f64,
            None => self.bus.map_or(0.0, |bus| BITS * pixels / (1e6 * bus)),
        }
    }

    /// Estimates the time of a frame on this board from the instructions that were counted for the task.
    ///
    /// # Errors
    /// [`Misuse`] if no timings are published for the core.
    pub fn speed(&self, task: &Task, outcome: &Outcome) -> Result<Speed> {
        let estimate = estimate(&small(task, per_pixel(task, outcome)))?;
        let estimate = estimate.ok_or_else(|| {
            let title = task.core.title;
            Misuse::new(format!(
                "no timings of instructions are published for the {title}"
            ))
        })?;
        let cycles = self.instructions(outcome) as f64 * estimate.per_instruction();
        let sending = self.sending(pixels(task.settings.size));
        let share = self.board.map_or(0.0, |it| it.hidden / it.sending);
        Ok(Speed {
            tracing: cycles / (1e6 * self.megahertz()),
            hidden: share * sending,
            sending,
        })
    }

    /// Returns the instructions of the core that takes the most.
    fn instructions(&self, outcome: &Outcome) -> u64 {
        if self.cores() == 1 {
            return outcome.instructions();
        }
        outcome.prepare + outcome.halves[0].max(outcome.halves[1])
    }

    /// Returns the estimate in words, or as a line of JSON.
    pub(super) fn report(&self, task: &Task, is_json: bool) -> Result<String> {
        let outcome = outcome(task)?;
        let (speed, stack) = (self.speed(task, &outcome)?, outcome.stack);
        let flash = weight(task)?.flash;
        let (scene, core) = (task.scene.name(), task.core);
        let size = words(task.settings.size);
        let quality = task.settings.quality.name();
        let clock = self.megahertz();
        if is_json {
            let line = json!({
                "core": core.name, "scene": scene, "size": size, "quality": quality,
                "board": self.board.map(|board| board.name), "clock": clock, "cores": self.cores(),
                "bus": self.bus, "flash": flash, "stack": stack,
                "frames_per_second": rounded(1.0 / speed.frame(), 2),
                "tracing_ms": rounded(1e3 * speed.tracing, 2), "sending_ms": rounded(1e3 * speed.sending, 2),
            });
            return Ok(json_line(&line.to_string()));
        }
        let board = self.board.map(|board| format!("{}, ", board.title));
        let cores = match self.cores() {
            1 => "one core",
            _ => "two cores, the slower of even and odd rows",
        };
        let sent = match (self.board, self.bus) {
            (Some(_), _) => "to send a frame".to_owned(),
            (None, Some(bus)) => format!("on the bus at {bus} MHz"),
            (None, None) => "on no bus (--bus MHZ)".to_owned(),
        };
        Ok(format!(
            "{}, {size}, {quality}: estimated {:.2} frames a second\n\
             {}{}, {clock} MHz, {cores}: {:.1} ms, and {:.1} ms {sent}\n\
             Flash {flash} bytes, stack {stack} bytes on each core: the library and the scene, without what the display takes\n\
             Instructions are counted; their cycles are those that {}. Flash that is slower than RAM is \
             not counted.",
            one_line(scene),
            1.0 / speed.frame(),
            board.unwrap_or_default(),
            core.title,
            1e3 * speed.tracing,
            1e3 * speed.sending,
            core.timing.map_or("nobody publishes", Timing::source),
        ))
    }
}

impl Speed {
    pub fn frame(self) -> f64 {
        self.sending - self.hidden + self.tracing.max(self.hidden)
    }
}
