//! Draws the castle, 240 pixels wide, on a Cortex-M0 or an RV32IMAC core with 16 KB of RAM, and counts and
//! hashes its rows.
//!
//! Its line on the semihosting console shows that the picture is the same as on every other machine,
//! and the peak of the stack, which includes the buffer for half a row. The RAM in use is this peak
//! plus the static variables.
#![no_std]
#![no_main]

mod stack;

#[cfg(target_arch = "arm")]
use cortex_m_rt::entry;
use embedded_graphics::{
    geometry::Size,
    pixelcolor::{Rgb888, RgbColor},
};
use reflet::scenes::{BuiltIn, Castle};
#[cfg(target_arch = "riscv32")]
use riscv_rt::entry;
use semihosting::{println, process::exit};

/// Width and height of the picture.
const SIDE: u32 = 240;

#[entry]
fn main() -> ! {
    stack::paint();
    let (rows, hash) = draw();
    let stack = stack::peak();
    println!("castle {SIDE}x{SIDE}: {rows} rows, hash {hash:016x}, stack {stack} bytes");
    exit(0)
}

/// Reports an exception and ends the program with an error.
#[cfg(target_arch = "riscv32")]
#[unsafe(export_name = "ExceptionHandler")]
fn fault(_: &riscv_rt::TrapFrame) -> ! {
    println!("fault: exception");
    exit(1)
}

/// Draws the picture row by row, each in two halves because RAM is short. Returns the number of rows
/// and the hash of all pixels.
#[inline(never)]
fn draw() -> (u32, u64) {
    const HALF: u32 = SIDE / 2;
    let mut row = [Rgb888::BLACK; HALF as usize];
    let frame = Castle::frame(&Castle::CAMERA).prepare(Size::new_equal(SIDE));
    let picture = frame.on(&Castle).expect("a constant scene never changes");
    let mut hash = HASH_OF_NOTHING;
    let mut rows = 0;
    for y in 0..SIDE {
        for left in [0, HALF] {
            picture.row(y, left, &mut row);
            for pixel in &row {
                hash = hashed(hash, [pixel.r(), pixel.g(), pixel.b()]);
            }
        }
        rows += 1;
    }
    (rows, hash)
}

/// FNV-1a hash of no bytes, 64 bits.
const HASH_OF_NOTHING: u64 = 0xcbf2_9ce4_8422_2325;

/// Returns the hash with the bytes of one more pixel.
fn hashed(hash: u64, pixel: [u8; 3]) -> u64 {
    let add = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    pixel.into_iter().fold(hash, add)
}
