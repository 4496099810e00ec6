//! Firmware that panics.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting::println;

#[entry]
fn main() -> ! {
    println!("so far, so good");
    panic!("out of tea")
}
