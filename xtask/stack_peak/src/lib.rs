//! How deep the stack has been: what is free is painted, and what is still painted was not used.
//!
//! Knows the linker scripts of `cortex-m-rt` and `riscv-rt`, where the stack grows from the end of
//! RAM down to the static variables.
#![no_std]
#![deny(missing_docs)]

use core::ptr;

const PAINT: u32 = 0x5afe_57ac;

/// Left alone below the frame that paints.
const MARGIN: usize = 64;

/// How deep the stack is painted at most, so that much RAM does not take long.
const DEPTH: usize = 64 * 1024;

unsafe extern "C" {
    // From the linker script: where the static variables end, and where the stack begins.
    static mut __sheap: u32;
    static mut _stack_start: u32;
}

/// Paints the free part of the stack.
#[inline(never)]
pub fn paint() {
    let here = 0_u32;
    let end = (ptr::from_ref(&here) as usize - MARGIN) as *mut u32;
    let mut word = floor();
    while word < end {
        // Sound: between the static variables and this frame nothing lives.
        unsafe {
            word.write_volatile(PAINT);
            word = word.add(1);
        }
    }
}

/// The most bytes the stack has held since it was painted, counted from its very beginning; 64 KiB
/// stands for that and more.
pub fn peak() -> u32 {
    let start = &raw mut _stack_start;
    let mut word = floor();
    // Sound: all of this is the stack's memory.
    while word < start && unsafe { word.read_volatile() } == PAINT {
        word = unsafe { word.add(1) };
    }
    (start as usize - word as usize) as u32
}

/// The lowest word that is painted.
fn floor() -> *mut u32 {
    let (end, start) = (&raw mut __sheap as usize, &raw mut _stack_start as usize);
    end.max(start.saturating_sub(DEPTH)) as *mut u32
}
