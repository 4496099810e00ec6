//! What the rows of a frame have told, for the page.

use drawing::Frame;
use serde::Serialize;

use crate::opened::Opened;

#[derive(Serialize)]
pub(crate) struct Told {
    rays: u64,
    cut_off: f64,
    missing_levels: f64,
    report: String,
    hash: Option<String>,
}

pub(crate) fn of(opened: &Opened, frame: &Frame) -> Told {
    let report = frame.report();
    Told {
        rays: report.rays,
        cut_off: report.cut_off.to_num(),
        missing_levels: frame.missing_levels(&opened.scene),
        report: report.to_string(),
        hash: frame.hash().map(|hash| format!("{hash:016x}")),
    }
}
