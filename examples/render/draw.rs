//! Draws with the same calls as on a board: a frame, its settings, rows into a display.

use std::sync::atomic::{AtomicU64, Ordering};

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::scenes::{BuiltIn, Visitor};
use reflet::{Camera, FrameBuilder, Report};
use reflet::__private::Drawable;
use reflet::quality::{Exact, Fine, Small};
use reflet::shading::{BlinnPhong, Normals, Phong};

use command_line::{Kind, Source};
use command_line::{Quality, Shading};

/// Settings of a picture: reflections, shading and quality.
#[derive(Clone, Copy)]
pub struct Settings {
    pub reflections: u8,
    pub shading: Shading,
    pub quality: Quality,
}

/// Draws a whole picture into a display and counts the drawn rows.
pub struct Draw<'a> {
    pub camera: &'a Camera,
    pub settings: Settings,
    pub display: &'a mut SimulatorDisplay<Rgb888>,
    pub rows: &'a AtomicU64,
}

impl Draw<'_> {
    /// Draws a scene in fixed point.
    pub fn scene(self, source: &Source) -> Report {
        match &source.kind {
            Kind::BuiltIn => source.visit(self),
            Kind::File(_, scene) => {
                let frame = scene.frame(self.camera);
                self.frame(frame)
            }
        }
    }

    fn frame<W: World + Copy>(self, frame: Frame<'_, W>) -> Report {
        let Self {
            settings,
            display,
            rows,
            ..
        } = self;
        let frame = frame.reflections(settings.reflections);
        match settings.quality {
            Quality::Fast => shaded(frame, settings.shading, display, rows),
            Quality::Fine => shaded(frame.quality::<Fine>(), settings.shading, display, rows),
            Quality::Small => shaded(frame.quality::<Small>(), settings.shading, display, rows),
            Quality::Exact => shaded(frame.quality::<Exact>(), settings.shading, display, rows),
        }
    }
}

impl Visitor for Draw<'_> {
    type Output = Report;

    fn visit<S: BuiltIn>(self) -> Report {
        let frame = S::frame(self.camera);
        self.frame(frame)
    }
}

fn shaded<W: World + Copy, Q: reflet::Quality>(
    frame: Frame<'_, W, Q>,
    shading: Shading,
    display: &mut SimulatorDisplay<Rgb888>,
    rows: &AtomicU64,
) -> Report {
    match shading {
        Shading::BlinnPhong => by_rows(frame.shading::<BlinnPhong>(), display, rows),
        Shading::Phong => by_rows(frame.shading::<Phong>(), display, rows),
        Shading::Normals => by_rows(frame.shading::<Normals>(), display, rows),
    }
}

fn by_rows<W: World + Copy, Q: reflet::Quality, K: reflet::Shading>(
    frame: Frame<'_, W, Q, K>,
    display: &mut SimulatorDisplay<Rgb888>,
    rows: &AtomicU64,
) -> Report {
    let picture = frame.sized(display.size());
    let Size { width, height } = picture.size();
    let row = |y| Rectangle::new(Point::new(0, y), Size::new(width, 1));
    (0..height as i32).fold(Report::NONE, |report, y| {
        let Ok(of_row) = picture.draw_area(row(y), Point::zero(), display);
        rows.fetch_add(1, Ordering::Relaxed);
        report.merge(of_row)
    })
}
