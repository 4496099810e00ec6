//! Shows the scenes of reflet on a Raspberry Pi Pico with an ST7789 of 240 by 240 pixels, five keys,
//! and both cores. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod cores;
mod keys;
mod screen;
mod view;

use core::panic::PanicInfo;

use rtt_target::{rprintln, rtt_init_print};

use crate::board::Board;
use crate::cores::Cores;
use crate::keys::{Keys, Request};
use crate::screen::{Line, SIDE, Screen};
use crate::view::{Rows, View};

#[rp2040_hal::entry]
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
        let pressed = view.with_rows(|rows| draw(&view, rows, &mut screen, &mut keys, &mut cores));
        if pressed.is_none() {
            let time = timer.get_counter() - start;
            rprintln!("{}: {} ms", view.name(), time.to_millis());
        }
        let request = pressed.unwrap_or_else(|| keys.wait());
        view = view.after(request);
    }
}

/// Draws a view, two rows at a time. Stops and returns the request if a key is pressed.
fn draw(
    view: &View,
    rows: &dyn Rows,
    screen: &mut Screen,
    keys: &mut Keys,
    cores: &mut Cores,
) -> Option<Request> {
    let mut pair = [Line::BLACK; 2];
    for y in (0..SIDE).step_by(2) {
        cores.trace(view, rows, y, &mut pair);
        screen.show(y, 1, &pair[0]);
        screen.show(y + 1, 1, &pair[1]);
        let pressed = keys.pressed();
        if pressed.is_some() {
            return pressed;
        }
    }
    screen.finish();
    None
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
