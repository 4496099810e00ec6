//! The view: a camera on the scene, and whether edges are smooth. Knows no board.

use embedded_graphics::geometry::Size;
use reflet::quality::{Quality, Smooth};
use reflet::{Camera, FrameBuilder};

use crate::Shown;
use crate::cores::Rows;
use crate::screen::{Line, SIDE};

/// The camera through which the scene is drawn, and whether edges are smooth.
#[derive(Clone, Copy, PartialEq)]
pub struct View {
    pub camera: Camera,
    pub is_smooth: bool,
}

impl View {
    /// Prepares the picture of the view and calls `work` with its rows.
    pub fn with_rows<R>(&self, work: impl FnOnce(&dyn Rows) -> R) -> R {
        let frame = Shown::frame(&self.camera);
        if cfg!(feature = "smooth") && self.is_smooth {
            with_rows_of(frame.quality::<Smooth<2>>(), work)
        } else {
            with_rows_of(frame, work)
        }
    }
}

/// Prepares a frame and calls `work` with its rows.
fn with_rows_of<Q: Quality, R>(
    frame: FrameBuilder<'_, Shown, Q>,
    work: impl FnOnce(&dyn Rows) -> R,
) -> R {
    let frame = frame.prepare(Size::new(SIDE, SIDE));
    let rows = frame.on(&Shown);
    work(&rows.expect("a constant scene never changes"))
}

impl<Q: Quality> Rows for reflet::Rows<'_, Shown, Q> {
    fn row(&self, y: u32, line: &mut Line) {
        // A seam would not help: consecutive rows are drawn neither in order nor by the same core.
        line.fill(1, |colors| {
            self.row(y, 0, colors);
        });
    }
}
