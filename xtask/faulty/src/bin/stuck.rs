//! Firmware that executes an undefined instruction, and then hangs in a fault handler that prints
//! nothing.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting as _;

#[entry]
fn main() -> ! {
    cortex_m::asm::udf()
}
