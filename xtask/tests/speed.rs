//! Tests `cargo xtask measure --board` and `--clock`: frames a second as an estimate, beside the emulated boards.

use xtask::copies;
use xtask::measure::frames;
use xtask::owned::{BLACK_PILL, Owned, PICO, PICO_2};
use xtask::root;

mod common;

use std::{fs, path::Path};

use boards::Script;

/// Returns the seconds that a board reports for the castle at 240x240.
fn reported(owned: &Owned) -> f64 {
    reported_by(owned, &copies::firmware(owned.name).unwrap())
}

/// Returns the seconds that a firmware reports for its picture.
fn reported_by(owned: &Owned, firmware: &Path) -> f64 {
    let run = owned.board.run(firmware, &Script::default().picture(&[]));
    let said = run.unwrap().said;
    let line = said.iter().find_map(|line| {
        line.strip_prefix("castle: ")
            .or(line.strip_prefix("picture: "))
    });
    let digits = line.unwrap().strip_suffix(" ms").unwrap();
    digits.parse::<f64>().unwrap() / 1e3
}

/// Tests that the estimate of the castle at 240x240 is within 10 % of what the emulated board takes.
/// Returns the emulated seconds.
fn test_against_emulation(owned: &'static Owned) -> f64 {
    let estimated = frames::estimated(owned, "castle").unwrap();
    let reported = reported(owned);
    let name = owned.name;
    println!("{name}: estimated {estimated:.3} s, emulated {reported:.3} s");
    let share = estimated / reported;
    assert!((share - 1.0).abs() < 0.1, "{estimated} {reported}");
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
    let source = fs::read_to_string(root().join("examples/pico2/src/scene.rs")).unwrap();
    let source = source.replace("Castle", "Empty");
    for owned in [&PICO_2, &BLACK_PILL] {
        let firmware = copies::build_with_scene(owned.name, &source, "Empty").unwrap();
        let reported = 1e3 * reported_by(owned, &firmware);
        assert!((reported - owned.sending).abs() < 0.5, "{reported}");
    }
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
measure --clock 48 --board pico => cannot be used with
measure --board pico --core m3 => cannot be used with
measure --board pica => [possible values: pico, pico2, blackpill]
measure --core rv32 floor --size 8x8 --clock 100 => no timings of instructions are published",
    );
}

/// Tests that the table in README.md has the kept figures.
fn assert_readme_has(kept: &[frames::Kept]) {
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let expected = frames::with_table(&readme, &frames::readme_table(kept));
    let again = "`cargo xtask measure --frames` has to be run again";
    assert!(expected.as_ref() == Some(&readme), "{again}");
}

#[test]
fn command_prints_the_frames_a_second_that_readme_shows() {
    let kept = frames::read().unwrap();
    assert_readme_has(&kept);
    let line = |line: &&frames::Kept| line.scene == "castle" && line.board == PICO_2.title;
    let kept = kept.iter().find(line).unwrap().frames_per_second;
    let done = common::xtask(&root(), "measure castle --board pico2");
    let (first, rest) = done.out.split_once('\n').unwrap();
    assert!(rest.contains("ms to send a frame"), "{rest}");
    let printed = first
        .strip_prefix("castle, 240x240, fast: estimated ")
        .unwrap();
    let printed = printed.strip_suffix(" frames a second").unwrap();
    let printed: f64 = printed.parse().unwrap();
    // As all kept figures, this one may be 2 % old.
    assert!(
        (printed / kept - 1.0).abs() < 0.02,
        "{printed}, kept {kept}"
    );
    println!("castle on a Pico 2: {printed} frames a second, {kept} in README");
}
