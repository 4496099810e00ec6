//! Which settings are tried.

use xtask::sweep::{Level, Setting};

/// Resolutions that are tried.
const SCALES: [u8; 3] = [1, 2, 4];

/// All that is tried in fixed point with these numbers of reflections.
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
    plain(Level::FAST)
        .chain(plain(Level::FINE))
        .chain(plain(Level::EXACT))
        .chain(plain(Level::Rough4))
        .chain(plain(Level::Rough16))
        .chain(cuts.map(|level| Setting::fixed(level, most)))
        .chain(scaled(Level::FAST))
        .chain(scaled(Level::FINE))
        .chain(plain(Level::FAST).map(Setting::unshadowed))
        .chain(scaled(Level::FAST).map(Setting::unshadowed))
        .collect()
}

/// All that is tried with the float port.
pub fn float(numbers: &[u8]) -> Vec<Setting> {
    let numbers = |scale| numbers.iter().map(move |&it| Setting::float(it, scale));
    SCALES.into_iter().flat_map(numbers).collect()
}

/// The numbers of reflections that are tried up to the last that matters.
pub fn numbers(last: u8) -> Vec<u8> {
    /// From here on every one is not worth the time.
    const DENSE: u8 = 8;
    let steps = [10, 12, 16, 24, 32, 48, 64, 96, 128, 192];
    let some = (0..=DENSE).chain(steps).filter(|number| *number < last);
    some.chain([last]).collect()
}
