//! Draws a picture in fixed point into a simulated display.

use std::sync::atomic::{AtomicU64, Ordering};

use command_line::{Settings, Source};
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::{Camera, Report};

/// Draws a scene through a camera, and counts the rows that are on the display.
pub fn draw(
    source: &Source,
    camera: &Camera,
    settings: Settings,
    display: &mut SimulatorDisplay<Rgb888>,
    rows: &AtomicU64,
) -> Report {
    let size = display.size();
    source.draw_rows(camera, size, settings, &mut |y, row| {
        let area = Rectangle::new(Point::new(0, y as i32), Size::new(size.width, 1));
        let Ok(()) = display.fill_contiguous(&area, row.iter().copied());
        rows.fetch_add(1, Ordering::Relaxed);
    })
}
