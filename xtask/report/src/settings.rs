//! Lists the settings that the report measures.

use xtask::sweep::{Level, Setting};

/// Widths of a drawn pixel, in pixels of the picture.
const SCALES: [u8; 3] = [1, 2, 4];

/// Returns all settings of fixed point for these numbers of reflections.
pub fn fixed(numbers: &[u8]) -> Vec<Setting> {
    let most = numbers.last().copied().unwrap_or(0);
    let plain = |level| {
        let numbers = numbers.iter();
        numbers.map(move |&number| Setting::fixed(level, number))
    };
    let scaled = |level| {
        let scales = SCALES.into_iter().skip(1);
        scales.flat_map(move |scale| plain(level).map(move |it| Setting { scale, ..it }))
    };
    let cuts = [Level::Cut4, Level::Cut16, Level::Cut64];
    plain(Level::Fast)
        .chain(plain(Level::Exact))
        .chain(plain(Level::Rough4))
        .chain(plain(Level::Rough16))
        .chain(cuts.map(|level| Setting::fixed(level, most)))
        .chain(scaled(Level::Fast))
        .chain(scaled(Level::Exact))
        .chain(at_all_scales(numbers, Setting::unshadowed))
        .collect()
}

/// Returns all settings of the float port for these numbers of reflections.
pub fn float(numbers: &[u8]) -> Vec<Setting> {
    at_all_scales(numbers, Setting::float).collect()
}

fn at_all_scales(
    numbers: &[u8],
    setting: fn(u8, u8) -> Setting,
) -> impl Iterator<Item = Setting> + '_ {
    let numbers = move |scale| numbers.iter().map(move |&it| setting(it, scale));
    SCALES.into_iter().flat_map(numbers)
}

/// Returns the measured numbers of reflections, up to the last one that changes the picture.
pub fn numbers(last: u8) -> Vec<u8> {
    /// Up to this number every number is measured; beyond it, only some.
    const DENSE: u8 = 8;
    let steps = [10, 12, 16, 24, 32, 48, 64, 96, 128, 192];
    let some = (0..=DENSE).chain(steps).filter(|number| *number < last);
    some.chain([last]).collect()
}
