//! Draws nothing, as often as the other program draws the job's scene.
#![no_std]
#![no_main]

use core::ptr;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

#[allow(dead_code)] // Of the job, only the order matters here.
mod job {
    include!(env!("MEASURE_JOB"));
}

/// Pixels of the row that is drawn. They are static, so the stack holds only what the renderer needs.
static mut ROW: [Rgb888; job::ORDER.size.0 as usize] = [Rgb888::BLACK; job::ORDER.size.0 as usize];

#[unsafe(no_mangle)]
extern "C" fn main() -> ! {
    // Sound: nothing else names the row, and the start-up code calls this once.
    let row = unsafe { &mut *ptr::addr_of_mut!(ROW) };
    firmware::measure::<firmware::Nothing>(&job::ORDER, row)
}
