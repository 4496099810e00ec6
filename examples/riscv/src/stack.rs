//! How deep the stack has been: what is free is painted, and what is still painted was not used.

use core::ptr;

const PAINT: u32 = 0x5afe_57ac;

/// Bytes below the stack frame of [`paint`] that it leaves unpainted.
const MARGIN: usize = 64;

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
    let mut word = &raw mut __sheap;
    while word < end {
        // Sound: between the static variables and this frame nothing lives.
        unsafe {
            word.write_volatile(PAINT);
            word = word.add(1);
        }
    }
}

/// The most bytes that the stack has held since it was painted, counted from its beginning.
pub fn peak() -> u32 {
    let start = &raw mut _stack_start;
    let mut word = &raw mut __sheap;
    // Sound: all of this is the stack's memory.
    while word < start && unsafe { word.read_volatile() } == PAINT {
        word = unsafe { word.add(1) };
    }
    (start as usize - word as usize) as u32
}
