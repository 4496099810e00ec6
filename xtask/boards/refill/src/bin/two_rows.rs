//! The right firmware: two buffers by turns.

#![no_std]
#![no_main]

#[allow(dead_code, reason = "keys and the second core are not used")]
#[path = "../../../../../examples/pico/src/board.rs"]
mod board;
#[path = "../pattern.rs"]
mod pattern;
#[allow(dead_code, reason = "the pattern is sent without it")]
#[path = "../../../../../examples/pico/src/screen/mod.rs"]
mod screen;

#[board::entry]
fn main() -> ! {
    pattern::run(2)
}
