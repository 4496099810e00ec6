//! Exact products of two 32-bit numbers.
//!
//! A core with a long multiply takes one instruction for each of these products. Armv6-M (Cortex-M0) has
//! no long multiply, so the compiler would call a routine that multiplies 64 by 64 bits. There, a product is
//! the sum of four products of 16 by 16 bits (Warren, Hacker's Delight, section 8-2). The result is the same.

use super::narrow::narrowed;

pub use multiplier::{high, high_unsigned, scaled_unsigned, wide, wide_positive, wide_unsigned};

/// Returns the high word of the product of two numbers, neither of which is below 0: `a` · `b` · 2⁻³²,
/// rounded down.
#[inline(always)]
pub const fn high_positive(a: i32, b: i32) -> i32 {
    (wide_positive(a, b) >> 32) as i32
}

/// Returns `sum` + `a` · `b` · 2⁻³², rounded to nearest. Neither factor is below 0.
///
/// `sum` and the half for rounding share one register pair: high word and low word. So a core with a
/// long multiply-add takes no more instructions than for a sum that is rounded down.
#[inline(always)]
pub const fn add_high_positive(sum: i32, a: i32, b: i32) -> i32 {
    let half = 1_i64 << 31;
    narrowed((((sum as i64) << 32) + half + wide_positive(a, b)) >> 32)
}

/// Whether the core is an Armv6-M (Cortex-M0): it has no long multiply and counts no zeros. These are the Arm cores without
/// atomic exchanges.
pub const IS_ARMV6_M: bool = cfg!(all(target_arch = "arm", not(target_has_atomic = "32")));

#[cfg(not(all(target_arch = "arm", not(target_has_atomic = "32"))))]
mod multiplier {
    use crate::number::narrow::{signed_wide, unsigned};

    /// Returns the 64-bit product of two signed numbers.
    #[inline(always)]
    pub const fn wide(a: i32, b: i32) -> i64 {
        a as i64 * b as i64
    }

    /// Returns the 64-bit product of two unsigned numbers.
    #[inline(always)]
    pub const fn wide_unsigned(a: u32, b: u32) -> u64 {
        a as u64 * b as u64
    }

    /// Returns the 64-bit product of two numbers, neither of which is below 0. A signed product takes
    /// three instructions if the compiler knows of only one factor that it is not negative.
    #[inline(always)]
    pub const fn wide_positive(a: i32, b: i32) -> i64 {
        signed_wide(wide_unsigned(unsigned(a), unsigned(b)))
    }

    /// Returns the high word of the product of two signed numbers: `a` · `b` · 2⁻³², rounded down.
    #[inline(always)]
    pub const fn high(a: i32, b: i32) -> i32 {
        (wide(a, b) >> 32) as i32
    }

    /// Returns the high word of the product of two unsigned numbers: `a` · `b` · 2⁻³², rounded down.
    #[inline(always)]
    pub const fn high_unsigned(a: u32, b: u32) -> u32 {
        (wide_unsigned(a, b) >> 32) as u32
    }

    /// Returns `a` · `short` · 2⁻¹⁷, rounded down. `short` is below 2¹⁶.
    #[inline(always)]
    pub const fn scaled_unsigned(a: u32, short: u32) -> u32 {
        high_unsigned(a, short << 15)
    }
}

#[cfg(all(target_arch = "arm", not(target_has_atomic = "32")))]
use halves as multiplier;

#[cfg(any(test, all(target_arch = "arm", not(target_has_atomic = "32"))))]
#[cfg_attr(
    not(test),
    expect(
        clippy::cast_possible_wrap,
        clippy::cast_sign_loss,
        reason = "halves are put together modulo 2³²"
    )
)]
mod halves {
    /// Returns the low 16 bits of a number as an unsigned value.
    const fn low_half(a: i32) -> i32 {
        a & 0xffff
    }

    #[inline(always)]
    pub const fn high(a: i32, b: i32) -> i32 {
        let (a_low, a_high, b_low, b_high) = (low_half(a), a >> 16, low_half(b), b >> 16);
        let low = a_low.wrapping_mul(b_low) as u32;
        // `first` and `second` are both within ±2³¹.
        let first = a_high * b_low + (low >> 16) as i32;
        let second = a_low * b_high + low_half(first);
        a_high * b_high + (first >> 16) + (second >> 16)
    }

    #[inline(always)]
    pub const fn wide(a: i32, b: i32) -> i64 {
        ((high(a, b) as i64) << 32) | a.wrapping_mul(b) as u32 as i64
    }

    #[inline(always)]
    pub const fn wide_positive(a: i32, b: i32) -> i64 {
        wide(a, b)
    }

    /// Returns `a` · `short` · 2⁻¹⁷, rounded down. Takes two products, because the upper half of `short`
    /// is 0.
    #[inline(always)]
    pub const fn scaled_unsigned(a: u32, short: u32) -> u32 {
        ((a >> 16) * short + (((a & 0xffff) * short) >> 16)) >> 1
    }

    /// Returns the high word of the product of two unsigned numbers, computed from the signed product.
    /// The compiler would recognise a direct sum of unsigned halves and call the product of 64 by 64
    /// bits.
    #[inline(always)]
    pub const fn high_unsigned(a: u32, b: u32) -> u32 {
        let (a, b) = (a as i32, b as i32);
        let signs = ((a >> 31) & b).wrapping_add((b >> 31) & a);
        high(a, b).wrapping_add(signs) as u32
    }

    #[inline(always)]
    pub const fn wide_unsigned(a: u32, b: u32) -> u64 {
        ((high_unsigned(a, b) as u64) << 32) | a.wrapping_mul(b) as u64
    }
}

#[cfg(test)]
mod tests;
