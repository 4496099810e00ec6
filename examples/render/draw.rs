//! Draws with the same calls as on a board: a frame, its settings, rows into a display.

use std::sync::atomic::{AtomicU64, Ordering};

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::__private::Drawable;
use reflet::quality::{self, Draft, Exact, Fast, Fine, Small};
use reflet::scenes::{BuiltIn, Visitor};
use reflet::shading::{self, BlinnPhong, Normals, Phong};
use reflet::{Camera, FrameBuilder, Report};

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
            Kind::File(_, scene) => self.drawn(&**scene),
        }
    }

    fn drawn<S: Drawable>(self, scene: &S) -> Report {
        match self.settings.quality {
            Quality::Draft => self.with_quality::<S, Draft>(scene),
            Quality::Fast => self.with_quality::<S, Fast>(scene),
            Quality::Fine => self.with_quality::<S, Fine>(scene),
            Quality::Small => self.with_quality::<S, Small>(scene),
            Quality::Exact => self.with_quality::<S, Exact>(scene),
        }
    }

    fn with_quality<S: Drawable, Q: quality::Quality>(self, scene: &S) -> Report {
        match self.settings.shading {
            Shading::BlinnPhong => self.by_rows::<S, Q, BlinnPhong>(scene),
            Shading::Phong => self.by_rows::<S, Q, Phong>(scene),
            Shading::Normals => self.by_rows::<S, Q, Normals>(scene),
        }
    }

    fn by_rows<S: Drawable, Q: quality::Quality, K: shading::Shading>(self, scene: &S) -> Report {
        let frame = FrameBuilder::new(scene, self.camera).reflections(self.settings.reflections);
        let frame = frame.quality::<Q>().shading::<K>();
        let prepared = frame.prepare(self.display.size());
        let picture = prepared.on(scene).expect("the scene has not changed");
        let Size { width, height } = picture.size();
        let row = |y| Rectangle::new(Point::new(0, y), Size::new(width, 1));
        (0..height as i32).fold(Report::NONE, |report, y| {
            let Ok(of_row) = picture.draw_area(row(y), Point::zero(), self.display);
            self.rows.fetch_add(1, Ordering::Relaxed);
            report.merge(of_row)
        })
    }
}

impl Visitor for Draw<'_> {
    type Output = Report;

    fn visit<S: BuiltIn>(self) -> Report {
        self.drawn(S::INSTANCE)
    }
}
