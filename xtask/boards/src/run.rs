//! What a run is asked for, and what it gives.

use crate::chip::bus_time::BusTime;
use crate::keys::Key;
use crate::panel::SIDE;

/// The pictures to wait for, and the options of a run.
#[derive(Clone, Debug)]
pub struct Script {
    pub(crate) pictures: Vec<Vec<Key>>,
    pub(crate) cores: usize,
    pub(crate) rows: usize,
    pub(crate) seconds: u64,
    /// Microseconds without a new row after which a picture is captured, and after which the last is.
    pub(crate) pauses: [u64; 2],
}

/// The firmware may draw a picture in two passes, and report it.
const PAUSE: u64 = 100_000;

impl Default for Script {
    /// No picture yet, all cores, 60 seconds at most.
    fn default() -> Self {
        Self {
            pictures: vec![],
            cores: 2,
            rows: SIDE,
            seconds: 60,
            pauses: [PAUSE; 2],
        }
    }
}

impl Script {
    /// Waits for one more picture after these keys have been pressed one after another. The keys of
    /// the first picture are pressed while that picture is drawn.
    pub fn picture(mut self, keys: &[Key]) -> Self {
        self.pictures.push(keys.to_vec());
        self
    }

    /// The second core does not answer.
    pub fn with_one_core(self) -> Self {
        Self { cores: 1, ..self }
    }

    /// Captures each picture as soon as this many of its rows are drawn, counted from the top.
    pub fn rows(self, rows: usize) -> Self {
        let pauses = [0; 2];
        Self {
            rows,
            pauses,
            ..self
        }
    }

    /// Captures each picture but the last with its last row: frames follow one another without a pause.
    pub fn frames(self) -> Self {
        let pauses = [0, PAUSE];
        Self { pauses, ..self }
    }

    /// Sets the limit of the run in seconds of the board. A firmware that reaches it has failed.
    pub fn limit(self, seconds: u64) -> Self {
        Self { seconds, ..self }
    }
}

#[derive(Clone, Debug)]
pub struct Picture {
    /// Pixels in RGB565, row by row from the top.
    pub pixels: Vec<u16>,
    /// Cycles from the reset to the last pixel.
    pub cycles: u64,
    /// Instructions of all cores from the reset to the last pixel.
    pub instructions: u64,
    /// Time of the bus since the first row of the picture was finished.
    pub bus: BusTime,
}

/// The settings of the panel at the end.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Display {
    /// Whether the colours are inverted, as in-plane switching panels need.
    pub inverted: bool,
    /// Direction in which the panel fills its memory: MADCTL in the data sheet.
    pub address_mode: u8,
}

/// What a firmware did.
#[derive(Clone, Debug)]
pub struct Run {
    pub pictures: Vec<Picture>,
    /// Cycles from the reset to the end.
    pub cycles: u64,
    /// Instructions of all cores from the reset to the end.
    pub instructions: u64,
    /// Lines that the firmware printed by RTT.
    pub said: Vec<String>,
    pub display: Display,
}
