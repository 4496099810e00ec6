//! Reciprocal square roots and reciprocals, and the square roots and quotients computed from them.
//!
//! A table gives the start y₀, and one Newton step refines it (Muller et al., Handbook of Floating-Point
//! Arithmetic, section 4.7). With e = 1 - x y₀², the reciprocal root is y₀ (1 + e/2). The table holds y₀ at 64
//! points per unit, and a straight line between two points is within 2⁻¹⁵ of the root, so |e| is below 2⁻¹⁴.
//! The first term left out, 3e²/8, is below 2⁻²⁹. Rounding adds more.

use super::narrow::{
    difference_modulo_2_32, low_word, narrowed_unsigned, plus_signed, shifted_left, signed,
    signed_difference, signed_wide, to_u16, unsigned, unsigned_wide,
};
use super::product::scaled_unsigned;
use super::{Unit, high_unsigned, leading_zeros};

/// Start values, at points between which lines are drawn: first 2¹⁶ / x for x from 1 to 2, then 2¹⁶ / √x for x from
/// 1 to 4, both in steps of 1/64.
static TABLE: [u16; 258] = {
    /// Returns a start value with 12 fraction bits for x = `index` / 64.
    const fn curve(index: usize, is_root: bool) -> i64 {
        let index = index as u64;
        signed_wide(if is_root { ((1 << 62) / index).isqrt() } else { (1 << 34) / index })
    }
    let mut entries = [0; 258];
    let mut place = 0;
    while place < entries.len() {
        let is_root = place >= RECIPROCALS;
        let index = 64 + if is_root { place - RECIPROCALS } else { place };
        let value = curve(index, is_root);
        let bend = curve(index - 1, is_root) - 2 * value + curve(index + 1, is_root);
        // A line lies above the curve, by up to an eighth of the second difference. Half of that is taken off, so
        // that it lies above and below. Values are rounded down, because those between two are rounded up.
        entries[place] = to_u16(narrowed_unsigned(unsigned_wide((value - bend / 16) >> 12)));
        place += 1;
    }
    entries
};

/// Number of points of the reciprocal.
const RECIPROCALS: usize = 65;

/// Returns the value of the line from a point of the table to the next, `way` · 2⁻¹¹ of the way to it.
#[inline(always)]
const fn on_line(point: usize, way: u32) -> u32 {
    let [before, after] = [TABLE[point] as u32, TABLE[point + 1] as u32];
    before - (((before - after) * way) >> 11)
}

/// Returns the reciprocal root 2³¹ / √x for x = `mantissa` · 2⁻³⁰, 1 to 4. The result is in Q1.31, from
/// 2³⁰ to 2³¹ - 1.
///
/// The relative error is below 2⁻²⁷·⁵.
pub const fn reciprocal_root(mantissa: u32) -> i32 {
    debug_assert!(mantissa >= 1 << 30);
    // From 64 / 64 to 255 / 64.
    let point = (mantissa >> 24) as usize + RECIPROCALS - 64;
    let start = on_line(point, (mantissa >> 13) & 0x7ff);
    // Q30 · Q32 >> 32: x y₀² in Q30. The error is within ±2¹⁶, so that its half times the start fits.
    let error = (1 << 30) - signed(high_unsigned(mantissa, start * start));
    signed(start << 15) + (((error >> 1) * signed(start)) >> 15)
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
    let zeros = leading_zeros(leading);
    // Half of them less one, in two instructions.
    let shift = (difference_modulo_2_32(zeros, 2) >> 1) & 31;
    let zeros = zeros & !1;
    (shift, (leading << zeros) | ((rest >> 1) >> (31 - zeros)))
}

/// Returns what [`root_of_square`] returns. It is never inlined, which saves flash where a root is not taken for each
/// ray.
#[inline(never)]
pub const fn square_root(square: u64) -> i32 {
    root_of_square(square)
}

/// Returns the square root of `square`, which is below 2⁶². The root has a relative error below 2⁻²⁷ and
/// is rounded down.
pub const fn root_of_square(square: u64) -> i32 {
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
/// A line of the table gives the start y₀, and one Newton step refines it: y₀ (1 + e) with e = 1 - x y₀ within
/// ±2⁻¹⁴. The term left out, e², is below 2⁻²⁸.
const fn reciprocal(mantissa: u32) -> u32 {
    debug_assert!(mantissa >= 1 << 31);
    let point = (mantissa >> 25) as usize & 0x3f;
    let start = on_line(point, (mantissa >> 14) & 0x7ff);
    // Signed, within ±2¹⁶.
    let error = signed_difference(1 << 30, scaled_unsigned(mantissa, start));
    plus_signed(start << 15, ((error >> 1) * signed(start)) >> 14)
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
