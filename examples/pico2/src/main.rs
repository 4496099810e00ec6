//! Shows reflet's castle on a Raspberry Pi Pico 2 with an ST7789 of 240 by 240 pixels, and both
//! cores. A key orbits the camera. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod cores;
mod scene;
mod screen;
mod view;

use core::panic::PanicInfo;

use embedded_hal::{delay::DelayNs, digital::InputPin};
use reflet::display::coarse_first;
use rtt_target::{rprintln, rtt_init_print};

use crate::cores::Cores;
use crate::screen::SIDE;
use crate::view::View;
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
    let mut cores = Cores::new(board.second_core).expect("the second core answers");
    let mut view = View { camera: CAMERA };
    loop {
        let start = board.timer.get_counter();
        view.with_rows(|rows| {
            let areas = coarse_first(SIDE);
            cores.draw((&view, rows), areas, &mut board.screen, || false);
        });
        let time = board.timer.get_counter() - start;
        rprintln!("picture: {} ms", time.to_millis());
        while board.key.is_high() == Ok(true) {}
        while board.key.is_low() == Ok(true) {
            // Contacts bounce for some milliseconds.
            board.timer.delay_ms(10);
        }
        // A camera cannot look along its `up`: then it keeps its place.
        view.camera = view.camera.orbited(10, 0).unwrap_or(view.camera);
    }
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
