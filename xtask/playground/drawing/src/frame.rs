//! A frame that is drawn row by row: samples become pixels, and pixels the colours of a display.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use frame_hash::FrameHash;
use reflet::host::file::FileScene;
use reflet::{Camera, Report};

use crate::display::shown;
use crate::lines::{Lines, prepared};
use crate::settings::Settings;

/// A frame, and what its rows have told so far.
pub struct Frame {
    pub settings: Settings,
    lines: Box<dyn Lines>,
    report: Report,
    /// The rows that were drawn, for the hash; each empty until then. Only of a plain picture.
    drawn: Vec<Vec<[u8; 3]>>,
    samples: Vec<Rgb888>,
    /// Red, green, blue and 255 of each pixel of the latest row.
    pixels: Vec<u8>,
}

impl Frame {
    pub fn new(scene: &FileScene, view: &Camera, settings: Settings) -> Self {
        let (width, smooth) = (settings.width as usize, settings.smooth as usize);
        Self {
            settings,
            lines: prepared(scene, view, &settings),
            report: Report::NONE,
            drawn: vec![Vec::new(); settings.height as usize],
            samples: vec![Rgb888::BLACK; width * smooth],
            pixels: vec![255; width * 4],
        }
    }

    /// Draws row `y`, and returns its pixels; nothing beyond the last row.
    pub fn row(&mut self, scene: &FileScene, y: u32) -> &[u8] {
        if y >= self.settings.height {
            return &[];
        }
        let colors = self.averages(scene, y);
        if self.settings.is_plain() {
            self.drawn[y as usize] = colors.iter().map(|it| [it.r(), it.g(), it.b()]).collect();
        }
        let places = (0..).map(|x| Point::new(x, y as i32));
        for ((pixel, color), at) in self.pixels.chunks_exact_mut(4).zip(colors).zip(places) {
            let color = shown(self.settings.display, color, at);
            pixel[..3].copy_from_slice(&[color.r(), color.g(), color.b()]);
        }
        &self.pixels
    }

    /// Returns the colours of row `y`: each the average of `smooth` by `smooth` samples, rounded.
    fn averages(&mut self, scene: &FileScene, y: u32) -> Vec<Rgb888> {
        let smooth = self.settings.smooth;
        let mut sums = vec![[0_u32; 3]; self.settings.width as usize];
        for line in 0..smooth {
            let line = y * smooth + line;
            let report = self.lines.line(scene, line, &mut self.samples);
            self.report = self.report.merge(report);
            for (sum, samples) in sums.iter_mut().zip(self.samples.chunks(smooth as usize)) {
                for sample in samples {
                    let parts = [sample.r(), sample.g(), sample.b()];
                    let parts = sum.iter_mut().zip(parts);
                    parts.for_each(|(sum, part)| *sum += u32::from(part));
                }
            }
        }
        let count = smooth * smooth;
        // An average of bytes is a byte.
        let average = |sum: u32| ((sum + count / 2) / count) as u8;
        let colors = sums.into_iter().map(|sum| sum.map(average));
        let colors = colors.map(|[red, green, blue]| Rgb888::new(red, green, blue));
        colors.collect()
    }

    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Returns the most light that is missing in a traced pixel, in levels of 255.
    pub fn missing_levels(&self, scene: &FileScene) -> f64 {
        self.lines.missing_levels(scene, &self.report)
    }

    /// Returns the hash of the picture, if all of it was drawn and nothing was changed afterwards.
    pub fn hash(&self) -> Option<u64> {
        let is_whole = !self.drawn.iter().any(Vec::is_empty);
        is_whole.then(|| FrameHash::of(self.drawn.iter().flatten().copied()))
    }
}
