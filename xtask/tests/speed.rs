//! Tests `cargo xtask measure --clock`: frames a second as an estimate, beside the emulated boards.

use xtask::copies;
use xtask::measure::frames;
use xtask::owned::{Owned, PICO, PICO_2};
use xtask::root;

mod common;

use std::fs;

use boards::Script;

/// Returns the seconds that a board reports for the castle at 240x240.
fn reported(owned: &Owned) -> f64 {
    let firmware = copies::firmware(owned.name).unwrap();
    let run = owned.board.run(&firmware, &Script::default().picture(&[]));
    let said = run.unwrap().said;
    let line = said.iter().find_map(|line| line.strip_prefix("castle: "));
    let digits = line.unwrap().strip_suffix(" ms").unwrap();
    digits.parse::<f64>().unwrap() / 1e3
}

/// Returns the estimated seconds of the castle at 240x240.
fn estimated(board: &str) -> f64 {
    1.0 / frames::estimated(board, "castle").unwrap()
}

#[test]
fn estimate_is_within_10_percent_of_an_emulated_pico() {
    let (estimated, reported) = (estimated("Raspberry Pi Pico"), reported(&PICO));
    println!("estimated {estimated:.3} s, emulated {reported:.3} s");
    assert!(
        (estimated / reported - 1.0).abs() < 0.1,
        "{estimated} {reported}"
    );
}

/// The timings of the M33 are known less well, and the estimate is some 13 % too short: README has both.
#[test]
fn readme_has_the_time_that_an_emulated_pico_2_takes() {
    let (estimated, reported) = (estimated("Raspberry Pi Pico 2"), reported(&PICO_2));
    println!("estimated {estimated:.3} s, emulated {reported:.3} s");
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    assert!(readme.contains(&format!("{reported:.2} s")), "{reported}");
    assert!(
        estimated < reported && estimated > 0.8 * reported,
        "{estimated} {reported}"
    );
}

#[test]
fn command_says_how_the_estimate_is_made() {
    let arguments = "measure floor --clock 100 --cores 2 --bus 20 --size 32x32";
    let done = common::xtask(&root(), arguments);
    assert_eq!((done.code, &*done.err), (0, ""));
    assert!(done.out.contains("estimated "), "{}", done.out);
    assert!(
        done.out.contains("the slower of even and odd rows"),
        "{}",
        done.out
    );
    assert!(
        done.out.contains("0.8 ms on the bus at 20 MHz"),
        "{}",
        done.out
    );
    common::assert_mistakes(
        &root(),
        "
measure --clock 0 => not a number of MHz
measure --cores 2 => the following required arguments were not provided
measure --clock 48 --cores 3 => 3 is not in 1..=2
measure --core rv32 floor --size 8x8 --clock 100 => no timings of instructions are published",
    );
}

#[test]
fn castle_on_a_pico_2_has_the_frames_a_second_that_readme_shows() {
    let kept = frames::read().unwrap();
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let table = frames::readme_table(&kept);
    let expected = frames::with_table(&readme, &table);
    assert!(
        expected.as_ref() == Some(&readme),
        "`cargo xtask measure --frames` has to be run again"
    );
    let is_it = |line: &&frames::Kept| line.scene == "castle" && line.board.ends_with("Pico 2");
    let kept = kept.iter().find(is_it).unwrap();
    let measured = frames::estimated(&kept.board, &kept.scene).unwrap();
    let share = measured / kept.frames_per_second;
    assert!((share - 1.0).abs() < 0.02, "{measured}, kept {kept:?}");
}
