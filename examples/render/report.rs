//! Formats the results of a picture for people and for programs. Never prints.

use command_line::{Settings, json_line, one_line};
use embedded_graphics::geometry::Size;
use reflet::host::compare::Difference;
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
    if let Some(Difference {
        same,
        within1,
        within8,
        psnr,
        max,
    }) = drawing.difference
    {
        fields.extend([
            ("same", same.into()),
            ("within1", within1.into()),
            ("within8", within8.into()),
            // PSNR is null if it is infinite, because JSON has no infinity.
            ("psnr", Value::from(psnr)),
            ("max", max.into()),
        ]);
    }
    let fields = fields
        .into_iter()
        .map(|(key, value)| format!("\"{key}\":{value}"));
    json_line(&format!("{{{}}}", fields.collect::<Vec<_>>().join(",")))
}

/// Returns one line of text, or two if the picture was compared with the reference.
pub fn text(scene: &str, size: Size, settings: Settings, drawing: &Drawing) -> String {
    let (
        Settings {
            reflections,
            shading,
            ..
        },
        seconds,
    ) = (settings, drawing.seconds);
    let (words, shading, quality) = (words(size), shading.name(), quality(settings, drawing));
    let scene = one_line(scene);
    let mut text =
        format!("{scene} {words}, {reflections} reflections, {shading}, {quality}: {seconds:.3} s");
    if let Some(report) = drawing.report {
        text += &format!(", {report}");
    }
    if let Some(Difference {
        same,
        within1,
        within8,
        psnr,
        max,
    }) = drawing.difference
    {
        let [same, within1, within8] = [same, within1, within8].map(|share| 100.0 * share);
        text += &format!(
            "\nagainst double precision: same {same:.3} %, within 1 {within1:.3} %, \
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
