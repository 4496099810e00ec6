//! The five keys of the board as what they ask for, one press at a time.

use embedded_hal::digital::InputPin;

use super::lm3s::{self, Button};

/// Degrees an arrow key turns the camera by.
const STEP: i32 = 10;

/// How long a contact bounces at most, in milliseconds.
const BOUNCE: u32 = 10;

/// What a key asks for.
#[derive(Clone, Copy)]
pub enum Request {
    /// Another view: degrees about the camera's `up`, and degrees upwards.
    Orbit(i32, i32),
    /// The next scene.
    NextScene,
}

/// All keys and what they ask for.
pub struct Keys([(Button, Request); 5]);

impl Keys {
    /// The arrow keys orbit the camera, the select key asks for the next scene.
    pub fn new([left, right, up, down, select]: [Button; 5]) -> Self {
        Self([
            (left, Request::Orbit(-STEP, 0)),
            (right, Request::Orbit(STEP, 0)),
            (up, Request::Orbit(0, STEP)),
            (down, Request::Orbit(0, -STEP)),
            (select, Request::NextScene),
        ])
    }

    /// What the key asks for that has been pressed and let go since this was last asked.
    ///
    /// It counts when it is let go: QEMU's ports take a key for pressed until it was let go once.
    pub fn pressed(&mut self) -> Option<Request> {
        let mut keys = self.0.iter_mut();
        let (button, request) =
            keys.find_map(|(button, request)| button.has_risen().then_some((button, *request)))?;
        lm3s::delay(BOUNCE);
        // A key that goes down bounces, too, but stays down.
        let is_up = button.is_high() == Ok(true);
        button.has_risen();
        is_up.then_some(request)
    }

    /// Sleeps until a key is pressed.
    pub fn wait(&mut self) -> Request {
        loop {
            match self.pressed() {
                Some(request) => return request,
                None => lm3s::sleep(),
            }
        }
    }
}
