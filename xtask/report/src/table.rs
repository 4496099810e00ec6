//! Writes points.csv: one row for each setting.

use anyhow::Result;
use reflet::Unit;
use xtask::sweep::{Contestant, Level, Numbers};

use crate::arguments::Arguments;
use crate::error::Promised;
use crate::point::Point;
use crate::scene::Measured;

pub fn csv(arguments: &Arguments, scenes: &[Measured]) -> Result<String> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let size = arguments.size_words();
    let mut rows = Vec::new();
    for scene in scenes {
        let points = scene.points.iter().chain(&scene.float);
        rows.extend(points.map(|point| row(&scene.painter.name, &size, point)));
    }
    writer.write_record(rows.iter().take(1).flatten().map(|cell| cell.0))?;
    for row in &rows {
        writer.write_record(row.iter().map(|cell| &cell.1))?;
    }
    Ok(String::from_utf8(writer.into_inner()?)?)
}

fn row(scene: &str, size: &str, point: &Point) -> Vec<(&'static str, String)> {
    let setting = &point.setting;
    let (contestant, level, shadows) = match setting.contestant {
        Contestant::Float => ("float", None, true),
        Contestant::Fixed(level) => ("fixed", Some(level), true),
        Contestant::Unshadowed => ("fixed", Some(Level::Fast), false),
    };
    let optional = |value: Option<String>| value.unwrap_or_default();
    let of_level = |show: fn(Numbers) -> String| optional(level.map(|it| show(it.numbers())));
    let (errors, cost) = (&point.errors, &point.cost);
    let of_promise = |show: fn(&Promised) -> String| optional(errors.promised.as_ref().map(show));
    let parts = &errors.parts;
    vec![
        ("scene", scene.to_owned()),
        ("core", point.core.to_owned()),
        ("size", size.to_owned()),
        ("contestant", contestant.to_owned()),
        ("quality", level.map_or("", Level::name).to_owned()),
        ("tolerance", of_level(|it| text(it.tolerance))),
        ("smallest_weight", of_level(|it| text(it.smallest_weight))),
        ("shadows", shadows.to_string()),
        ("scale", setting.scale.to_string()),
        ("reflections", setting.reflections.to_string()),
        ("instructions_per_pixel", digits(cost.instructions, 1)),
        ("prepare_instructions", cost.prepare.to_string()),
        ("hash", format!("{:016x}", cost.hash)),
        ("psnr", digits(errors.psnr, 3)),
        ("largest", errors.largest.to_string()),
        ("same", digits(errors.same, 5)),
        ("within1", digits(errors.within1, 5)),
        ("on_front", point.is_on_front.to_string()),
        ("sure_share", of_promise(|it| digits(it.sure, 5))),
        ("sure_psnr", of_promise(|it| digits(it.psnr, 3))),
        ("sure_largest", of_promise(|it| it.largest.to_string())),
        ("bound_psnr", of_promise(|it| digits(it.bound_psnr, 3))),
        ("bound_largest", of_promise(|it| digits(it.bound, 3))),
        (
            "bound_truncation",
            of_promise(|it| digits(it.truncation, 3)),
        ),
        ("bound_rounding", of_promise(|it| digits(it.rounding, 3))),
        ("decided_otherwise", of_promise(|it| it.decided.to_string())),
        ("beyond_bound", of_promise(|it| it.broken.to_string())),
        ("rms_truncation", digits(parts.truncation, 4)),
        ("rms_cut_off", digits(parts.cut_off, 4)),
        ("rms_between", digits(parts.between, 4)),
        ("rms_rounding", digits(parts.rounding, 4)),
        ("rms_decided", digits(parts.decided, 4)),
        ("rms_simplified", digits(parts.simplified, 4)),
    ]
}

fn text(number: Unit) -> String {
    number.to_num::<f64>().to_string()
}

/// Formats a number with at most this many digits after the point, without zeros at the end.
fn digits(value: f64, behind: usize) -> String {
    let text = format!("{value:.behind$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}
