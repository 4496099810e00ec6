//! The five keys as what they ask for. A press is caught even while rows are worked out: the pins
//! remember it.

use core::convert::Infallible;
use core::mem::replace;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::InputPin;
use rp2040_hal::Timer;
use rp2040_hal::gpio::{DynPinId, FunctionSioInput, Interrupt, Pin, PullUp};

/// What a key asks for.
#[derive(Clone, Copy)]
pub enum Request {
    /// Another view: degrees about the camera's `up`, and degrees upwards.
    Orbit(i32, i32),
    /// The next scene.
    NextScene,
}

/// A pin that a key connects to ground.
pub type KeyPin = Pin<DynPinId, FunctionSioInput, PullUp>;

/// How far one press turns the camera, in degrees.
const STEP: i32 = 10;

/// How long a contact bounces at most, in milliseconds.
const BOUNCE: u32 = 10;

/// All the keys and what they ask for.
pub struct Keys {
    keys: [(Contact, Request); 5],
    timer: Timer,
}

impl Keys {
    /// The arrow keys orbit the camera, the select key asks for the next scene.
    pub fn new([up, down, left, right, select]: [KeyPin; 5], timer: Timer) -> Self {
        let keys = [
            (Contact::new(up), Request::Orbit(0, STEP)),
            (Contact::new(down), Request::Orbit(0, -STEP)),
            (Contact::new(left), Request::Orbit(-STEP, 0)),
            (Contact::new(right), Request::Orbit(STEP, 0)),
            (Contact::new(select), Request::NextScene),
        ];
        Self { keys, timer }
    }

    /// What a key asks for that was pressed since the last call.
    pub fn pressed(&mut self) -> Option<Request> {
        if self.keys.iter().any(|(contact, _)| contact.has_closed()) {
            self.timer.delay_ms(BOUNCE);
        }
        let mut pressed = None;
        for (contact, request) in &mut self.keys {
            if contact.was_pressed() {
                pressed = Some(*request);
            }
        }
        pressed
    }

    /// Waits for a key.
    pub fn wait(&mut self) -> Request {
        loop {
            if let Some(request) = self.pressed() {
                return request;
            }
        }
    }
}

/// One key's contact.
struct Contact {
    pin: KeyPin,
    is_held: bool,
}

impl Contact {
    fn new(mut pin: KeyPin) -> Self {
        // The pin's interrupt is enabled for its memory alone: the core never takes it.
        pin.set_interrupt_enabled(Interrupt::EdgeLow, true);
        pin.clear_interrupt(Interrupt::EdgeLow);
        Self {
            pin,
            is_held: false,
        }
    }

    /// Whether it closed since the last call of [`Self::was_pressed`].
    fn has_closed(&self) -> bool {
        self.pin.interrupt_status(Interrupt::EdgeLow)
    }

    /// Whether it closed since the last call and was open then: letting go bounces, too.
    fn was_pressed(&mut self) -> bool {
        let has_closed = self.has_closed();
        self.pin.clear_interrupt(Interrupt::EdgeLow);
        let Ok::<bool, Infallible>(is_held) = self.pin.is_low();
        let was_held = replace(&mut self.is_held, is_held);
        has_closed && !was_held
    }
}
