//! A frame with a budget on an emulated Cortex-M3: what fits is chosen, and the core's own clock ends
//! it in time.

use std::{collections::BTreeMap, env};

use embedded_graphics::{
    geometry::{OriginDimensions, Size},
    pixelcolor::Rgb888,
};
use embedded_graphics_simulator::SimulatorDisplay;
use frame_hash::FrameHash;
use reflet::{
    Enlarged, Fine, StaticFrame,
    scenes::{BuiltIn, Castle},
};
use xtask::{measure::cores::Core, root, toolchain};

const SIZE: Size = Size::new(64, 48);

/// The numbers of each line that the firmware says.
fn said() -> Vec<BTreeMap<String, u64>> {
    env::set_current_dir(root()).unwrap();
    let core = Core::find("m3").unwrap();
    // Where the other programs of this package are built, too.
    let place = toolchain::target_directory()
        .join("firmware")
        .join(core.target);
    let program = toolchain::build(
        core.target,
        &[
            "--manifest-path",
            "xtask/firmware/Cargo.toml",
            "--target-dir",
            &place.to_string_lossy(),
            "--bin",
            "budget",
            "--features",
            "budget",
        ],
    );
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

/// Of a display whose lowest rows are black.
fn hash(display: &SimulatorDisplay<Rgb888>, missing: u64) -> u64 {
    let mut bytes = display.to_be_bytes();
    let kept = bytes.len() - 3 * SIZE.width as usize * missing as usize;
    bytes[kept..].fill(0);
    let mut hash = FrameHash::NONE;
    bytes
        .chunks_exact(3)
        .for_each(|it| hash.add([it[0], it[1], it[2]]));
    hash.value()
}

#[test]
fn board_draws_what_fits_and_stops_in_time() {
    let said = said();
    assert_eq!(said.len(), 2);
    let castle = || Castle::frame(&Castle::CAMERA);

    // 325 instructions a pixel are too few for either: the cheapest it is.
    let mut display = SimulatorDisplay::<Rgb888>::new(SIZE);
    let Ok(_) = castle()
        .reflections(1)
        .draw(&mut Enlarged::new(&mut display, 2));
    let cheap = &said[0];
    assert_eq!(
        (cheap["reflections"], cheap["fits"], cheap["missing"]),
        (1, 0, 0)
    );
    assert_eq!(cheap["hash"], hash(&display, 0));

    let Ok(_) = castle().quality::<Fine>().draw(&mut display);
    assert_eq!(display.size(), SIZE);
    let best = &said[1];
    assert_eq!((best["reflections"], best["fits"]), (4, 1));
    let missing = best["missing"];
    assert!(0 < missing && missing < u64::from(SIZE.height), "{missing}");
    assert_eq!(best["hash"], hash(&display, missing));
}
