//! Formats the results of a picture for people and for programs. Never prints.

use command_line::{Settings, json_line, one_line};
use embedded_graphics::geometry::Size;
use serde_json::Value;

use crate::picture::Drawing;

/// Returns one line of JSON.
pub fn json(scene: &str, size: Size, settings: Settings, drawing: &Drawing) -> String {
    let mut fields = vec![
        ("scene", scene.into()),
        ("size", words(size).into()),
        ("reflections", settings.reflections.into()),
        ("shading", settings.shading.name().into()),
        ("quality", quality(settings, drawing).into()),
        ("seconds", drawing.seconds.into()),
    ];
    if let Some((found, _)) = &drawing.difference {
        fields.extend([
            ("same", found.same.into()),
            ("within1", found.within1.into()),
            ("within8", found.within8.into()),
            // PSNR is null if it is infinite, because JSON has no infinity.
            ("psnr", Value::from(found.psnr)),
            ("max", found.max.into()),
        ]);
    }
    let fields = fields
        .into_iter()
        .map(|(key, value)| format!("\"{key}\":{value}"));
    json_line(&format!("{{{}}}", fields.collect::<Vec<_>>().join(",")))
}

/// Returns one line of text, or two if the picture was compared with the reference.
pub fn text(scene: &str, size: Size, settings: Settings, drawing: &Drawing) -> String {
    let (scene, words, reflections) = (one_line(scene), words(size), settings.reflections);
    let (shading, quality) = (settings.shading.name(), quality(settings, drawing));
    let seconds = drawing.seconds;
    let mut text =
        format!("{scene} {words}, {reflections} reflections, {shading}, {quality}: {seconds:.3} s");
    if let Some(report) = drawing.report {
        text += &format!(", {report}");
    }
    if let Some((found, samples)) = &drawing.difference {
        let shares = [found.same, found.within1, found.within8];
        let [same, within1, within8] = shares.map(|share| 100.0 * share);
        let (psnr, max) = (found.psnr, found.max);
        let sampled = match samples {
            1 => String::new(),
            _ => format!(", {samples} x {samples} samples a pixel"),
        };
        text += &format!(
            "\nagainst double precision{sampled}: same {same:.3} %, within 1 {within1:.3} %, \
             within 8 {within8:.3} %, PSNR {psnr:.2} dB, largest difference {max}"
        );
    }
    text
}

fn words(size: Size) -> String {
    format!("{}x{}", size.width, size.height)
}

fn quality(settings: Settings, drawing: &Drawing) -> &'static str {
    match drawing.report {
        Some(_) => settings.quality.name(),
        None => "reference",
    }
}
