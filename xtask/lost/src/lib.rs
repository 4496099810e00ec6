//! Counts *lost* pixels: those that `Exact` has right and an interpolating quality has wrong. Draws
//! scenes of any origin, and makes random scenes that lose many. This library prints nothing.
#![deny(missing_docs)]

pub mod case;
pub mod families;
pub mod file;
pub mod table;

use rayon::ThreadPoolBuilder;
use rayon::prelude::*;

/// Stack of a worker in bytes. A scene with the room of a scene file is built on it.
const STACK: usize = 64 << 20;

/// Returns `work(0)` to `work(count - 1)`, computed on all cores.
///
/// # Panics
///
/// `work` panics, or no thread can be started.
pub fn on_all_cores<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let pool = ThreadPoolBuilder::new().stack_size(STACK).build();
    let pool = pool.expect("threads start");
    pool.install(|| (0..count).into_par_iter().map(&work).collect())
}
