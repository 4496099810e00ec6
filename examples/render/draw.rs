//! Draws with the same calls as on a board: a frame, its settings, rows into a display.

use std::sync::atomic::{AtomicU64, Ordering};

use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::host::file::FileScene;
use reflet::quality::{self, Draft, Exact, Fast, Fine, Small};
use reflet::shading::{self, BlinnPhong, Normals, Phong};
use reflet::{Camera, Report};

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
    pub fn scene(self, scene: &FileScene) -> Report {
        match self.settings.quality {
            Quality::Draft => self.with_quality::<Draft>(scene),
            Quality::Fast => self.with_quality::<Fast>(scene),
            Quality::Fine => self.with_quality::<Fine>(scene),
            Quality::Small => self.with_quality::<Small>(scene),
            Quality::Exact => self.with_quality::<Exact>(scene),
        }
    }

    fn with_quality<Q: quality::Quality>(self, scene: &FileScene) -> Report {
        match self.settings.shading {
            Shading::BlinnPhong => self.by_rows::<Q, BlinnPhong>(scene),
            Shading::Phong => self.by_rows::<Q, Phong>(scene),
            Shading::Normals => self.by_rows::<Q, Normals>(scene),
        }
    }

    fn by_rows<Q: quality::Quality, K: shading::Shading>(self, scene: &FileScene) -> Report {
        let frame = scene
            .frame(self.camera)
            .reflections(self.settings.reflections);
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
