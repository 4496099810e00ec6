//! Shows the scenes of reflet on a Raspberry Pi Pico or Pico 2 with an ST7789 of 240 by 240 pixels, five keys,
//! and both cores. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod cores;
#[allow(dead_code, reason = "what counts is that a key is pressed")]
mod keys;
mod screen;
mod view;

use core::panic::PanicInfo;

use reflet::display::coarse_first;
use rtt_target::{rprintln, rtt_init_print};

use crate::board::Board;
use crate::cores::Cores;
use crate::keys::Keys;
use crate::screen::SIDE;
use crate::view::View;

#[board::entry]
fn main() -> ! {
    rtt_init_print!();
    let Board {
        mut screen,
        keys,
        second_core,
        timer,
    } = board::switch_on();
    let (mut keys, mut cores) = (Keys::new(keys, timer), Cores::new(second_core, timer));
    rprintln!("cores: {}", cores.count());
    let mut view = View::FIRST;
    loop {
        let start = timer.get_counter();
        let areas = coarse_first(SIDE);
        let pressed =
            view.with_rows(|rows| cores.draw((&view, rows), areas, &mut screen, || keys.pressed()));
        if pressed.is_none() {
            let time = timer.get_counter() - start;
            rprintln!("{}: {} ms", view.name(), time.to_millis());
        }
        let request = pressed.unwrap_or_else(|| keys.wait());
        view = view.after(request);
    }
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
