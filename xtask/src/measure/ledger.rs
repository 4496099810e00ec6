//! Notes how long each firmware took to build and to run, so that the gate can show where its time goes.

use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::PathBuf;
use std::time::Instant;

use anyhow::{Context, Result};

use crate::toolchain;

/// Number of firmware images that the summary names.
const NAMED: usize = 12;

fn file() -> PathBuf {
    toolchain::target_directory().join("firmware/times.tsv")
}

/// Forgets what was noted before.
pub fn clear() -> Result<()> {
    let file = file();
    match file.exists() {
        true => fs::remove_file(&file).with_context(|| format!("cannot remove {}", file.display())),
        false => Ok(()),
    }
}

/// Does some work for a firmware and notes how long it took. `what` is `build` or `run`.
pub(super) fn timed<T>(what: &str, firmware: &str, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    let line = format!("{what}\t{:.2}\t{firmware}\n", start.elapsed().as_secs_f64());
    // Nobody misses a note that cannot be taken.
    let _ = OpenOptions::new()
        .create(true)
        .append(true)
        .open(file())
        .and_then(|mut notes| notes.write_all(line.as_bytes()));
    result
}

/// Returns the number and the sum of the builds and of the runs, and those that took the longest.
pub fn summary() -> String {
    let notes = fs::read_to_string(file()).unwrap_or_default();
    let mut sums = BTreeMap::<&str, (usize, f64)>::new();
    let mut rows: Vec<(f64, &str, &str)> = Vec::new();
    for line in notes.lines() {
        let mut fields = line.split('\t');
        let (Some(what), Some(seconds), Some(firmware)) =
            (fields.next(), fields.next(), fields.next())
        else {
            continue;
        };
        let seconds = seconds.parse().unwrap_or(0.0);
        let sum = sums.entry(what).or_default();
        *sum = (sum.0 + 1, sum.1 + seconds);
        rows.push((seconds, what, firmware));
    }
    rows.sort_by(|one, other| other.0.total_cmp(&one.0));
    let sums = sums.into_iter();
    let mut text: String = sums
        .map(|(what, (count, seconds))| format!("{seconds:>8.1}  {count} of {what}\n"))
        .collect();
    let longest = rows.into_iter().take(NAMED);
    text.extend(longest.map(|(seconds, what, name)| format!("{seconds:>8.1}  {what} {name}\n")));
    text
}
