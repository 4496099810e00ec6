//! The time of SPI and DMA is emulated: a row that is refilled while it is sent spoils the picture.

mod common;

use boards::{Board, SIDE, Script};
use common::Package;

const TARGET: &str = "thumbv8m.main-none-eabihf";

static ONE_ROW: Package = Package::new("xtask/boards/refill", "one_row", TARGET);
static TWO_ROWS: Package = Package::new("xtask/boards/refill", "two_rows", TARGET);

/// Returns the number of pixels that are not those of the pattern.
fn wrong(firmware: &Package) -> usize {
    let run = Board::PICO_2.run(firmware.path(), &Script::default().picture(&[]));
    let pixels = &run.unwrap().pictures[0].pixels;
    let pattern = |x: usize, y: usize| ((x * 257) ^ (y * 91)) as u16;
    let expected = |at: usize| pattern(at % SIDE, at / SIDE).swap_bytes();
    let pixels = pixels.iter().enumerate();
    pixels
        .filter(|(at, pixel)| **pixel != expected(*at))
        .count()
}

#[test]
fn row_that_is_refilled_while_it_is_sent_gives_a_wrong_picture() {
    // Nearly all pixels: filling a row takes a small part of the time in which it is sent.
    let wrong = wrong(&ONE_ROW);
    assert!(wrong > 50_000, "{wrong}");
}

#[test]
fn rows_that_are_filled_by_turns_give_the_right_picture() {
    assert_eq!(wrong(&TWO_ROWS), 0);
}
