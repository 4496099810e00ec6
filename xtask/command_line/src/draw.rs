//! Draws a scene in any quality and shading. All commands and tests of the repository draw through this
//! module, so the library is compiled for each quality and shading once, and not in every program.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use reflet::host::file::FileScene;
use reflet::host::reference::Picture;
use reflet::quality::{self, Exact, Fast, Small, Smooth};
use reflet::shading::{self, BlinnPhong, Normals, Phong};
use reflet::{Camera, Report};

use crate::{Quality, Shading, Source};

#[derive(Clone, Copy, Debug)]
pub struct Settings {
    pub reflections: u8,
    pub shading: Shading,
    pub quality: Quality,
}

impl Settings {
    /// Blinn-Phong shading.
    pub fn blinn_phong(quality: Quality, reflections: u8) -> Self {
        let shading = Shading::BlinnPhong;
        Self {
            reflections,
            shading,
            quality,
        }
    }
}

struct Draw<'a> {
    scene: &'a FileScene,
    camera: &'a Camera,
    size: Size,
    settings: Settings,
}

impl Source {
    /// Draws the scene through a camera, and hands out its rows from the top down.
    pub fn draw_rows(
        &self,
        camera: &Camera,
        size: Size,
        settings: Settings,
        row: &mut dyn FnMut(u32, &[Rgb888]),
    ) -> Report {
        let draw = Draw {
            scene: self.scene(),
            camera,
            size,
            settings,
        };
        draw.with_quality(row)
    }

    /// Draws the scene through its own camera.
    pub fn drawn(&self, size: Size, settings: Settings) -> Picture {
        let mut pixels = Vec::new();
        self.draw_rows(&self.camera(), size, settings, &mut |_, row| {
            pixels.extend(row.iter().map(|pixel| [pixel.r(), pixel.g(), pixel.b()]));
        });
        let Size { width, height } = size;
        Picture {
            width,
            height,
            pixels,
        }
    }
}

impl Draw<'_> {
    fn with_quality(self, row: &mut dyn FnMut(u32, &[Rgb888])) -> Report {
        match self.settings.quality {
            Quality::Fast => self.with_shading::<Fast>(row),
            Quality::Small => self.with_shading::<Small>(row),
            Quality::Exact => self.with_shading::<Exact>(row),
            Quality::Smooth2 => self.with_shading::<Smooth<2>>(row),
            Quality::Smooth4 => self.with_shading::<Smooth<4>>(row),
        }
    }

    fn with_shading<Q: quality::Quality>(self, row: &mut dyn FnMut(u32, &[Rgb888])) -> Report {
        match self.settings.shading {
            Shading::BlinnPhong => self.by_rows::<Q, BlinnPhong>(row),
            Shading::Phong => self.by_rows::<Q, Phong>(row),
            Shading::Normals => self.by_rows::<Q, Normals>(row),
        }
    }

    /// Draws as a board does: with tables, and by the same calls: a frame, its settings, and rows.
    fn by_rows<Q: quality::Quality, K: shading::Shading>(
        self,
        row: &mut dyn FnMut(u32, &[Rgb888]),
    ) -> Report {
        let scene = self.scene.tabled();
        let frame = scene.frame(self.camera);
        let frame = frame.reflections(self.settings.reflections);
        let prepared = frame.quality::<Q>().shading::<K>().prepare(self.size);
        let picture = prepared.on(&scene).expect("the scene never changes");
        let Size { width, height } = self.size;
        let mut pixels = vec![Rgb888::BLACK; width as usize];
        let mut seam = quality::Seam::<32>::new(); // for 1024 columns
        (0..height).fold(Report::NONE, |report, y| {
            let of_row = picture.next_row(&mut seam, y, 0, &mut pixels);
            row(y, &pixels);
            report.merge(of_row)
        })
    }
}
