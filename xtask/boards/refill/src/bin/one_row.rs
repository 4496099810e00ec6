//! The wrong firmware: one buffer, which is refilled while the DMA still sends it.

#![no_std]
#![no_main]

#[path = "../pattern.rs"]
mod pattern;

#[rp235x_hal::entry]
fn main() -> ! {
    pattern::run(1)
}
