//! The library behind the playground: a scene, a view and a frame, for a page that draws row by row.
//!
//! [`Playground`] does the work; it is plain Rust and is tested on any machine. [`exports`] calls it from
//! a browser: numbers go in and out as they are, texts through two buffers.

mod accuracy;
mod answer;
pub mod exports;
mod opened;
mod paths;
mod place;
mod projection;
mod told;

pub use answer::Answer;
pub use drawing::Settings;

use answer::{error, json};
use drawing::Frame;
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
        let opened = Opened::read(text, index)?;
        let facts = json(&opened.facts());
        (self.opened, self.frame) = (Some(opened), None);
        Ok(facts)
    }

    /// Sets the view: the file's camera after an orbit by `turn` and `rise`, in thousandths of a degree, with the field
    /// of view times `zoom` / 1000.
    pub fn set_view(&mut self, turn: i32, rise: i32, zoom: u32) -> Answer {
        let opened = self.opened.as_mut().ok_or_else(no_scene)?;
        opened.set_view(turn, rise, zoom).map_err(error)?;
        Ok(String::new())
    }

    pub fn camera(&self) -> Answer {
        Ok(json(&self.scene()?.camera()))
    }

    /// Prepares a frame of the scene in its present view.
    pub fn frame(&mut self, settings: Settings) -> Answer {
        let opened = self.scene()?;
        settings.check().map_err(error)?;
        self.frame = Some(Frame::new(&opened.scene, &opened.view, settings));
        Ok(String::new())
    }

    /// Draws row `y` of the frame, and returns its pixels: red, green, blue and 255 each. Returns no pixels if
    /// there is no frame, or no such row.
    pub fn row(&mut self, y: u32) -> &[u8] {
        match (&self.opened, &mut self.frame) {
            (Some(opened), Some(frame)) => frame.row(&opened.scene, y),
            _ => &[],
        }
    }

    /// Returns what the rows have told: rays, the light that is missing, and the hash of the picture.
    pub fn finish(&self) -> Answer {
        let (opened, frame) = self.both()?;
        Ok(json(&told::of(opened, frame)))
    }

    /// Returns the path of pixel (`x`, `y`) of the frame, as `Exact` computes it.
    pub fn path(&self, x: u32, y: u32) -> Answer {
        let (opened, frame) = self.both()?;
        let path = paths::pixel(opened, &frame.settings, (x, y));
        let path = path.ok_or_else(|| error("the picture has no such pixel"))?;
        Ok(json(&path))
    }

    /// Returns the runs of row `y` of the frame: neighbours whose paths meet the same.
    pub fn row_paths(&self, y: u32) -> Answer {
        let (opened, frame) = self.both()?;
        Ok(json(&paths::row(opened, &frame.settings, y)))
    }

    /// Compares the picture with so many reflections with that of [`accuracy::MANY`], both `Exact`, in the
    /// view, with the frame's shading.
    pub fn error_at(&self, width: u32, height: u32, reflections: u32) -> Answer {
        let opened = self.scene()?;
        let settings = Settings {
            width,
            height,
            reflections,
            quality: 1,
            shading: self.frame.as_ref().map_or(0, |it| it.settings.shading),
            smooth: 1,
            display: 0,
        };
        settings.check().map_err(error)?;
        Ok(json(&accuracy::measured(opened, settings)))
    }

    /// Returns the Rust source of the scene, with the camera of the view.
    pub fn rust(&self) -> Answer {
        let opened = self.scene()?;
        Ok(opened.file.rust_source().camera(&opened.view).text())
    }

    fn scene(&self) -> Result<&Opened, String> {
        self.opened.as_ref().ok_or_else(no_scene)
    }

    fn both(&self) -> Result<(&Opened, &Frame), String> {
        let both = self.opened.as_ref().zip(self.frame.as_ref());
        both.ok_or_else(|| error("there is no frame: prepare one first"))
    }
}

fn no_scene() -> String {
    error("no scene is open: open one first")
}

#[cfg(test)]
mod tests;
