//! Conversions of integers to fewer bits or to another sign, and sums modulo a power of two.
//!
//! Overflow checks do not cover `as` and `wrapping_add`. The functions here have a name and a range,
//! which `debug_assert!` checks. Without debug assertions, a function is only the operation itself.
//! Lints in `lib.rs` and `tests/floors` ensure that other files use these functions.

/// Writes conversions of a value to another type, which must be able to hold it.
macro_rules! conversions {
    ($($(#[$doc:meta])* $name:ident($from:ty) -> $to:ty, $fault:literal;)*) => {$(
        $(#[$doc])*
        #[inline(always)]
        #[cfg_attr(debug_assertions, track_caller)]
        pub const fn $name(value: $from) -> $to {
            debug_assert!(value as $to as i128 == value as i128, $fault);
            value as $to
        }
    )*};
}

conversions! {
    /// Converts an `i64` to an `i32`. The value must fit: -2³¹ to 2³¹ - 1.
    narrowed(i64) -> i32, "beyond an i32";

    /// Converts a `u64` to a `u32`. The value must fit: 0 to 2³² - 1.
    narrowed_unsigned(u64) -> u32, "beyond a u32";

    /// Converts an `i128` to an `i64`. The value must fit: -2⁶³ to 2⁶³ - 1.
    narrowed_128(i128) -> i64, "beyond an i64";

    /// Converts a `u128` to a `u64`. The value must fit: 0 to 2⁶⁴ - 1.
    narrowed_unsigned_128(u128) -> u64, "beyond a u64";

    /// Converts a `u32` to a `u8`. The value must fit: 0 to 255.
    to_u8(u32) -> u8, "beyond a u8";

    /// Converts a `u32` to a `u16`. The value must fit: 0 to 2¹⁶ - 1.
    to_u16(u32) -> u16, "beyond a u16";

    /// Converts a count or an index to a `u32`. The value must fit: 0 to 2³² - 1.
    to_u32(usize) -> u32, "beyond a u32";

    /// Converts an `i32` that is not negative to a `u32`: 0 to 2³¹ - 1.
    unsigned(i32) -> u32, "below zero";

    /// Converts an `i64` that is not negative to a `u64`: 0 to 2⁶³ - 1.
    unsigned_wide(i64) -> u64, "below zero";

    /// Converts a `u32` to an `i32`. The value must fit: 0 to 2³¹ - 1.
    signed(u32) -> i32, "beyond an i32";

    /// Converts a `u64` to an `i64`. The value must fit: 0 to 2⁶³ - 1.
    signed_wide(u64) -> i64, "beyond an i64";
}

/// Converts an `i128` to an `i32`, or returns `None` if it does not fit.
#[inline(always)]
pub const fn fitting(value: i128) -> Option<i32> {
    let low = value as i32;
    if low as i128 == value { Some(low) } else { None }
}

/// Returns the low 32 bits of any `u64`.
#[inline(always)]
pub const fn low_word(value: u64) -> u32 {
    value as u32
}

/// Converts an `i128` that is not negative to a `u128`: 0 to 2¹²⁷ - 1.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn unsigned_128(value: i128) -> u128 {
    debug_assert!(value >= 0, "below zero");
    value as u128
}

/// Returns the bits of any `i64` in two's complement: its value modulo 2⁶⁴.
#[inline(always)]
pub const fn twos_complement(value: i64) -> u64 {
    value as u64
}

/// Returns the `i64` that has these bits in two's complement.
#[inline(always)]
pub const fn from_twos_complement(bits: u64) -> i64 {
    bits as i64
}

/// Splits a number within ±(2³² - 1) into its low 32 bits and its sign, which is repeated in every bit
/// of a word: 0 or -1.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn word_and_sign(value: i64) -> (i32, i32) {
    debug_assert!(value.unsigned_abs() < 1 << 32, "beyond 32 bits and a sign");
    (value as i32, (value >> 63) as i32)
}

/// Returns the magnitude of a number that [`word_and_sign`] has split.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn magnitude(word: i32, sign: i32) -> u32 {
    debug_assert!(sign == 0 || (sign == -1 && word != 0), "no such sign");
    (word ^ sign).wrapping_sub(sign) as u32
}

/// Returns the magnitude of a number that is not -2³¹.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn absolute(value: i32) -> i32 {
    debug_assert!(value != i32::MIN, "beyond an i32");
    value.wrapping_abs()
}

/// Adds the signed `change` to `value`. The sum must be 0 to 2³² - 1.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn plus_signed(value: u32, change: i32) -> u32 {
    debug_assert!(value.checked_add_signed(change).is_some(), "beyond a u32");
    value.wrapping_add(change as u32)
}

/// Subtracts two unsigned numbers: `value` - `taken`. The difference must be -2³¹ to 2³¹ - 1.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn signed_difference(value: u32, taken: u32) -> i32 {
    let difference = value.wrapping_sub(taken) as i32;
    debug_assert!(
        value as i64 - taken as i64 == difference as i64,
        "beyond an i32"
    );
    difference
}

/// Subtracts a 64-bit number: `value` - `taken`. The difference must be -2³¹ to 2³¹ - 1; `taken` need
/// not fit 32 bits.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn minus_wide(value: i32, taken: i64) -> i32 {
    let difference = value.wrapping_sub(taken as i32);
    debug_assert!(value as i64 - taken == difference as i64, "beyond an i32");
    difference
}

/// Returns `value` · 2^`count`, which must be below 2³². `count` is below 32.
///
/// Takes no instruction to limit `count` to 31.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn shifted_left(value: u32, count: u32) -> u32 {
    let shifted = value.wrapping_shl(count);
    debug_assert!(count < 32 && shifted >> count == value, "beyond a u32");
    shifted
}

/// Returns `value` + `limit` modulo 2³². The result is at most 2 · `limit` if and only if `value` is
/// within ±`limit`. So one comparison tests two bounds.
///
/// `limit` must not be below 0.
#[inline(always)]
#[cfg_attr(debug_assertions, track_caller)]
pub const fn offset_modulo_2_32(value: i32, limit: i32) -> u32 {
    debug_assert!(limit >= 0, "a limit below zero");
    value.wrapping_add(limit) as u32
}

/// Returns `a` + `b` modulo 2³².
#[inline(always)]
pub const fn sum_modulo_2_32(a: u32, b: u32) -> u32 {
    a.wrapping_add(b)
}

/// Returns `a` - `b` modulo 2³².
#[inline(always)]
pub const fn difference_modulo_2_32(a: u32, b: u32) -> u32 {
    a.wrapping_sub(b)
}

/// Returns `a` · `b` modulo 2³².
#[inline(always)]
pub const fn product_modulo_2_32(a: u32, b: u32) -> u32 {
    a.wrapping_mul(b)
}

/// Returns `a` + `b` modulo 2⁶⁴.
#[inline(always)]
pub const fn sum_modulo_2_64(a: u64, b: u64) -> u64 {
    a.wrapping_add(b)
}

/// Returns a word with one bit set: 2^(`index` modulo 32).
#[inline(always)]
pub const fn bit_modulo_32(index: usize) -> u32 {
    1_u32.wrapping_shl(index as u32)
}

#[cfg(test)]
mod tests;
