//! Handler of hard faults: prints the fault's name, its address and its cause, and ends the program.

use cortex_m::peripheral::SCB;
use cortex_m_rt::{ExceptionFrame, exception};
use semihosting::{eprintln, process};

#[exception]
unsafe fn HardFault(frame: &ExceptionFrame) -> ! {
    // SAFETY: the register is always there and reading it changes nothing.
    let status = unsafe { (*SCB::PTR).cfsr.read() };
    eprintln!("HardFault ({}) at {:#010x}", cause(status), frame.pc());
    process::exit(1)
}

/// Returns the cause in the Configurable Fault Status Register; ARMv7-M Architecture Reference
/// Manual, B3.2.15.
fn cause(status: u32) -> &'static str {
    match status {
        0 => "no cause known",
        0x0000_0001..=0x0000_00ff => "memory protection",
        0x0000_0100..=0x0000_01ff => "bus: instruction fetch",
        0x0000_0200..=0x0000_ffff => "bus: data access",
        0x0001_0000..=0x0001_ffff => "undefined instruction",
        0x0002_0000..=0x0007_ffff => "invalid state",
        0x0008_0000..=0x000f_ffff => "no coprocessor",
        0x0100_0000..=0x01ff_ffff => "unaligned access",
        _ => "division by zero",
    }
}
