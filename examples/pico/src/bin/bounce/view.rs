//! The view: what moves, and how finely it is drawn.

use core::ops::Range;

use embedded_graphics::geometry::Size;
use reflet::MovingScene;
use reflet::budget::ParetoFront;

use crate::cores::Rows;
use crate::motion::{Bounce, Motion, areas};
use crate::screen::{Line, SIDE};

/// A picture: where everything is, and the settings with which it is drawn.
#[derive(Clone, Copy, PartialEq)]
pub struct View {
    motion: Motion,
    reflections: u8,
    scale: u32,
}

impl View {
    /// Chooses the best settings with which a frame takes at most so many instructions.
    pub fn new(motion: Motion, front: &ParetoFront, instructions: u64) -> Self {
        let point = front.choose(Size::new_equal(SIDE), instructions).point;
        Self {
            motion,
            reflections: point.reflections,
            scale: point.scale.into(),
        }
    }

    /// Prepares the picture and calls `work` with its rows.
    pub fn with_rows<R>(&self, work: impl FnOnce(&dyn Rows) -> R) -> R {
        let Self {
            reflections, scale, ..
        } = *self;
        self.motion.with_rows(reflections, scale, |rows| work(rows))
    }

    /// Returns the areas of the picture in their order.
    pub fn areas(&self) -> impl Iterator<Item = Range<u32>> + use<> {
        areas(self.scale)
    }
}

impl Rows for reflet::Rows<'_, MovingScene<Bounce>> {
    fn row(&self, y: u32, line: &mut Line) {
        let scale = SIDE / self.size().width;
        line.fill(scale, |colors| {
            self.row(y / scale, 0, colors);
        });
    }
}
