//! Shows reflet's castle on an ESP32-C3 with an ST7789 of 240 by 240 pixels. The board's key orbits the
//! camera. The README has the wiring.

#![no_std]
#![no_main]

mod board;
mod scene;

use core::panic::PanicInfo;

use esp_hal::time::Instant;
use esp_println::println;

// For a scene of yours, change this line: `scene.rs` says how.
use crate::scene::{CAMERA, Castle as Shown};

// What the boot loader reads of a program.
esp_bootloader_esp_idf::esp_app_desc!();

#[esp_hal::main]
fn main() -> ! {
    let mut buffer = [0; 512];
    let mut board = board::switch_on(&mut buffer);
    let mut camera = CAMERA;
    loop {
        let start = Instant::now();
        Shown::frame(&camera)
            .draw(&mut board.display)
            .expect("the display takes every row");
        println!("picture: {} ms", start.elapsed().as_millis());
        board.key.wait();
        // A camera cannot look along its `up`: then it keeps its place.
        camera = camera.orbited(10, 0).unwrap_or(camera);
    }
}

/// Prints the panic's message, and stops.
#[panic_handler]
fn panic(info: &PanicInfo<'_>) -> ! {
    println!("{info}");
    loop {}
}
