//! Notes how long each firmware took to build and to run, so that the gate can show where its time goes.

use std::collections::BTreeMap;
use std::fs::{self, OpenOptions};
use std::io::Write;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use anyhow::{Context, Result};
use rustix::time::{ClockId, clock_gettime};

use crate::toolchain;

/// Number of firmware images that the summary names.
const NAMED: usize = 12;

/// Marks the emulation of a whole board. The summary names each.
const BOARD: &str = "board";

fn file() -> PathBuf {
    toolchain::target_directory().join("firmware/times.tsv")
}

/// Forgets what was noted before.
pub fn clear() -> Result<()> {
    let file = file();
    if file.exists() {
        fs::remove_file(&file).with_context(|| format!("cannot remove {}", file.display()))
    } else {
        Ok(())
    }
}

/// Does some work for a firmware and notes how long it took. `what` is `build` or `run`.
pub(super) fn timed<T>(what: &str, firmware: &str, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    let result = work();
    note(what, start.elapsed(), firmware);
    result
}

/// How long an emulation took. Other programs run beside it, so the clock shows more than it needs.
#[derive(Clone, Copy, Debug)]
pub struct Emulated {
    clock: Duration,
    processor: Duration,
}

impl Emulated {
    /// Emulates, and takes the time of this thread.
    pub fn timed<T>(emulate: impl FnOnce() -> T) -> (T, Self) {
        let processor = || Duration::try_from(clock_gettime(ClockId::ThreadCPUTime));
        let (start, spent) = (Instant::now(), processor());
        let result = emulate();
        let (clock, now) = (start.elapsed(), processor());
        let processor = now.unwrap_or_default() - spent.unwrap_or_default();
        (result, Self { clock, processor })
    }
}

/// Notes that a board was emulated, and what it did.
pub fn note_board(time: Emulated, did: &str) {
    let processor = time.processor.as_secs_f64();
    let did = format!("{did}, {processor:.1} s of the processor");
    note(BOARD, time.clock, &did);
}

/// Notes what took how long.
fn note(what: &str, time: Duration, firmware: &str) {
    let line = format!("{what}\t{:.2}\t{firmware}\n", time.as_secs_f64());
    // Nobody misses a note that cannot be taken.
    let _ = OpenOptions::new()
        .create(true)
        .append(true)
        .open(file())
        .and_then(|mut notes| notes.write_all(line.as_bytes()));
}

/// Returns the number and the sum of the builds and of the runs, those that took the longest, and what each
/// emulated board did.
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
    let mut text = String::new();
    for (what, (count, seconds)) in sums {
        text += &format!("{seconds:>8.1}  {count} of {what}\n");
    }
    let (boards, images): (Vec<_>, Vec<_>) = rows.into_iter().partition(|row| row.1 == BOARD);
    let named = images.into_iter().take(NAMED).chain(boards);
    text.extend(named.map(|(seconds, what, name)| format!("{seconds:>8.1}  {what} {name}\n")));
    text
}
