//! A ball bounces over water while the camera orbits it. The keys left and right throw the ball and turn
//! the camera. What moves is drawn in time, what rests is drawn well.

#![no_std]
#![no_main]

#[path = "../../board.rs"]
mod board;
#[allow(dead_code, reason = "cores are not counted")]
#[path = "../../cores.rs"]
mod cores;
#[allow(dead_code, reason = "the camera keeps its height")]
#[path = "../../keys.rs"]
mod keys;
mod motion;
#[path = "../../screen/mod.rs"]
mod screen;
mod view;

use core::panic::PanicInfo;

use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};
use rtt_target::{rprintln, rtt_init_print};

use crate::cores::Cores;
use crate::keys::{Keys, Request};
use crate::motion::Motion;
use crate::view::View;

/// Time of a frame in milliseconds while something moves.
const FRAME: i32 = 80;

/// Instructions of both cores in that time. One takes 1.6 cycles.
const BUDGET: u64 = 2 * 125_000 * FRAME as u64 * 5 / 8;

/// Settings for the scene on this core at 240x240, as `cargo run --release --package report` in the
/// repository measures them: at most 2 x 2 pixels are one, and at least one reflection is followed.
const FRONT: ParetoFront = ParetoFront::new(&[
    point(1, 2, 213, 3441),
    point(2, 2, 222, 3655),
    point(4, 1, 628, 7362),
]);

const fn point(reflections: u8, scale: u8, instructions: u32, psnr: u16) -> FrontPoint {
    FrontPoint {
        prepare: 14_852,
        instructions,
        reflections,
        level: QualityLevel::Fast,
        scale,
        psnr,
        largest: 145,
    }
}

#[rp2040_hal::entry]
fn main() -> ! {
    rtt_init_print!();
    let mut board = board::switch_on();
    let mut keys = Keys::new(board.keys, board.timer);
    let mut cores = Cores::new(board.second_core, board.timer);
    let mut motion = Motion::START;
    loop {
        let start = board.timer.get_counter();
        let rests = motion.rests();
        let view = View::new(motion, &FRONT, if rests { u64::MAX } else { BUDGET });
        // A key ends the picture at rest. A frame of what moves is drawn to its end.
        let stop = || if rests { keys.pressed() } else { None };
        let pressed =
            view.with_rows(|rows| cores.draw((&view, rows), view.areas(), &mut board.screen, stop));
        let time = board.timer.get_counter() - start;
        rprintln!("frame: {} ms", time.to_millis());
        let pressed = match rests {
            true => pressed.or_else(|| Some(keys.wait())),
            false => keys.pressed(),
        };
        motion.advance(FRAME);
        if let Some(Request::Orbit(azimuth, _)) = pressed {
            motion.throw(azimuth.signum());
        }
    }
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
