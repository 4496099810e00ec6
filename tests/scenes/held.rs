//! Compares a picture with the bounds of its pixels. Knows no scene.

use reflet::host::reference::Picture;
use reflet::host::reference::bound::{Ending, Paths};
use reflet::quality::Quality;

/// Returns where the paths of a quality end in a picture of this width.
pub fn ending<Q: Quality>(reflections: u8, side: u32) -> Ending {
    Ending {
        reflections: reflections.into(),
        smallest_weight: Q::SMALLEST_WEIGHT.to_num(),
        block: Ending::block_of(side, Q::TOLERANCE.to_num()),
        tolerance: Q::TOLERANCE.to_num(),
    }
}

/// Comparison of a picture with its bounds.
#[derive(Debug, Default)]
pub struct Held {
    pub pixels: usize,
    /// Number of sure pixels, for which a bound is promised.
    pub sure: usize,
    /// Number of sure pixels that exceed their bound.
    pub broken: usize,
    /// Number of unsure pixels that exceed their bound: rounding changed what their paths hit.
    pub decided: usize,
    /// Largest bound of the sure pixels, in 255ths. `worst` is their largest error.
    pub most: f64,
    pub worst: f64,
}

/// Compares a picture with the paths that end after `all` reflections, when nothing is left of them.
pub fn held(paths: &Paths, ending: &Ending, found: &Picture, all: usize) -> Held {
    let mut held = Held::default();
    let places = (0..found.height).flat_map(|y| (0..found.width).map(move |x| (x, y)));
    let pixels = places.zip(&found.pixels);
    for (bound, ((x, y), found)) in paths.bounds(ending).iter().zip(pixels) {
        let truth = paths.path(x, y).ended(all, 0.0).color;
        let apart = (0..3).map(|axis| {
            let exact = 255.0 * truth[axis].clamp(0.0, 1.0);
            (f64::from(found[axis]) - exact).abs()
        });
        let apart = apart.fold(0.0, f64::max);
        // The picture is rounded to whole levels, by at most half a level. The truth is not.
        let most = 255.0 * bound.share() + 0.5;
        held.pixels += 1;
        let is_further = apart > most;
        if bound.is_unsure {
            held.decided += usize::from(is_further);
            continue;
        }
        held.sure += 1;
        held.broken += usize::from(is_further);
        held.most = held.most.max(most);
        held.worst = held.worst.max(apart);
    }
    held
}
