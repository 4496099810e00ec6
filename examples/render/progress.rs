//! Shows a progress bar for work that takes longer than a second. Does not know the work.

use std::panic;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::{Duration, Instant};

use indicatif::{ProgressBar, ProgressStyle};

const PATIENCE: Duration = Duration::from_secs(1);
const GLANCE: Duration = Duration::from_millis(10);

/// Runs `work` and returns its result. `work` counts its progress towards `total`, if that is known.
/// After one second a bar on the terminal shows it.
pub fn watch<T: Send>(total: Option<u64>, work: impl FnOnce(&AtomicU64) -> T + Send) -> T {
    let done = AtomicU64::new(0);
    thread::scope(|scope| {
        let worker = scope.spawn(|| work(&done));
        let started = Instant::now();
        let mut shown = None;
        while !worker.is_finished() {
            thread::sleep(GLANCE);
            if started.elapsed() > PATIENCE {
                let bar = shown.get_or_insert_with(|| bar(total));
                bar.set_position(done.load(Ordering::Relaxed));
                bar.tick();
            }
        }
        if let Some(bar) = shown {
            bar.finish_and_clear();
        }
        worker
            .join()
            .unwrap_or_else(|reason| panic::resume_unwind(reason))
    })
}

/// Returns the progress bar. It is drawn on standard error, and not at all if that is no terminal.
fn bar(total: Option<u64>) -> ProgressBar {
    let (bar, template) = match total {
        Some(total) => (
            ProgressBar::new(total),
            "{wide_bar} {percent:>3} % {eta:>4}",
        ),
        None => (ProgressBar::new_spinner(), "{spinner} {elapsed}"),
    };
    let style = ProgressStyle::with_template(template).expect("the template is well formed");
    bar.with_elapsed(PATIENCE).with_style(style)
}
