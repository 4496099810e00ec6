//! Measures how deep the stack has been. It paints the free part of the stack; words that are still
//! painted later were not used. The firmware that measures has this file, too.
//!
//! Relies on the linker scripts of `cortex-m-rt` and `riscv-rt`, where the stack grows from the end
//! of RAM down to the static variables.

use core::ptr;

const PAINT: u32 = 0x5afe_57ac;

/// Bytes below the stack frame of [`paint`] that it leaves unpainted.
const MARGIN: usize = 64;

/// Largest depth that is painted, in bytes, so that painting is quick on a board with much RAM.
const DEPTH: usize = 64 * 1024;

unsafe extern "C" {
    // From the linker script: the end of the static variables, and the start of the stack.
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
        // Sound: no variable lives between the static variables and this frame.
        unsafe {
            word.write_volatile(PAINT);
            word = word.add(1);
        }
    }
}

/// Returns the most bytes of stack that were in use since [`paint`], counted from the stack's start.
/// 64 KiB means that or more.
pub fn peak() -> u32 {
    let start = &raw mut _stack_start;
    let mut word = floor();
    // Sound: all of this memory belongs to the stack.
    while word < start && unsafe { word.read_volatile() } == PAINT {
        word = unsafe { word.add(1) };
    }
    (start as usize - word as usize) as u32
}

/// Returns the lowest word that is painted.
fn floor() -> *mut u32 {
    let (end, start) = (&raw mut __sheap as usize, &raw mut _stack_start as usize);
    end.max(start.saturating_sub(DEPTH)) as *mut u32
}
