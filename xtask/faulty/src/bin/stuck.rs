//! Executes what is no instruction, and stays in a handler that says nothing.
#![no_std]
#![no_main]

use cortex_m_rt::entry;
use semihosting as _;

#[entry]
fn main() -> ! {
    cortex_m::asm::udf()
}
