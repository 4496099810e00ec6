//! Writes points.csv: one row for each setting.

use anyhow::Result;
use serde::Serialize;

use crate::scene::Measured;

/// A row. The columns have the names of the fields.
#[derive(Serialize)]
struct Row<'a> {
    scene: &'a str,
    core: &'a str,
    size: &'a str,
    quality: &'a str,
    scale: u8,
    reflections: u8,
    instructions_per_pixel: String,
    prepare_instructions: u64,
    hash: String,
    psnr: String,
    largest: u8,
    same: String,
    within1: String,
    on_front: bool,
}

pub fn csv(core: &str, size: &str, scenes: &[Measured]) -> Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for scene in scenes {
        for point in &scene.points {
            writer.serialize(Row {
                scene: &scene.name,
                core,
                size,
                quality: point.setting.quality.name(),
                scale: point.setting.scale,
                reflections: point.setting.reflections,
                instructions_per_pixel: digits(point.cost(), 1),
                prepare_instructions: point.count.prepare,
                hash: format!("{:016x}", point.count.hash),
                psnr: digits(point.psnr, 3),
                largest: point.largest,
                same: digits(point.same, 5),
                within1: digits(point.within1, 5),
                on_front: point.is_on_front,
            })?;
        }
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

/// Formats a number with at most this many digits after the point, without zeros at the end.
fn digits(value: f64, behind: usize) -> String {
    let text = format!("{value:.behind$}");
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}
