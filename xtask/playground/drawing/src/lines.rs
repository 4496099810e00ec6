//! The rows of a frame in any quality and shading, behind one trait: the library has a type for each.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::Rgb888;
use reflet::host::file::FileScene;
use reflet::quality::{Exact, Fast, Quality};
use reflet::shading::{BlinnPhong, Phong, Shading};
use reflet::{Camera, FrameBuilder, PreparedFrame, Report};

use crate::settings::Settings;

/// A prepared frame, whatever its quality and its shading.
pub trait Lines {
    fn line(&self, scene: &FileScene, y: u32, pixels: &mut [Rgb888]) -> Report;

    /// Returns the most light that is missing in a traced pixel, in levels of 255.
    fn missing_levels(&self, scene: &FileScene, report: &Report) -> f64;
}

/// What the page tells when the scene of a frame has changed.
const UNCHANGED: &str = "an open scene never changes";

impl<Q: Quality, K: Shading> Lines for PreparedFrame<FileScene, Q, K> {
    fn line(&self, scene: &FileScene, y: u32, pixels: &mut [Rgb888]) -> Report {
        self.on(scene).expect(UNCHANGED).row(y, 0, pixels)
    }

    fn missing_levels(&self, scene: &FileScene, report: &Report) -> f64 {
        let rows = self.on(scene).expect(UNCHANGED);
        rows.cut_off_bound(report).to_num::<f64>() * 255.0
    }
}

/// Prepares a frame that is `smooth` times as large as the settings say.
pub fn prepared(scene: &FileScene, camera: &Camera, settings: &Settings) -> Box<dyn Lines> {
    let frame = scene.frame(camera).reflections(settings.reflections());
    let size = Size::new(settings.width, settings.height) * settings.smooth;
    match (settings.quality, settings.shading) {
        (0, 0) => boxed::<Fast, BlinnPhong>(frame, size),
        (0, _) => boxed::<Fast, Phong>(frame, size),
        (_, 0) => boxed::<Exact, BlinnPhong>(frame, size),
        (_, _) => boxed::<Exact, Phong>(frame, size),
    }
}

fn boxed<Q: Quality + 'static, K: Shading + 'static>(
    frame: FrameBuilder<'_, FileScene>,
    size: Size,
) -> Box<dyn Lines> {
    Box::new(frame.quality::<Q>().shading::<K>().prepare(size))
}
