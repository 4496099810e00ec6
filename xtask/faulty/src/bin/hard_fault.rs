//! Firmware that executes an undefined instruction. The board's own fault handler prints the fault.
#![no_std]
#![no_main]

#[path = "../../../../examples/board/firmware/fault.rs"]
mod fault;

use cortex_m_rt::entry;
use semihosting::println;

#[entry]
fn main() -> ! {
    println!("so far, so good");
    cortex_m::asm::udf()
}
