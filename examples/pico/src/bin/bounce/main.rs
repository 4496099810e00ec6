//! A ball bounces over water while the camera orbits it. The keys left and right throw the ball and turn
//! the camera. What moves is drawn in time, what rests is drawn well.

#![no_std]
#![no_main]

#[path = "../../board.rs"]
mod board;
#[allow(dead_code, reason = "cores are not counted")]
#[path = "../../cores.rs"]
mod cores;
#[allow(dead_code, reason = "a key counts as long as it is held")]
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
const FRAME: i32 = if cfg!(rp2040) { 35 } else { 27 };

/// Clock of the cores in kHz.
const CLOCK: u64 = if cfg!(rp2040) { 200_000 } else { 150_000 };

/// Instructions of both cores in that time. One takes 1.5 cycles.
const BUDGET: u64 = 2 * CLOCK * FRAME as u64 * 2 / 3;

/// Settings for the scene on either core at 240x240, as `cargo run --release --package report` in the
/// repository measures them: at most 2 x 2 pixels are one, and at least one reflection is followed.
const FRONT: ParetoFront = ParetoFront::new(&[
    point(1, 2, [152, 62], (3440, 145)),
    point(2, 2, [160, 64], (3655, 145)),
    point(4, 1, [436, 153], (7177, 2)),
]);

/// `instructions` are those of a Cortex-M0+ and of a Cortex-M33, `error` is the PSNR in hundredths of a decibel and the
/// largest error in levels of 255.
const fn point(reflections: u8, scale: u8, instructions: [u32; 2], error: (u16, u8)) -> FrontPoint {
    let (psnr, largest) = error;
    let [m0, m33] = instructions;
    let (prepare, instructions) = if cfg!(rp2040) { (13_693, m0) } else { (3425, m33) };
    FrontPoint {
        prepare,
        instructions,
        reflections,
        level: QualityLevel::Fast,
        scale,
        psnr,
        largest,
    }
}

#[board::entry]
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
        let stop = || if rests { keys.held() } else { None };
        view.with_rows(|rows| cores.draw((&view, rows), view.areas(), &mut board.screen, stop));
        let time = board.timer.get_counter() - start;
        rprintln!("frame: {} ms", time.to_millis());
        motion.advance(FRAME);
        while rests && keys.held().is_none() {}
        if let Some(Request::Orbit(azimuth, _)) = keys.held() {
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
