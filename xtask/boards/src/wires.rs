//! The wires between the chip and the panel: tests the pins at both ends whenever a byte is sent.

use crate::fault::{Fault, require};
use crate::panel::Panel;

/// Highest clock of the panel in Hz: a period of 16 ns.
const HIGHEST_CLOCK: u64 = 62_500_000;

/// Pin of a chip, counted as the chip counts them. A port of 16 pins on an STM32 is 16 numbers.
pub type Pin = u8;

/// The ground, as a pin that is always low.
pub const GROUND: Pin = Pin::MAX;

/// What a pin does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    Input,
    Output(bool),
    Clock {
        unit: usize,
    },
    Data {
        unit: usize,
    },
    /// Not connected to anything inside of the chip.
    Idle,
}

/// The pins of a chip, as the firmware has set them.
pub trait Pins {
    fn role(&self, pin: Pin) -> Role;
    fn name(&self, pin: Pin) -> String;
}

/// A byte that an SPI unit sends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sent {
    pub byte: u8,
    pub unit: usize,
    /// Clock of the SPI in Hz.
    pub clock: u64,
}

/// Pins of the chip to which the panel is wired.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wiring {
    pub clock: Pin,
    pub data: Pin,
    pub data_command: Pin,
    pub chip_select: Pin,
    pub reset: Pin,
    pub backlight: Pin,
}

pub struct Wires {
    pub panel: Panel,
    wiring: Wiring,
    /// Levels of D/C and CS when the pins changed last.
    levels: [Role; 2],
    was_selected: bool,
    was_released: bool,
    is_lit: bool,
}

impl Wires {
    pub fn new(wiring: Wiring) -> Self {
        Self {
            panel: Panel::new(),
            wiring,
            levels: [Role::Idle; 2],
            was_selected: false,
            was_released: false,
            is_lit: false,
        }
    }

    /// Whether the backlight is on.
    pub fn is_lit(&self) -> bool {
        self.is_lit
    }

    /// Notices that pins may have changed. `is_sending` tells whether the SPI is busy.
    pub fn change(&mut self, pins: &dyn Pins, is_sending: bool) -> Result<(), Fault> {
        let it = self.wiring;
        let levels = [it.data_command, it.chip_select].map(|pin| role(pins, pin));
        require!(
            levels == self.levels || !is_sending,
            "D/C or CS changes while the SPI is sending"
        );
        let [_, select] = levels;
        self.was_released |= self.was_selected && select == Role::Output(true);
        self.was_selected |= select == Role::Output(false);
        self.levels = levels;
        if role(pins, it.reset) == Role::Output(false) {
            self.panel.reset();
        }
        self.is_lit = role(pins, it.backlight) == Role::Output(true);
        Ok(())
    }

    /// Passes a byte to the panel. `time` is in microseconds.
    pub fn pass(&mut self, pins: &dyn Pins, sent: Sent, time: u64) -> Result<(), Fault> {
        let it = self.wiring;
        let unit = sent.unit;
        let named = |part, pin: Pin| {
            let name = pins.name(pin);
            format!(
                "the panel's {part} is wired to {name}, which is {:?}",
                role(pins, pin)
            )
        };
        let (clock, data) = (Role::Clock { unit }, Role::Data { unit });
        let (low, high) = (Role::Output(false), Role::Output(true));
        let is_low = "an output that is low while a byte is sent";
        for (part, pin, wanted, purpose) in [
            ("clock", it.clock, clock, "the clock of the SPI"),
            ("data", it.data, data, "the data of the SPI"),
            ("reset", it.reset, high, "an output that is high"),
            ("CS", it.chip_select, low, is_low),
        ] {
            require!(
                role(pins, pin) == wanted,
                "{}, not {purpose}",
                named(part, pin)
            );
        }
        let Role::Output(is_data) = role(pins, it.data_command) else {
            return Err(Fault(named("D/C", it.data_command) + ", not an output"));
        };
        require!(
            sent.clock <= HIGHEST_CLOCK,
            "the SPI sends at {} Hz, and the panel takes {HIGHEST_CLOCK} Hz",
            sent.clock
        );
        self.panel.take(sent.byte, is_data, time)?;
        let risen = self.was_released || !self.panel.is_writing();
        require!(risen, "CS has never risen before the first pixels");
        Ok(())
    }
}

/// Returns what a pin does. The ground is a pin that is low.
fn role(pins: &dyn Pins, pin: Pin) -> Role {
    match pin {
        GROUND => Role::Output(false),
        _ => pins.role(pin),
    }
}
