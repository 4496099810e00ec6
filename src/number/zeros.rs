//! Floor 0: count of leading zeros.
//!
//! Most cores count leading zeros in one instruction. Armv6-M (Cortex-M0) cannot; there, a table gives
//! the count for the leading byte. This takes a third of the instructions of the compiler's routine.

use super::{IS_ARMV6_M, to_u8, to_u32};

/// Returns the number of leading zeros of a number; 32 for 0.
#[inline(always)]
pub const fn leading_zeros(number: u32) -> u32 {
    if IS_ARMV6_M { looked_up(number) } else { number.leading_zeros() }
}

/// Number of leading zeros of every 8-bit number.
static ZEROS: [u8; 256] = {
    let mut zeros = [8; 256];
    let mut number = 1;
    while number < 256 {
        zeros[number] = to_u8(to_u8(to_u32(number)).leading_zeros());
        number += 1;
    }
    zeros
};

#[inline(always)]
const fn looked_up(number: u32) -> u32 {
    let (mut leading, mut above) = (number, 16);
    if leading >> 16 != 0 {
        (leading, above) = (leading >> 16, 0);
    }
    if leading >> 8 != 0 {
        leading >>= 8;
    } else {
        above += 8;
    }
    above + ZEROS[(leading & 0xff) as usize] as u32
}

#[cfg(test)]
mod tests;
