//! Shows reflet's castle on a Black Pill (STM32F411) with an ST7789 of 240 by 240 pixels. The board's
//! key orbits the camera. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod scene;

use core::panic::PanicInfo;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use rtt_target::{rprintln, rtt_init_print};
use stm32f4xx_hal::pac::DWT;

use crate::board::{Board, CORE_MHZ};
// For a scene of yours, change this line: `scene.rs` says how.
use crate::scene::{CAMERA, Castle as Shown};

#[cortex_m_rt::entry]
fn main() -> ! {
    rtt_init_print!();
    let Board {
        mut display,
        mut key,
    } = board::switch_on();
    let mut camera = CAMERA;
    let mut row = [Rgb565::BLACK; 240];
    loop {
        let start = DWT::cycle_count();
        Shown::frame(&camera)
            .draw_coarse_first(&mut row, &mut display)
            .expect("the display takes every row");
        let cycles = DWT::cycle_count().wrapping_sub(start);
        rprintln!("picture: {} ms", cycles / (CORE_MHZ * 1000));
        key.wait();
        // A camera cannot look along its `up`: then it keeps its place.
        camera = camera.orbited(10, 0).unwrap_or(camera);
    }
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
