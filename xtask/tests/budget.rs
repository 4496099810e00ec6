//! Tests a frame with a budget on an emulated Cortex-M3: the chosen settings take no more than the
//! budget, and the core's own clock ends the frame in time.

use std::{collections::BTreeMap, path::Path};

use embedded_graphics::geometry::{OriginDimensions, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics_simulator::SimulatorDisplay;
use frame_hash::FrameHash;
use reflet::budget::FrontPoint;
use reflet::display::Enlarged;
use reflet::quality::Exact;
use reflet::scenes::{BuiltIn, Castle};
use xtask::{measure::Core, toolchain};

/// Measured fronts, and the size at which they were measured.
mod measured {
    // Only the castle's front is used.
    #![allow(dead_code)]

    use embedded_graphics::geometry::Size;
    use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};

    include!("../../docs/error-time/front.rs");

    pub const SIZE: Size = Size::new(128, 128);
}

const SIZE: Size = Size::new(64, 48);

/// Runs the firmware and returns the numbers of each line that it prints.
fn said() -> Vec<BTreeMap<String, u64>> {
    let core = Core::M3;
    let chosen = ["--bin", "budget", "--features", "budget"];
    let program = toolchain::build_alone(core.target, Path::new("xtask/firmware"), &chosen);
    let said = core.counting_emulator().run(&program.unwrap()).unwrap();
    let lines = said.lines().filter_map(|line| line.strip_prefix("drawn "));
    let number = |word: &str| {
        let (name, digits) = word.split_once('=').unwrap();
        (name.to_owned(), u64::from_str_radix(digits, 16).unwrap())
    };
    lines
        .map(|line| line.split(' ').map(number).collect())
        .collect()
}

/// Returns the hash of a display whose lowest `missing` rows are set to black.
fn hash(display: &SimulatorDisplay<Rgb888>, missing: u64) -> u64 {
    let mut bytes = display.to_be_bytes();
    let kept = bytes.len() - 3 * SIZE.width as usize * missing as usize;
    bytes[kept..].fill(0);
    FrameHash::of(bytes.chunks_exact(3).map(|it| [it[0], it[1], it[2]]))
}

/// Returns the most instructions that the draw target may take in addition to the budget. It takes a
/// row from an iterator instead of writing it in place, or draws each larger pixel as a square.
fn target_takes(point: &FrontPoint) -> u64 {
    let Size { width, height } = measured::SIZE;
    let scale = u32::from(point.scale);
    let pixels = u64::from(width.div_ceil(scale) * height.div_ceil(scale));
    // 35 for the iterator and a program with both qualities, in which less is inlined than in one with the
    // measured quality alone: 29 in `Fast`, 35 in `Exact`. And 15 for each of the 16 pixels of the largest square.
    pixels * if scale == 1 { 35 } else { 35 + 240 }
}

#[test]
fn board_draws_what_fits_and_stops_in_time() {
    let said = said();
    let points = measured::CASTLE.points();
    assert_eq!(said.len(), 2 + 2 * points.len());
    let castle = || Castle::frame(&Castle::CAMERA);

    // 325 instructions a pixel are too few for any setting, so the cheapest is chosen.
    let mut display = SimulatorDisplay::<Rgb888>::new(SIZE);
    let Ok(_) = castle()
        .reflections(1)
        .draw(&mut Enlarged::new(&mut display, 2));
    let cheap = &said[0];
    let chosen = ["reflections", "fits", "missing"].map(|name| cheap[name]);
    assert_eq!(chosen, [1, 0, 0]);
    assert_eq!(cheap["hash"], hash(&display, 0));

    let Ok(_) = castle().quality::<Exact>().draw(&mut display);
    assert_eq!(display.size(), SIZE);
    let best = &said[1];
    assert_eq!((best["reflections"], best["fits"]), (4, 1));
    let missing = best["missing"];
    assert!(0 < missing && missing < u64::from(SIZE.height), "{missing}");
    assert_eq!(best["hash"], hash(&display, missing));
    // Drawing stops before the first row that would begin after the budget.
    let (taken, longest) = (best["instructions"], best["longest"]);
    assert!(3_000_000 < taken && taken <= 3_000_000 + longest, "{taken}");

    for (size, frames) in [
        (measured::SIZE, &said[2..2 + points.len()]),
        (SIZE, &said[2 + points.len()..]),
    ] {
        for (point, frame) in points.iter().zip(frames) {
            let (taken, budget) = (frame["instructions"], point.expected(size));
            let share = 100.0 * taken as f64 / budget as f64;
            println!("{size}: {taken} of {budget}, {share:.2} %: {point:?}");
        }
        for (point, frame) in points.iter().zip(frames) {
            assert_eq!((frame["fits"], frame["missing"]), (1, 0));
            // At another size other shares of the pixels are traced.
            if size == measured::SIZE {
                let (taken, budget) = (frame["instructions"], point.expected(size));
                let most = budget + target_takes(point);
                assert!(taken <= most, "{size}: {taken} of {budget}, {point:?}");
            }
        }
    }
}
