//! The two FIFOs between the cores, and the boot ROM of the second core behind them.

use std::collections::VecDeque;

use crate::chip::Effect;
use crate::fault::{Fault, fault, require};

/// Words in each FIFO: 8 on an RP2040 and 4 on an RP2350; the smaller holds for both.
const DEPTH: usize = 4;

/// The FIFOs, named after the core that reads them.
pub struct Fifos {
    words: [VecDeque<u32>; 2],
    /// Whether there is a second core.
    is_there: bool,
    /// What the boot ROM of the second core has got: 0, 0, 1, vector table, stack, entry.
    asked: Vec<u32>,
    is_started: bool,
}

impl Fifos {
    /// Creates empty FIFOs between one or two cores.
    pub fn new(cores: usize) -> Self {
        Self {
            words: Default::default(),
            is_there: cores > 1,
            asked: vec![],
            is_started: false,
        }
    }

    /// The second core is switched off.
    pub fn reset(&mut self) {
        self.words[1].clear();
        self.asked.clear();
        self.is_started = false;
    }

    /// The second core is switched on: its boot ROM sends a 0.
    pub fn greet(&mut self) {
        if self.is_there {
            self.words[0].push_back(0);
        }
    }

    /// FIFO_ST: whether there is a word to read and room to write.
    pub fn status(&self, core: usize) -> u32 {
        let [there, room] = [!self.words[core].is_empty(), self.has_room(1 - core)];
        u32::from(there) | u32::from(room) << 1
    }

    fn has_room(&self, to: usize) -> bool {
        self.words[to].len() < DEPTH
    }

    /// FIFO_RD. An empty FIFO gives 0: the firmware may drain it so.
    pub fn receive(&mut self, core: usize) -> u32 {
        self.words[core].pop_front().unwrap_or(0)
    }

    /// FIFO_WR.
    pub fn send(&mut self, core: usize, word: u32) -> Result<Effect, Fault> {
        if core == 1 || self.is_started {
            require!(
                self.has_room(1 - core),
                "the FIFO to the other core is full"
            );
            self.words[1 - core].push_back(word);
            return Ok(Effect::Wake(1 - core));
        }
        if !self.is_there {
            return Ok(Effect::None);
        }
        self.boot(word)
    }

    /// The boot ROM takes a word and sends it back.
    fn boot(&mut self, word: u32) -> Result<Effect, Fault> {
        self.words[0].push_back(word);
        match (self.asked.len(), word) {
            (0 | 1, 0) | (2, 1) | (3.., _) => self.asked.push(word),
            (_, 0) => self.asked = vec![0],
            _ => return Err(fault!("the second core's boot ROM got {word:#x}")),
        }
        let [_, _, _, vectors, stack, entry] = self.asked[..] else {
            return Ok(Effect::Wake(0));
        };
        self.is_started = true;
        Ok(Effect::Start([vectors, stack, entry]))
    }
}
