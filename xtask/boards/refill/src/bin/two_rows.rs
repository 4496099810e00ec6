//! The right firmware: two buffers by turns.

#![no_std]
#![no_main]

#[path = "../pattern.rs"]
mod pattern;

#[rp235x_hal::entry]
fn main() -> ! {
    pattern::run(2)
}
