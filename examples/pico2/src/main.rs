//! Shows reflet's castle on a Raspberry Pi Pico 2 with an ST7789 of 240 by 240 pixels, and both
//! cores. A key orbits the camera. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod cores;

use core::panic::PanicInfo;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::primitives::Rectangle;
use heapless::spsc::Consumer;
use reflet::Camera;
use reflet::scenes::{BuiltIn, Castle};
use rp235x_hal::block::ImageDef;
use rtt_target::{rprintln, rtt_init_print};

use crate::cores::{BLACK_ROW, Row, SIDE, after, prepare, trace};

/// Tells the boot ROM that this is a program for the Arm cores.
#[used]
#[unsafe(link_section = ".start_block")]
static IMAGE_DEF: ImageDef = ImageDef::secure_exe();

#[rp235x_hal::entry]
fn main() -> ! {
    rtt_init_print!();
    let mut board = board::switch_on();
    let mut camera = Castle::CAMERA;
    loop {
        let start = board.timer.get_counter();
        draw(&camera, &mut board.display, &mut board.odd_rows).expect("the display takes rows");
        let time = board.timer.get_counter() - start;
        rprintln!("castle: {} ms", time.to_millis());
        board.key.wait();
        camera = after(camera);
    }
}

/// Draws the castle, two rows at a time. The second core traces the odd ones.
fn draw<D: DrawTarget<Color = Rgb565>>(
    camera: &Camera,
    display: &mut D,
    odd_rows: &mut Consumer<Row>,
) -> Result<(), D::Error> {
    let frame = prepare(camera);
    let mut even = BLACK_ROW;
    for y in (0..SIDE).step_by(2) {
        trace(&frame, y, &mut even);
        let odd = loop {
            if let Some(odd) = odd_rows.dequeue() {
                break odd;
            }
        };
        let area = Rectangle::new(Point::new(0, y as i32), Size::new(SIDE, 2));
        display.fill_contiguous(&area, even.into_iter().chain(odd))?;
    }
    Ok(())
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
