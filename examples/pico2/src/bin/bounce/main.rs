//! A ball bounces over water while the camera orbits it. The key throws the ball and turns the camera.
//! What moves is drawn in time, what rests is drawn well.

#![no_std]
#![no_main]

#[path = "../../board.rs"]
mod board;
#[path = "../../cores.rs"]
mod cores;
mod motion;
#[path = "../../screen/mod.rs"]
mod screen;
mod view;

use core::panic::PanicInfo;

use embedded_hal::digital::InputPin;
use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};
use rtt_target::{rprintln, rtt_init_print};

use crate::cores::Cores;
use crate::motion::Motion;
use crate::view::View;

/// Tells the boot ROM that this is a program for the Arm cores.
#[used]
#[unsafe(link_section = ".start_block")]
static IMAGE_DEF: rp235x_hal::block::ImageDef = rp235x_hal::block::ImageDef::secure_exe();

/// Time of a frame in milliseconds while something moves.
const FRAME: i32 = 33;

/// Instructions of both cores in that time. One takes 1.6 cycles.
const BUDGET: u64 = 2 * 150_000 * FRAME as u64 * 5 / 8;

/// Settings for the scene on this core at 240x240, as `cargo run --release --package report` in the
/// repository measures them: at most 2 x 2 pixels are one, and at least one reflection is followed.
const FRONT: ParetoFront = ParetoFront::new(&[
    point(1, 2, 77, 3441),
    point(2, 2, 79, 3655),
    point(4, 1, 218, 7362),
]);

const fn point(reflections: u8, scale: u8, instructions: u32, psnr: u16) -> FrontPoint {
    FrontPoint {
        prepare: 4061,
        instructions,
        reflections,
        level: QualityLevel::Fast,
        scale,
        psnr,
        largest: 145,
    }
}

#[rp235x_hal::entry]
fn main() -> ! {
    rtt_init_print!();
    let mut board = board::switch_on();
    let mut cores = Cores::new(board.second_core).expect("the second core answers");
    let mut motion = Motion::START;
    loop {
        let start = board.timer.get_counter();
        let rests = motion.rests();
        let view = View::new(motion, &FRONT, if rests { u64::MAX } else { BUDGET });
        // A key ends the picture at rest. A frame of what moves is drawn to its end.
        let mut is_pressed = || board.key.is_low() == Ok(true);
        let stop = || rests && is_pressed();
        view.with_rows(|rows| cores.draw((&view, rows), view.areas(), &mut board.screen, stop));
        let time = board.timer.get_counter() - start;
        rprintln!("frame: {} ms", time.to_millis());
        motion.advance(FRAME);
        while rests && !is_pressed() {}
        if is_pressed() {
            motion.throw(1);
        }
    }
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
