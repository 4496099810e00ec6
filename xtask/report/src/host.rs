//! Measures time on this machine: all settings in turn, relative to the double-precision reference.

use std::collections::HashMap;
use std::hint::black_box;
use std::time::Instant;

use anyhow::Result;
use rayon::ThreadPoolBuilder;
use reflet::host::reference::{self, Shading};
use xtask::sweep::Setting;

use crate::paint::{Painter, hash};
use crate::point::Cost;

/// Number of times that each setting is measured.
pub const ROUNDS: usize = 9;

/// Measures the time of each setting, in percent of the time that the reference takes with the same
/// number of reflections. Both run at full resolution and on one thread. Calls `done` after each
/// round of a setting.
///
/// The settings take turns, so that other work of the machine affects all of them alike.
pub fn time(painter: &Painter, settings: &[Setting], done: &dyn Fn()) -> Result<Vec<Cost>> {
    let pool = ThreadPoolBuilder::new().num_threads(1).build()?;
    let reference = |reflections: u8| {
        let (scene, camera, size) = (&painter.scene, &painter.exact_camera, painter.size);
        let (width, height) = (size.width, size.height);
        let n = u32::from(reflections);
        let shading = Shading::BlinnPhong;
        let render = || reference::render(scene, camera, width, height, n, shading);
        pool.install(|| seconds(render))
    };
    let mut shares = vec![Vec::with_capacity(ROUNDS); settings.len()];
    for _ in 0..ROUNDS {
        let mut wholes = HashMap::new();
        for (setting, shares) in settings.iter().zip(&mut shares) {
            let reflections = setting.reflections;
            let whole = *wholes
                .entry(reflections)
                .or_insert_with(|| reference(reflections));
            shares.push(100.0 * seconds(|| painter.paint(setting)) / whole);
            done();
        }
    }
    let costs = settings.iter().zip(shares).map(|(setting, mut shares)| {
        shares.sort_by(f64::total_cmp);
        Cost {
            middle: shares[ROUNDS / 2],
            quartiles: Some((shares[ROUNDS / 4], shares[ROUNDS - 1 - ROUNDS / 4])),
            prepare: None,
            hash: hash(&painter.paint(setting)),
        }
    });
    Ok(costs.collect())
}

fn seconds<T>(work: impl FnOnce() -> T) -> f64 {
    let started = Instant::now();
    black_box(work());
    started.elapsed().as_secs_f64()
}
