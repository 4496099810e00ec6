//! Presses keys one after another, as a person would, in the board's emulated time.

use std::collections::VecDeque;

use crate::chip::Chip;
use crate::wires::Pin;

/// Time in microseconds for which a key is held, and of the pause after it.
const HELD: u64 = 100_000;

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    Up,
    Down,
    Left,
    Right,
    Select,
}

/// The presses that are to come.
#[derive(Default)]
pub struct Presses {
    pins: VecDeque<Pin>,
    held: Option<Pin>,
    /// Time in microseconds of the next change.
    next: u64,
}

impl Presses {
    /// Adds the press of a key, which connects this pin to ground.
    pub fn add(&mut self, pin: Pin) {
        self.pins.push_back(pin);
    }

    pub fn are_finished(&self) -> bool {
        self.pins.is_empty() && self.held.is_none()
    }

    /// Presses no key before a pause has passed from this time on, in microseconds.
    pub fn wait(&mut self, time: u64) {
        self.next = time + HELD;
    }

    /// Presses and releases keys at a time in microseconds. Returns whether a key was pressed.
    pub fn advance(&mut self, chip: &mut dyn Chip, time: u64) -> bool {
        if time < self.next || self.are_finished() {
            return false;
        }
        self.next = time + HELD;
        if let Some(pin) = self.held.take() {
            chip.set_input(pin, true);
            return false;
        }
        self.held = self.pins.pop_front();
        if let Some(pin) = self.held {
            chip.set_input(pin, false);
        }
        true
    }
}
