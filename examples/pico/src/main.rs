//! Shows the scenes of reflet on a Raspberry Pi Pico with an ST7789 of 240 by 240 pixels, five keys,
//! and both cores. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod cores;
mod keys;
mod view;

use core::panic::PanicInfo;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::primitives::Rectangle;
use rtt_target::{rprintln, rtt_init_print};

use crate::board::Board;
use crate::cores::Cores;
use crate::keys::{Keys, Request};
use crate::view::{BLACK_ROW, Rows, SIDE, View};

#[rp2040_hal::entry]
fn main() -> ! {
    rtt_init_print!();
    let Board {
        mut display,
        keys,
        second_core,
        timer,
    } = board::switch_on();
    let (mut keys, mut cores) = (Keys::new(keys, timer), Cores::new(second_core, timer));
    rprintln!("cores: {}", cores.count());
    let mut view = View::FIRST;
    loop {
        let start = timer.get_counter();
        let pressed = view
            .with_rows(|rows| draw(&view, rows, &mut display, &mut keys, &mut cores))
            .expect("the display takes every row");
        if pressed.is_none() {
            let time = timer.get_counter() - start;
            rprintln!("{}: {} ms", view.name(), time.to_millis());
        }
        let request = pressed.unwrap_or_else(|| keys.wait());
        view = view.after(request);
    }
}

/// Draws a view, two rows at a time. Stops and returns the request if a key is pressed.
fn draw<D: DrawTarget<Color = Rgb565>>(
    view: &View,
    rows: &dyn Rows,
    display: &mut D,
    keys: &mut Keys,
    cores: &mut Cores,
) -> Result<Option<Request>, D::Error> {
    let mut pair = [BLACK_ROW; 2];
    for y in (0..SIDE).step_by(2) {
        cores.trace(view, rows, y, &mut pair);
        let area = Rectangle::new(Point::new(0, y as i32), Size::new(SIDE, 2));
        display.fill_contiguous(&area, pair.iter().flatten().copied())?;
        if let Some(request) = keys.pressed() {
            return Ok(Some(request));
        }
    }
    Ok(None)
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
