//! A ball bounces over water while the camera orbits it. The key throws the ball and turns the camera.
//! What moves is drawn in time, what rests is drawn well.

#![no_std]
#![no_main]

#[allow(dead_code, reason = "nothing waits for the key to be released")]
#[path = "../../board.rs"]
mod board;
mod motion;

use core::iter::repeat_n;
use core::panic::PanicInfo;

use embedded_graphics::{pixelcolor::Rgb565, prelude::*, primitives::Rectangle};
use reflet::budget::{FrontPoint, ParetoFront, QualityLevel};
use reflet::{MovingScene, Rows};
use rtt_target::{rprintln, rtt_init_print};
use stm32f4xx_hal::pac::DWT;

use crate::board::{Board, CORE_MHZ};
use crate::motion::{Bounce, Motion, areas};

/// Width and height of the panel in pixels.
const SIDE: u32 = 240;

/// Time of a frame in milliseconds while something moves.
const FRAME: i32 = 65;

/// Instructions of tracing in the time of a frame, at 1.75 cycles each: that includes handing out the pixels.
const BUDGET: u64 = 1000 * CORE_MHZ as u64 * FRAME as u64 * 4 / 7;

/// Settings for the scene on this core at 240x240, as `cargo run --release --package report` in the
/// repository measures them: at most 2 x 2 pixels are one, and at least one reflection is followed.
const FRONT: ParetoFront = ParetoFront::new(&[
    point(1, 2, 62, (3440, 145)),
    point(2, 2, 65, (3655, 145)),
    point(4, 1, 154, (7177, 2)),
]);

const fn point(reflections: u8, scale: u8, instructions: u32, error: (u16, u8)) -> FrontPoint {
    let (psnr, largest) = error;
    FrontPoint {
        prepare: 3425,
        instructions,
        reflections,
        level: QualityLevel::Fast,
        scale,
        psnr,
        largest,
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    rtt_init_print!();
    let Board { mut display, key } = board::switch_on();
    let mut motion = Motion::START;
    loop {
        let start = DWT::cycle_count();
        let rests = motion.rests();
        let budget = if rests { u64::MAX } else { BUDGET };
        let point = FRONT.choose(Size::new_equal(SIDE), budget).point;
        let scale = point.scale.into();
        // A key ends the picture at rest. A frame of what moves is drawn to its end.
        let stop = || rests && key.is_pressed();
        motion
            .with_rows(point.reflections, scale, |rows| {
                draw(rows, scale, &mut display, stop)
            })
            .expect("the display takes every row");
        let cycles = DWT::cycle_count().wrapping_sub(start);
        rprintln!("frame: {} ms", cycles / (CORE_MHZ * 1000));
        motion.advance(FRAME);
        while rests && !key.is_pressed() {}
        if key.is_pressed() {
            motion.throw(1);
        }
    }
}

/// Draws rows of which each pixel covers `scale` by `scale` of the display, until `stop` returns `true`.
fn draw<D: DrawTarget<Color = Rgb565>>(
    rows: &Rows<'_, MovingScene<Bounce>>,
    scale: u32,
    display: &mut D,
    stop: impl Fn() -> bool,
) -> Result<(), D::Error> {
    let [mut row, mut wide] = [[Rgb565::BLACK; SIDE as usize]; 2];
    let row = &mut row[..(SIDE / scale) as usize];
    for area in areas(scale) {
        rows.row(area.start / scale, 0, row);
        for (pixels, color) in wide.chunks_exact_mut(scale as usize).zip(&*row) {
            pixels.fill(*color);
        }
        let at = Point::new(0, area.start as i32);
        let pixels = repeat_n(&wide, area.len()).flatten().copied();
        let area = Rectangle::new(at, Size::new(SIDE, area.len() as u32));
        display.fill_contiguous(&area, pixels)?;
        if stop() {
            break;
        }
    }
    Ok(())
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
