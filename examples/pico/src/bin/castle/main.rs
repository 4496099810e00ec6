//! Shows reflet's castle, or a scene of yours, by both cores. The arrow keys orbit the camera. With the feature
//! `smooth`, the select key makes edges smooth, or jagged again.

#![no_std]
#![no_main]

#[path = "../../board.rs"]
mod board;
#[allow(dead_code, reason = "cores are not counted")]
#[path = "../../cores.rs"]
mod cores;
#[allow(dead_code, reason = "what counts is that a key is pressed")]
#[path = "../../keys.rs"]
mod keys;
mod scene;
#[path = "../../screen/mod.rs"]
mod screen;
mod view;

use core::panic::PanicInfo;

use reflet::display::coarse_first;
use rtt_target::{rprintln, rtt_init_print};

use crate::cores::Cores;
use crate::keys::{Keys, Request};
use crate::screen::SIDE;
use crate::view::View;
// For a scene of yours, change this line: `scene.rs` says how.
use crate::scene::{CAMERA, Castle as Shown};

#[board::entry]
fn main() -> ! {
    rtt_init_print!();
    let mut board = board::switch_on();
    let mut keys = Keys::new(board.keys, board.timer);
    let mut cores = Cores::new(board.second_core, board.timer);
    let mut view = View {
        camera: CAMERA,
        is_smooth: false,
    };
    loop {
        let start = board.timer.get_counter();
        view.with_rows(|rows| {
            let areas = coarse_first(SIDE);
            cores.draw((&view, rows), areas, &mut board.screen, || None::<()>);
        });
        let time = board.timer.get_counter() - start;
        rprintln!("picture: {} ms", time.to_millis());
        match keys.wait() {
            Request::Orbit(azimuth, elevation) => {
                // A camera cannot look along its `up`: then it keeps its place.
                let turned = view.camera.orbited(azimuth, elevation);
                view.camera = turned.unwrap_or(view.camera);
            }
            // Without the feature `smooth` the picture stays as it is.
            Request::Select => view.is_smooth = !view.is_smooth,
        }
    }
}

/// Prints the panic's message to a connected debugger, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    rprintln!("{}", info);
    cortex_m::asm::udf()
}
