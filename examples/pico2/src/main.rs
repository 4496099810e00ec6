//! Shows reflet's castle on a Raspberry Pi Pico 2 with an ST7789 of 240 by 240 pixels, and both
//! cores. A key orbits the camera. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod cores;
mod scene;
mod screen;

use core::panic::PanicInfo;

use embedded_hal::{delay::DelayNs, digital::InputPin};
use rtt_target::{rprintln, rtt_init_print};

use crate::cores::{prepare, trace};
use crate::screen::{Line, SIDE};
// For a scene of yours, change this line: `scene.rs` says how.
use crate::scene::{CAMERA, Castle as Shown};

/// Tells the boot ROM that this is a program for the Arm cores.
#[used]
#[unsafe(link_section = ".start_block")]
static IMAGE_DEF: rp235x_hal::block::ImageDef = rp235x_hal::block::ImageDef::secure_exe();

#[rp235x_hal::entry]
fn main() -> ! {
    rtt_init_print!();
    let mut board = board::switch_on();
    let mut camera = CAMERA;
    let mut line = Line::BLACK;
    loop {
        let start = board.timer.get_counter();
        let frame = prepare(&camera);
        for y in (0..SIDE).step_by(2) {
            trace(&frame, y, &mut line);
            board.screen.show(y, 1, &line);
            while !board.odd_rows.ready() {}
            let odd = board.odd_rows.dequeue().unwrap_or(Line::BLACK);
            board.screen.show(y + 1, 1, &odd);
        }
        board.screen.finish();
        let time = board.timer.get_counter() - start;
        rprintln!("picture: {} ms", time.to_millis());
        while board.key.is_high() == Ok(true) {}
        while board.key.is_low() == Ok(true) {
            // Contacts bounce for some milliseconds.
            board.timer.delay_ms(10);
        }
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
