//! The view: a camera on the scene. Knows no board.

use embedded_graphics::geometry::Size;
use reflet::Camera;

use crate::Shown;
use crate::cores::Rows;
use crate::screen::{Line, SIDE};

/// The camera through which the scene is drawn.
#[derive(Clone, Copy, PartialEq)]
pub struct View {
    pub camera: Camera,
}

impl View {
    /// Prepares the picture of the view and calls `work` with its rows.
    pub fn with_rows<R>(&self, work: impl FnOnce(&dyn Rows) -> R) -> R {
        let frame = Shown::frame(&self.camera).prepare(Size::new(SIDE, SIDE));
        let rows = frame.on(&Shown);
        work(&rows.expect("a constant scene never changes"))
    }
}

impl Rows for reflet::Rows<'_, Shown> {
    fn row(&self, y: u32, line: &mut Line) {
        line.fill(1, |colors| {
            self.row(y, 0, colors);
        });
    }
}
