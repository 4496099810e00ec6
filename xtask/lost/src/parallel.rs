//! Does work on all cores and hands over the results in order. Knows nothing of pictures.

use std::num::NonZero;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::mpsc;
use std::thread;

/// Stack of a worker in bytes. A scene with the room of a scene file is built on it.
const STACK: usize = 64 << 20;

/// Computes `work(0)`, `work(1)` and so on, on all cores, and calls `done` with the results in order.
///
/// # Panics
///
/// `work` panics, or no thread can be started.
pub fn in_order<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync, mut done: impl FnMut(T)) {
    let workers = thread::available_parallelism().map_or(1, NonZero::get);
    let (next, work) = (AtomicUsize::new(0), &work);
    let (sender, receiver) = mpsc::channel();
    thread::scope(|scope| {
        for _ in 0..workers.min(count) {
            let (sender, next) = (sender.clone(), &next);
            let run = move || {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count || sender.send((index, work(index))).is_err() {
                        break;
                    }
                }
            };
            let thread = thread::Builder::new().stack_size(STACK);
            thread.spawn_scoped(scope, run).expect("a thread starts");
        }
        drop(sender);
        let mut waiting: Vec<Option<T>> = (0..count).map(|_| None).collect();
        let mut first = 0;
        for (index, result) in receiver {
            waiting[index] = Some(result);
            while let Some(result) = waiting.get_mut(first).and_then(Option::take) {
                done(result);
                first += 1;
            }
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn results_arrive_in_order() {
        let mut found = Vec::new();
        in_order(100, |it| it * it, |it| found.push(it));
        assert_eq!(found, (0..100).map(|it| it * it).collect::<Vec<_>>());
        in_order(0, |_| panic!("nothing to do"), |()| {});
    }
}
