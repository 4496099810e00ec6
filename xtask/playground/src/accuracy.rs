//! The error of a picture that ends its paths early, and the bound of it.

use drawing::{Settings, prepared};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use reflet::Report;
use serde::Serialize;

use crate::opened::Opened;

/// Number of reflections of the picture that others are compared with.
pub(crate) const MANY: u32 = 64;

/// How far a picture is from that with [`MANY`] reflections. All but the rays is in levels of 255.
#[derive(Serialize)]
pub(crate) struct Error {
    reflections: u32,
    largest: u8,
    mean: f64,
    /// Most that the reflections left out can change.
    bound: f64,
    rays: u64,
}

/// Draws two pictures that differ in the number of reflections, and compares them.
pub(crate) fn measured(opened: &Opened, settings: Settings) -> Error {
    let many = Settings {
        reflections: MANY,
        ..settings
    };
    let [few, many] = [settings, many].map(|it| prepared(&opened.scene, &opened.view, &it));
    let mut rows = [(); 2].map(|()| vec![Rgb888::BLACK; settings.width as usize]);
    let (mut report, mut largest, mut sum) = (Report::NONE, 0, 0_u64);
    for y in 0..settings.height {
        let [row, exact] = &mut rows;
        report = report.merge(few.line(&opened.scene, y, row));
        many.line(&opened.scene, y, exact);
        for (pixel, exact) in row.iter().zip(exact) {
            let distance = distance(*pixel, *exact);
            largest = largest.max(distance);
            sum += u64::from(distance);
        }
    }
    Error {
        reflections: settings.reflections,
        largest,
        mean: sum as f64 / (f64::from(settings.width) * f64::from(settings.height)),
        bound: few.missing_levels(&opened.scene, &report),
        rays: report.rays,
    }
}

/// Returns the largest difference of two colours in a channel.
fn distance(one: Rgb888, other: Rgb888) -> u8 {
    let red = one.r().abs_diff(other.r());
    let green = one.g().abs_diff(other.g());
    red.max(green).max(one.b().abs_diff(other.b()))
}
