//! Shows reflet's castle on a Raspberry Pi Pico 2 with an ST7789 of 240 by 240 pixels, five keys, and
//! both cores. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod cores;

use core::panic::PanicInfo;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::primitives::Rectangle;
use reflet::Camera;
use reflet::scenes::{BuiltIn, Castle};
use rp235x_hal::block::ImageDef;
use rtt_target::{rprintln, rtt_init_print};

use crate::board::Board;
use crate::cores::{BLACK_ROW, SIDE, Second};

/// Tells the boot ROM that this is a program for the Arm cores.
#[used]
#[unsafe(link_section = ".start_block")]
static IMAGE_DEF: ImageDef = ImageDef::secure_exe();

#[rp235x_hal::entry]
fn main() -> ! {
    rtt_init_print!();
    let Board {
        mut display,
        mut keys,
        mut second,
        timer,
    } = board::switch_on();
    let mut camera = Castle::CAMERA;
    loop {
        let start = timer.get_counter();
        draw(&camera, &mut display, &mut second).expect("the display takes every row");
        let time = timer.get_counter() - start;
        rprintln!("castle: {} ms", time.to_millis());
        camera = keys.wait(camera);
    }
}

/// Draws the castle, two rows at a time: the second core traces the odd ones.
fn draw<D: DrawTarget<Color = Rgb565>>(
    camera: &Camera,
    display: &mut D,
    second: &mut Second,
) -> Result<(), D::Error> {
    let frame = Castle::frame(camera).prepare(Size::new(SIDE, SIDE));
    let rows = frame
        .on(&Castle)
        .expect("a constant scene never changes");
    let mut pair = [BLACK_ROW; 2];
    for y in (0..SIDE).step_by(2) {
        second.ask(*camera, y + 1);
        rows.row(y, 0, &mut pair[0]);
        pair[1] = second.answer();
        let area = Rectangle::new(Point::new(0, y as i32), Size::new(SIDE, 2));
        display.fill_contiguous(&area, pair.iter().flatten().copied())?;
    }
    Ok(())
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
