//! The library behind the playground: a scene, a view and a frame, for a page that draws row by row.
//!
//! [`Playground`] does the work; it is plain Rust and is tested on any machine. [`exports`] calls it from
//! a browser: numbers go in and out as they are, texts through two buffers.

mod answer;
mod display;
pub mod exports;
mod frame;
mod lines;
mod opened;
mod settings;

pub use answer::Answer;
pub use settings::Settings;

use frame::Frame;
use opened::Opened;

/// All that a page works with: the scene, and the frame that is drawn of it.
#[derive(Default)]
pub struct Playground {
    opened: Option<Opened>,
    frame: Option<Frame>,
}

impl Playground {
    /// Reads the scene at `index` of a scene file; of an array, a negative index is the first scene. An open
    /// scene stays open if this one is refused.
    pub fn open(&mut self, text: &str, index: i32) -> Answer {
        let opened = match Opened::read(text, index) {
            Ok(opened) => opened,
            Err(refusal) => return Answer::refused(&refusal),
        };
        let answer = Answer::done(&opened.facts());
        (self.opened, self.frame) = (Some(opened), None);
        answer
    }

    /// Sets the view: the file's camera after an orbit by `turn` and `rise`, in thousandths of a degree, with the field
    /// of view times `zoom` / 1000.
    pub fn set_view(&mut self, turn: i32, rise: i32, zoom: u32) -> Answer {
        let Some(opened) = &mut self.opened else {
            return Answer::no_scene();
        };
        match opened.set_view(turn, rise, zoom) {
            Ok(()) => Answer::nothing(),
            Err(error) => Answer::error(error),
        }
    }

    /// Returns the camera of the view.
    pub fn camera(&self) -> Answer {
        match &self.opened {
            Some(opened) => Answer::done(&opened.camera()),
            None => Answer::no_scene(),
        }
    }

    /// Prepares a frame of the scene in its present view.
    pub fn frame(&mut self, settings: Settings) -> Answer {
        let Some(opened) = &self.opened else {
            return Answer::no_scene();
        };
        if let Err(error) = settings.check() {
            return Answer::error(error);
        }
        self.frame = Some(Frame::new(opened, settings));
        Answer::nothing()
    }

    /// Draws row `y` of the frame, and returns its pixels: red, green, blue and 255 each. Returns nothing
    /// without a frame or beyond its last row.
    pub fn row(&mut self, y: u32) -> &[u8] {
        match (&self.opened, &mut self.frame) {
            (Some(opened), Some(frame)) => frame.row(opened, y),
            _ => &[],
        }
    }

    /// Returns what the rows have told: rays, the light that is missing, and the hash of the picture.
    pub fn finish(&self) -> Answer {
        match (&self.opened, &self.frame) {
            (Some(opened), Some(frame)) => Answer::done(&frame.told(opened)),
            _ => Answer::no_frame(),
        }
    }
}

#[cfg(test)]
mod tests;
