//! The demo: each frame that a board shows is the desk's, while something moves and at rest.

use std::fs;

use boards::{SIDE, Script};
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::primitives::Rectangle;
use embedded_graphics_simulator::SimulatorDisplay;
use reflet::display::Enlarged;
use xtask::{copies, root};

use super::castle::{assert_are_shown, pixels};
use super::{BLACK_PILL, Copied, PICO, PICO_2, common};
use motion::Motion;

#[allow(dead_code, reason = "no key is pressed")]
#[path = "../../../examples/pico/src/bin/bounce/motion.rs"]
mod motion;

fn simulated(motion: Motion, reflections: u8, scale: u32) -> Vec<u16> {
    let size = Size::new_equal(SIDE as u32);
    let mut display = SimulatorDisplay::<Rgb565>::new(size);
    let whole = Rectangle::new(Point::zero(), size);
    let mut enlarged = Enlarged::new(&mut display, scale);
    let drawn = motion.with_rows(reflections, scale, |rows| {
        rows.draw_area(whole, Point::zero(), &mut enlarged)
    });
    drawn.unwrap();
    pixels(&display)
}

/// Tests the frames of a board after its reset, which are drawn with so many reflections. Returns frames a second.
fn test(copied: &Copied, reflections: u8) -> f64 {
    let milliseconds = i32::try_from(copied.owned.frame).unwrap();
    let firmware = copies::program(copied.owned.name, "bounce").unwrap();
    let mut motion = Motion::START;
    let mut script = Script::default().frames();
    let mut expected = vec![];
    while !motion.rests() {
        expected.push(simulated(motion, reflections, 2));
        script = script.picture(&[]);
        motion.advance(milliseconds);
    }
    expected.push(simulated(motion, 4, 1));
    let run = copied.board().run(&firmware, &script.picture(&[])).unwrap();
    assert_are_shown(copied, &run, &expected);
    let frames = expected.len() - 2;
    let cycles = run.pictures[frames].cycles - run.pictures[0].cycles;
    let found = (copied.board().clock() * frames as u64) as f64 / cycles as f64;
    // The motion goes on by the time that the program says.
    let off = (1000.0 / found / f64::from(copied.owned.frame) - 1.0).abs();
    assert!(off < 0.03, "{found}");
    found
}

#[test]
#[ignore = "builds one more firmware of the Pico"]
fn pico_shows_twenty_five_whole_frames_a_second_while_a_ball_bounces() {
    let frames = test(&PICO, 2);
    assert!(frames >= 25.0, "{frames}");
}

#[test]
fn pico_2_shows_thirty_five_whole_frames_a_second_while_a_ball_bounces() {
    let frames = test(&PICO_2, 2);
    assert!(frames >= 35.0, "{frames}");
}

#[test]
#[ignore = "builds one more firmware of the Black Pill"]
fn black_pill_shows_fourteen_whole_frames_a_second_while_a_ball_bounces() {
    let frames = test(&BLACK_PILL, 2);
    assert!(frames >= 14.0, "{frames}");
}

#[test]
#[ignore = "builds and emulates a Pico 2 once more"]
fn film_of_the_readme_is_what_its_command_writes() {
    let folder = tempfile::tempdir().unwrap();
    let done = common::xtask(folder.path(), "pico2 --film bounce.gif");
    assert_eq!(done.code, 0, "{}", done.err);
    let written = fs::read(folder.path().join("bounce.gif")).unwrap();
    let is_kept = written == fs::read(root().join("docs/bounce.gif")).unwrap();
    assert!(
        is_kept,
        "docs/bounce.gif is another film: run `cargo xtask pico2 --film docs/bounce.gif`"
    );
}

#[test]
fn boards_share_what_moves() {
    let motion = |board: &str| {
        let file = format!("examples/{board}/src/bin/bounce/motion.rs");
        fs::read_to_string(root().join(file)).unwrap()
    };
    assert_eq!(motion("pico"), motion("blackpill"));
}
