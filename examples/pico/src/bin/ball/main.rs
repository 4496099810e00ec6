//! The smallest firmware: a golden ball over water, on one core and without keys.

#![no_std]
#![no_main]

#[allow(dead_code, reason = "keys and the second core are not used")]
#[path = "../../board.rs"]
mod board;
mod scene;
#[allow(dead_code, reason = "the picture draws itself")]
#[path = "../../screen/mod.rs"]
mod screen;

// For a scene of yours, write `scene.rs` by `cargo xtask scene FILE.json`, and change this line.
use crate::scene::{CAMERA, Harbour as Shown};

#[board::entry]
fn main() -> ! {
    let mut screen = board::switch_on().screen;
    let Ok(_) = Shown::frame(&CAMERA).draw(&mut screen);
    loop {
        core::hint::spin_loop();
    }
}

/// Stops.
#[panic_handler]
fn panic(_: &core::panic::PanicInfo<'_>) -> ! {
    cortex_m::asm::udf()
}
