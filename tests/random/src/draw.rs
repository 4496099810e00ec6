//! Draws the pictures of a random scene and checks what must hold for each.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::RgbColor;
use reflet::display::AnyScene;
use reflet::quality::{Exact, Fast, Quality, Small};
use reflet::shading::{BlinnPhong, Normals, Phong, Shading, Unshadowed};
use reflet::{FrameBuilder, Report, Unit};

use crate::Wild;

impl Wild {
    /// Draws the scene, and returns the number of followed rays, without shadow rays. `None` if the library
    /// refuses the scene as a whole.
    ///
    /// # Panics
    ///
    /// Panics if a row takes more rays than it may, or if a path was cut off in a scene without
    /// mirrors.
    pub fn draw(&self) -> Option<u64> {
        let built = self.scene.build().ok()?;
        let frame = built.frame(&self.camera).reflections(self.reflections);
        Some(match self.kind % 7 {
            0 => self.paint(&built, frame.quality::<Fast>()),
            1 => self.paint(&built, frame.shading::<Phong>()),
            2 => self.paint(&built, frame.shading::<Normals>()),
            3 => self.paint(&built, frame.shading::<Phong>().quality::<Exact>()),
            4 => self.paint(&built, frame.shading::<BlinnPhong>().quality::<Exact>()),
            5 => self.paint(&built, frame.quality::<Small>()),
            _ => self.paint(&built, frame.shading::<Unshadowed<BlinnPhong>>()),
        })
    }

    fn paint<S: AnyScene, Q: Quality, K: Shading>(
        &self,
        scene: &S,
        frame: FrameBuilder<'_, S, Q, K>,
    ) -> u64 {
        let prepared = frame.prepare(self.size);
        let picture = prepared.on(scene).unwrap();
        let (width, height) = (self.size.width, self.size.height);
        let mut row = vec![Rgb888::BLACK; width as usize];
        let mut report = Report::NONE;
        // Nothing beside the picture is traced.
        let most = u64::from(width) * (u64::from(self.reflections) + 1);
        for y in 0..height {
            let of_row = picture.row(y, 0, &mut row);
            assert!(of_row.rays <= most, "{} rays, {most} at most", of_row.rays);
            report = report.merge(of_row);
        }
        let is_whole = report.cut_off == Unit::ZERO;
        assert!(self.mirrors || is_whole, "{report:?}, and nothing mirrors");
        report.rays
    }
}
