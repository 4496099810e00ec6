//! The time of SPI and DMA is emulated: a row that is refilled while it is sent spoils the picture.

use std::path::Path;

use boards::{Board, SIDE, Script};
use xtask::toolchain;

const TARGET: &str = "thumbv8m.main-none-eabihf";

/// Returns the number of pixels that are not those of the pattern.
fn wrong(program: &str) -> usize {
    let package = Path::new("xtask/boards/refill");
    let firmware = toolchain::build_for_chip(TARGET, package, program).unwrap();
    let run = Board::PICO_2.run(&firmware, &Script::default().picture(&[]));
    let pixels = &run.unwrap().pictures[0].pixels;
    let pattern = |x: usize, y: usize| ((x * 257) ^ (y * 91)) as u16;
    let expected = |at: usize| pattern(at % SIDE, at / SIDE).swap_bytes();
    let is_wrong = |(at, pixel): &(usize, &u16)| **pixel != expected(*at);
    pixels.iter().enumerate().filter(is_wrong).count()
}

#[test]
fn row_that_is_refilled_while_it_is_sent_gives_a_wrong_picture() {
    // Nearly all pixels: filling a row takes a small part of the time in which it is sent.
    let wrong = wrong("one_row");
    assert!(wrong > 50_000, "{wrong}");
}

#[test]
fn rows_that_are_filled_by_turns_give_the_right_picture() {
    assert_eq!(wrong("two_rows"), 0);
}
