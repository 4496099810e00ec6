//! Tests `cargo xtask measure --board` and `--clock`: frames a second as an estimate.

use xtask::measure::frames;
use xtask::owned::PICO_2;
use xtask::root;
use xtask::table::with_table;

mod common;

use std::fs;

#[test]
fn command_says_how_the_estimate_is_made() {
    let arguments = "measure floor --clock 100 --cores 2 --bus 20 --size 32x32";
    let done = common::xtask(&root(), arguments);
    assert_eq!((done.code, &*done.err), (0, ""));
    for words in [
        "estimated ",
        "the slower of even and odd rows",
        "0.8 ms on the bus at 20 MHz",
    ] {
        assert!(done.out.contains(words), "{words}: {}", done.out);
    }
    common::assert_mistakes(
        &root(),
        "
measure --clock 0 => not a number of MHz
measure --cores 2 => the following required arguments were not provided
measure --clock 48 --cores 3 => 3 is not in 1..=2
measure --clock 48 --board pico => cannot be used with
measure --board pico --core m3 => cannot be used with
measure --board pico2 --cores 1 => cannot be used with
measure --board pica => [possible values: pico, pico2, blackpill]
measure --core rv32 floor --size 8x8 --clock 100 => no timings of instructions are published",
    );
}

#[test]
fn command_prints_the_frames_a_second_that_readme_shows() {
    let kept = frames::read().unwrap();
    let readme = fs::read_to_string(root().join("README.md")).unwrap();
    let expected = with_table(&readme, "", &frames::readme_table(&kept));
    let again = "`cargo xtask measure --frames` has to be run again";
    assert!(expected.as_ref() == Some(&readme), "{again}");
    let line = |line: &&frames::Kept| line.scene == "castle" && line.board == PICO_2.title;
    let kept = kept.iter().find(line).unwrap().frames_per_second;
    let done = common::xtask(&root(), "measure castle --board pico2");
    let (first, rest) = done.out.split_once('\n').unwrap();
    assert!(rest.contains("ms to send a frame"), "{rest}");
    assert!(rest.contains("\nFlash "), "{rest}");
    let printed = first.strip_prefix("castle, 240x240, fast: estimated ");
    let printed = printed.and_then(|it| it.strip_suffix(" frames a second"));
    let printed: f64 = printed.unwrap().parse().unwrap();
    // As all kept figures, this one may be 2 % old.
    let off = (printed / kept - 1.0).abs();
    assert!(off < 0.02, "{printed}, kept {kept}");
    println!("castle on a Pico 2: {printed} frames a second, {kept} in README");
}
