//! Reciprocal square roots and reciprocals, and the square roots and quotients computed from them.
//!
//! A table gives the start y₀, and one Householder step of third order refines it (Householder 1970;
//! Muller et al., Handbook of Floating-Point Arithmetic, section 4.7). With e = 1 - x y₀², the
//! reciprocal root is y₀ (1 + e/2 + 3e²/8). The first term left out, 5e³/16, is below 2⁻²⁸, because the
//! table has 256 entries per unit. Rounding adds about as much.

use super::narrow::{
    difference_modulo_2_32, low_word, narrowed_unsigned, plus_signed, shifted_left, signed,
    signed_difference, to_u16, to_u32, unsigned,
};
use super::product::{scaled, scaled_unsigned};
use super::{Unit, high_unsigned, leading_zeros};

/// Start values for reciprocal roots and reciprocals. From entry 256 on, entry i is 2¹⁶ / √x at the
/// middle of x = i/256 .. (i + 1)/256, for x from 1 to 4. The first 256 entries are 2¹⁶ / x at the
/// middle of x = 1 + i/256 .. 1 + (i + 1)/256.
static TABLE: [u16; 1024] = table();

/// Computes the table of start values.
const fn table() -> [u16; 1024] {
    let mut entries = [0; 1024];
    let mut index = 0;
    while index < 256 {
        let middle = 2 * (256 + to_u32(index)) + 1;
        entries[index] = to_u16(((1 << 25) + middle / 2) / middle);
        index += 1;
    }
    while index < 1024 {
        // 2^16 / √((2 index + 1) / 512) = √(2^41 / (2 index + 1))
        let square = (1_u64 << 41) * 4 / (2 * index as u64 + 1);
        let twice = square.isqrt();
        let rounded = twice.div_ceil(2);
        entries[index] = if rounded > 0xffff {
            0xffff
        } else {
            to_u16(narrowed_unsigned(rounded))
        };
        index += 1;
    }
    entries
}

/// Returns the reciprocal root 2³¹ / √x for x = `mantissa` · 2⁻³⁰, 1 to 4. The result is in Q1.31, from
/// 2³⁰ to 2³¹ - 1.
///
/// The relative error is below 2⁻²⁷·⁵.
pub const fn reciprocal_root(mantissa: u32) -> i32 {
    debug_assert!(mantissa >= 1 << 30);
    let start = TABLE[(mantissa >> 22) as usize] as u32;
    // Q30 · Q32 >> 32: x y₀² in Q30, within 2⁻⁸ of one.
    let product = signed(high_unsigned(mantissa, start * start));
    let error = (1 << 30) - product;
    let coarse = error >> 6;
    // Within ±2²¹·⁵, so that `scaled` can shift it up and take the high word of its product with the
    // start.
    let correction = (error >> 1) + signed((3 * unsigned(coarse * coarse)) >> 21);
    let refined = scaled(correction, start);
    // If x is 1, the start is too small and the terms left out are negative: the sum stays below 2³¹.
    signed(plus_signed(start << 15, refined))
}

/// Normalises a squared length. Returns the left shift that brings a vector of that squared length to a
/// length of 2³⁰ to 2³¹, and the square of the new length · 2⁻³⁰, ready for [`reciprocal_root`].
///
/// `square` is 1 to 2⁶² - 1. Its lowest bit is set, so that 0 needs no test. This makes an even square
/// larger by 1: a relative error below 2⁻²⁶ for lengths from 2¹³ on.
pub const fn unit_shift(square: u64) -> (u32, u32) {
    debug_assert!(square < 1 << 62);
    let (leading, rest) = ((square >> 32) as u32, low_word(square) | 1);
    if leading == 0 {
        let zeros = leading_zeros(rest) & !1;
        return (15 + zeros / 2, rest << zeros);
    }
    let zeros = leading_zeros(leading) & !1;
    (
        difference_modulo_2_32(zeros / 2, 1) & 31,
        (leading << zeros) | ((rest >> 1) >> (31 - zeros)),
    )
}

/// Returns the square root of `square`, which is below 2⁶². The root has a relative error below 2⁻²⁷ and
/// is rounded down.
pub const fn square_root(square: u64) -> i32 {
    let (shift, mantissa) = unit_shift(square);
    let root = high_unsigned(mantissa, unsigned(reciprocal_root(mantissa)) << 1);
    signed(root >> shift) & -((square != 0) as i32)
}

/// Quotient `mantissa` · 2^`exponent`. The mantissa is 2³⁰ - 1 to 2³².
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Quotient {
    /// Leading bits of the quotient.
    pub mantissa: u32,
    /// Power of two by which the mantissa is scaled.
    pub exponent: i32,
}

/// Returns the square root of a number from 0 to 1, in Q2.30, with a relative error below 2⁻²⁷.
pub const fn root_of_unit(square: Unit) -> Unit {
    let square = unsigned(square.to_bits()) | 1;
    let zeros = leading_zeros(square) & !1;
    let mantissa = square << zeros;
    let root = high_unsigned(mantissa, unsigned(reciprocal_root(mantissa)) << 1) >> (zeros / 2);
    // √(2³⁰) · 2¹⁵
    Unit::from_bits(signed(root))
}

/// Returns the reciprocal 2³¹ / x for x = `mantissa` · 2⁻³¹, 1 to 2, with a relative error below 2⁻²⁶.
///
/// The table gives the start y₀. One step of third order refines it: y₀ (1 + e + e²) with e = 1 - x y₀
/// below 2⁻⁹.
const fn reciprocal(mantissa: u32) -> u32 {
    let start = TABLE[(mantissa >> 23) as usize & 0xff] as u32;
    // Signed, within ±2²¹.
    let error = signed_difference(1 << 30, scaled_unsigned(mantissa, start));
    let coarse = error >> 7;
    let correction = error + ((coarse * coarse) >> 16);
    let refined = scaled(correction, start);
    // If x is 1, the start is too small and the term left out is negative: the sum stays below 2³¹.
    plus_signed(start << 15, refined)
}

/// Returns 2³⁰ · `numerator` / `denominator`, with a relative error below 2⁻²⁶. The numerator is below
/// the denominator, which is 1 to 2³⁰.
#[inline(always)]
pub const fn ratio(numerator: u32, denominator: u32) -> i32 {
    // The compiler does not know that the denominator is not 0, which would have 32 leading zeros.
    let zeros = leading_zeros(denominator);
    let reciprocal = reciprocal(shifted_left(denominator, zeros));
    signed(high_unsigned(shifted_left(numerator, zeros), reciprocal))
}

/// Returns `part` / `whole`, `None` if it is not below 1. `part` is not below 0.
pub const fn share_of(part: i32, whole: i32) -> Option<Unit> {
    match part < whole {
        true => Some(Unit::from_bits(ratio(unsigned(part), unsigned(whole)))),
        false => None,
    }
}

/// Returns `length` / `sine`, with a relative error below 2⁻²⁶ and rounded towards 0. `None` if it is 2³⁰ or
/// more in magnitude.
pub const fn over(length: i32, sine: Unit) -> Option<i32> {
    let Quotient { mantissa, exponent } =
        divide(length.unsigned_abs() as u64, sine.to_bits().unsigned_abs());
    let way = match exponent + 30 {
        0.. => return None,
        -31..=-1 => mantissa >> -(exponent + 30),
        _ => 0,
    };
    if way >= 1 << 30 {
        return None;
    }
    let way = signed(way);
    Some(if (length < 0) == (sine.to_bits() < 0) {
        way
    } else {
        -way
    })
}

/// Returns `numerator` / `denominator`, with a relative error below 2⁻²⁶. The denominator is
/// 1 to 2³² - 1. The numerator is at least 1; 0 counts as 1.
pub const fn divide(numerator: u64, denominator: u32) -> Quotient {
    let numerator = numerator | 1;
    let denominator = denominator | (denominator == 0) as u32;
    let up = leading_zeros(denominator);
    let zeros = numerator.leading_zeros();
    let leading = ((numerator << zeros) >> 32) as u32;
    Quotient {
        mantissa: high_unsigned(leading, reciprocal(denominator << up) << 1),
        exponent: 1 + signed(up) - signed(zeros),
    }
}

#[cfg(test)]
mod tests;
