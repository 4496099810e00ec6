//! points.csv: a row for every setting.

use crate::arguments::Arguments;
use crate::point::Point;
use crate::scene::Measured;
use crate::settings::{Contestant, Level};
use command_line::Failure;

/// The names of the columns.
const COLUMNS: [&str; 37] = [
    "scene",
    "core",
    "size",
    "contestant",
    "quality",
    "stride",
    "tolerance",
    "smallest_weight",
    "shadows",
    "scale",
    "reflections",
    "instructions_per_pixel",
    "prepare_instructions",
    "time_percent",
    "time_lower_quartile",
    "time_upper_quartile",
    "hash",
    "psnr",
    "largest",
    "same",
    "within1",
    "on_front",
    "sure_share",
    "sure_psnr",
    "sure_largest",
    "bound_psnr",
    "bound_largest",
    "bound_truncation",
    "bound_rounding",
    "decided_otherwise",
    "beyond_bound",
    "rms_truncation",
    "rms_cut_off",
    "rms_between",
    "rms_rounding",
    "rms_decided",
    "rms_simplified",
];

/// All rows.
pub fn csv(arguments: &Arguments, scenes: &[Measured]) -> Result<Vec<u8>, Failure> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(COLUMNS)?;
    let size = format!("{}x{}", arguments.size.width, arguments.size.height);
    for scene in scenes {
        let points = scene.points.iter().chain(&scene.float).chain(&scene.soft);
        for point in points {
            writer.write_record(row(scene.painter.name(), &size, point))?;
        }
    }
    Ok(writer.into_inner()?)
}

fn row(scene: &str, size: &str, point: &Point) -> Vec<String> {
    let setting = &point.setting;
    let (contestant, level, shadows) = match setting.contestant {
        Contestant::Float => ("float", None, true),
        Contestant::Fixed { level, shadows } => ("fixed", Some(level), shadows),
    };
    let numbers = level.map(Level::numbers);
    let optional = |value: Option<String>| value.unwrap_or_default();
    let (errors, cost) = (&point.errors, &point.cost);
    let promised = errors.promised;
    let of_promise =
        |show: fn(&crate::error::Promised) -> String| optional(promised.as_ref().map(show));
    let (counted, timed) = match cost.quartiles {
        None => (Some(cost.middle), None),
        Some(quartiles) => (None, Some((cost.middle, quartiles))),
    };
    let parts = &errors.parts;
    vec![
        scene.to_owned(),
        point.core.to_owned(),
        size.to_owned(),
        contestant.to_owned(),
        level.map_or("", Level::name).to_owned(),
        optional(numbers.map(|it| it.stride.to_string())),
        optional(numbers.map(|it| it.tolerance.to_num::<f64>().to_string())),
        optional(numbers.map(|it| it.smallest_weight.to_num::<f64>().to_string())),
        shadows.to_string(),
        setting.scale.to_string(),
        setting.reflections.to_string(),
        optional(counted.map(|it| format!("{it:.1}"))),
        optional(cost.prepare.map(|it| it.to_string())),
        optional(timed.map(|it| format!("{:.3}", it.0))),
        optional(timed.map(|it| format!("{:.3}", it.1.0))),
        optional(timed.map(|it| format!("{:.3}", it.1.1))),
        cost.hash.clone(),
        format!("{:.3}", errors.psnr),
        errors.largest.to_string(),
        format!("{:.5}", errors.same),
        format!("{:.5}", errors.within1),
        point.is_on_front.to_string(),
        of_promise(|it| format!("{:.5}", it.sure)),
        of_promise(|it| format!("{:.3}", it.psnr)),
        of_promise(|it| it.largest.to_string()),
        of_promise(|it| format!("{:.3}", it.bound_psnr)),
        of_promise(|it| format!("{:.3}", it.bound)),
        of_promise(|it| format!("{:.3}", it.truncation)),
        of_promise(|it| format!("{:.3}", it.rounding)),
        of_promise(|it| it.decided.to_string()),
        of_promise(|it| it.broken.to_string()),
        format!("{:.4}", parts.truncation),
        format!("{:.4}", parts.cut_off),
        format!("{:.4}", parts.between),
        format!("{:.4}", parts.rounding),
        format!("{:.4}", parts.decided),
        format!("{:.4}", parts.simplified),
    ]
}
