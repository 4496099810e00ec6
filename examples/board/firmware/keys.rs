//! The five keys of the board. Each press becomes one request.

use embedded_hal::digital::InputPin;

use super::lm3s::{self, Button};

/// Degrees by which an arrow key turns the camera.
const STEP: i32 = 10;

/// Longest time in milliseconds for which a contact bounces.
const BOUNCE: u32 = 10;

/// Action that a key asks for.
#[derive(Clone, Copy)]
pub enum Request {
    /// Orbit the camera: degrees about its `up`, and degrees upwards.
    Orbit(i32, i32),
    /// Show the next scene.
    NextScene,
}

/// The five keys, each with its request.
pub struct Keys([(Button, Request); 5]);

impl Keys {
    /// Creates the keys: the arrow keys orbit the camera, the select key asks for the next scene.
    pub fn new([left, right, up, down, select]: [Button; 5]) -> Self {
        Self([
            (left, Request::Orbit(-STEP, 0)),
            (right, Request::Orbit(STEP, 0)),
            (up, Request::Orbit(0, STEP)),
            (down, Request::Orbit(0, -STEP)),
            (select, Request::NextScene),
        ])
    }

    /// Returns the request of a key that was pressed and released since the last call.
    ///
    /// A press counts at its release, because QEMU's ports report a key as pressed until it is
    /// released once.
    pub fn pressed(&mut self) -> Option<Request> {
        let mut keys = self.0.iter_mut();
        let (button, request) =
            keys.find_map(|(button, request)| button.has_risen().then_some((button, *request)))?;
        lm3s::delay(BOUNCE);
        // A key also bounces when it goes down, but then it stays down.
        let is_up = button.is_high() == Ok(true);
        button.has_risen();
        is_up.then_some(request)
    }

    /// Sleeps until a key is pressed and released.
    pub fn wait(&mut self) -> Request {
        loop {
            match self.pressed() {
                Some(request) => return request,
                None => lm3s::sleep(),
            }
        }
    }
}
