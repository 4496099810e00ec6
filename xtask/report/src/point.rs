//! What is known of one setting: its cost and its error; and which settings are worth their cost.

use command_line::{Settings, Source};
use embedded_graphics::geometry::Size;
use frame_hash::FrameHash;
use reflet::host::reference::Picture;
use xtask::sweep::{Count, Setting};

#[derive(Clone, Debug)]
pub struct Point {
    pub setting: Setting,
    pub count: Count,
    pub pixels: u64,
    /// PSNR of all pixels in decibels; infinite if no pixel differs.
    pub psnr: f64,
    /// Largest difference of a channel, in levels of 255.
    pub largest: u8,
    /// Share of the pixels that are the same as the reference's, and within 1 of it.
    pub same: f64,
    pub within1: f64,
    /// Whether the point is one of [`front`].
    pub is_on_front: bool,
}

impl Point {
    pub fn cost(&self) -> f64 {
        self.count.instructions as f64 / self.pixels as f64
    }

    /// Returns the instructions a pixel without those of the preparation, rounded up.
    pub fn drawing(&self) -> u32 {
        let drawing = self.count.instructions.saturating_sub(self.count.prepare);
        drawing.div_ceil(self.pixels) as u32
    }

    /// Returns the PSNR in hundredths of a decibel, rounded down; `u16::MAX` if no pixel differs.
    pub fn hundredths(&self) -> u16 {
        if self.psnr.is_finite() {
            (100.0 * self.psnr).floor().clamp(0.0, 65_534.0) as u16
        } else {
            u16::MAX
        }
    }
}

/// Smallest gain in decibels from one point of a front to the next.
const GAIN: f64 = 0.25;

/// Finds the front and sets `is_on_front`: in the order of the cost, each point whose error is less than that of all
/// cheaper ones by [`GAIN`]. Of points that cost the same number of whole instructions, only the best is on the front.
pub fn mark_front(points: &mut [Point]) {
    let mut order: Vec<usize> = (0..points.len()).collect();
    order.sort_by(|&a, &b| {
        let (a, b) = (&points[a], &points[b]);
        let by_cost = a.count.instructions.cmp(&b.count.instructions);
        by_cost.then(b.psnr.total_cmp(&a.psnr))
    });
    let mut last: Option<usize> = None;
    for index in order {
        let point = &points[index];
        let is_better = last.map(|last| &points[last]).is_none_or(|last| {
            point.hundredths() > last.hundredths() && point.psnr >= last.psnr + GAIN
        });
        points[index].is_on_front = is_better;
        if is_better && let Some(last) = last.replace(index) {
            points[last].is_on_front = points[last].drawing() < points[index].drawing();
        }
    }
}

/// Returns the points of the front, the cheapest first.
pub fn front(points: &[Point]) -> Vec<&Point> {
    let mut front: Vec<&Point> = points.iter().filter(|it| it.is_on_front).collect();
    front.sort_by_key(|it| it.count.instructions);
    front
}

/// Draws a scene with a setting on this machine. Pictures are the same to the bit on every core.
pub fn paint(source: &Source, size: Size, setting: &Setting) -> Picture {
    let Size { width, height } = size;
    let scale = u32::from(setting.scale);
    let small = Size::new(width.div_ceil(scale), height.div_ceil(scale));
    let settings = Settings::blinn_phong(setting.quality, setting.reflections);
    let small = source.drawn(small, settings);
    let at = |x: u32, y: u32| small.pixels[(y / scale * small.width + x / scale) as usize];
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    Picture {
        width,
        height,
        pixels: places.map(|(x, y)| at(x, y)).collect(),
    }
}

/// Returns the hash that a firmware reports for the same picture.
pub fn hash(picture: &Picture) -> u64 {
    FrameHash::of(picture.pixels.iter().copied())
}
