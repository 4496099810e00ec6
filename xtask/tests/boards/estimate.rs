//! The estimate of frames a second, beside what the emulated boards take.

use std::fs;

use boards::{Run, Script};
use xtask::measure::frames;
use xtask::{copies, root};

use super::{BLACK_PILL, Copied, PICO, PICO_2};

/// Returns the seconds that a board reports for its first picture, the castle at 240x240.
fn reported(run: &Run) -> f64 {
    let mut named = run.said.iter().filter_map(|line| line.split_once(": "));
    let line = named.find(|(name, _)| ["castle", "picture"].contains(name));
    let digits = line.unwrap().1.strip_suffix(" ms").unwrap();
    digits.parse::<f64>().unwrap() / 1e3
}

/// Tests that the estimate of the castle at 240x240 is within 10 % of what the emulated board takes.
/// Returns the emulated seconds.
fn test_against_emulation(copied: &Copied) -> f64 {
    let estimated = frames::estimated(copied.owned, "castle").unwrap();
    let reported = reported(copied.run());
    let off = (estimated - reported).abs();
    assert!(off < 0.1 * reported, "{estimated} {reported}");
    reported
}

#[test]
fn estimate_is_within_10_percent_of_an_emulated_pico() {
    test_against_emulation(&PICO);
}

#[test]
fn estimate_is_within_10_percent_of_an_emulated_pico_2_whose_time_readme_has() {
    let reported = test_against_emulation(&PICO_2);
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.contains(&format!("{reported:.2} s")), "{reported}");
}

#[test]
#[ignore = "builds two examples once more"]
fn time_of_sending_is_what_an_emulated_board_takes_for_an_empty_scene() {
    let source = fs::read_to_string(root().join("examples/blackpill/src/scene.rs")).unwrap();
    let source = source.replace("Castle", "Empty");
    for copied in [&PICO_2, &BLACK_PILL] {
        let owned = copied.owned;
        let firmware = copies::build_with_scene(owned.name, &source, "Empty").unwrap();
        let script = Script::default().picture(&[]);
        let run = owned.board.run(&firmware, &script).unwrap();
        let reported = 1e3 * reported(&run);
        assert!((reported - owned.sending).abs() < 0.5, "{reported}");
        let bus = 1e3 * run.pictures[0].bus.sending as f64 / owned.board.clock() as f64;
        assert!((bus - owned.hidden).abs() < 0.5, "{bus}");
    }
}
