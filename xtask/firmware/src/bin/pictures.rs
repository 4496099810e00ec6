//! Draws the job's scenes, one after the other.
#![no_std]
#![no_main]

use core::ptr;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

mod job {
    include!(env!("MEASURE_JOB"));
}

/// Pixels of the row that is drawn.
static mut ROW: [Rgb888; job::ORDER.size.0 as usize] = [Rgb888::BLACK; job::ORDER.size.0 as usize];

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    // Sound: nothing else names the row, and the start-up code calls this once.
    let row = unsafe { &mut *ptr::addr_of_mut!(ROW) };
    for draw in job::PICTURES {
        draw(job::ORDER.size, row);
    }
    semihosting::process::exit(0)
}
