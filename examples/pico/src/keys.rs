//! The five keys, each with its request. Presses are not lost while rows are traced, because the
//! pins remember them.

use core::convert::Infallible;

use embedded_hal::delay::DelayNs;
use embedded_hal::digital::InputPin;

use crate::board::KeyPin;
use crate::board::chip::Timer;
use crate::board::chip::hal::gpio::Interrupt;

/// Action that a key asks for.
#[derive(Clone, Copy)]
pub enum Request {
    /// Orbit the camera: degrees about its `up`, and degrees upwards.
    Orbit(i32, i32),
    /// What the select key stands for: the next scene, or smooth edges.
    Select,
}

/// Degrees by which one press turns the camera.
const STEP: i32 = 10;

/// Longest time in milliseconds for which a contact bounces.
const BOUNCE: u32 = 10;

/// The five keys, each with its request.
pub struct Keys {
    keys: [(Contact, Request); 5],
    timer: Timer,
}

impl Keys {
    /// Creates the keys: the arrow keys orbit the camera.
    pub fn new([up, down, left, right, select]: [KeyPin; 5], timer: Timer) -> Self {
        let keys = [
            (Contact::new(up), Request::Orbit(0, STEP)),
            (Contact::new(down), Request::Orbit(0, -STEP)),
            (Contact::new(left), Request::Orbit(-STEP, 0)),
            (Contact::new(right), Request::Orbit(STEP, 0)),
            (Contact::new(select), Request::Select),
        ];
        Self { keys, timer }
    }

    /// Returns the request of a key that was pressed since the last call.
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

    /// Returns the request of a key that is held down.
    pub fn held(&mut self) -> Option<Request> {
        let mut keys = self.keys.iter_mut();
        keys.find_map(|(contact, request)| contact.is_held().then_some(*request))
    }

    /// Waits until a key is pressed, and returns its request.
    pub fn wait(&mut self) -> Request {
        loop {
            if let Some(request) = self.pressed() {
                return request;
            }
        }
    }
}

/// The contact of one key.
struct Contact {
    pin: KeyPin,
    was_held: bool,
}

impl Contact {
    fn new(mut pin: KeyPin) -> Self {
        // The interrupt is enabled only so that the pin remembers a press; the core never handles
        // it.
        pin.set_interrupt_enabled(Interrupt::EdgeLow, true);
        pin.clear_interrupt(Interrupt::EdgeLow);
        Self {
            pin,
            was_held: false,
        }
    }

    /// Tests whether the contact closed since the last call of [`Self::was_pressed`].
    fn has_closed(&self) -> bool {
        self.pin.interrupt_status(Interrupt::EdgeLow)
    }

    /// Tests whether the contact closed since the last call and was open at that call: a release
    /// bounces, too.
    fn was_pressed(&mut self) -> bool {
        let has_closed = self.has_closed();
        if has_closed {
            self.pin.clear_interrupt(Interrupt::EdgeLow);
        }
        let was_held = self.was_held;
        // A contact that closes only now is not held yet: its press belongs to the next call.
        self.was_held = self.is_held() && (has_closed || was_held);
        has_closed && !was_held
    }

    fn is_held(&mut self) -> bool {
        let Ok::<bool, Infallible>(is_held) = self.pin.is_low();
        is_held
    }
}
