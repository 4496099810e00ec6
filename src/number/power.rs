//! Powers of a cosine: sˢʰⁱⁿⁱⁿᵉˢˢ of the specular highlight.
//!
//! The integer part of the exponent uses repeated squaring (Knuth, The Art of Computer Programming, vol.
//! 2, 4.6.3), which keeps the relative error near exponent · 2⁻³⁰. Only the fraction, below one, uses a
//! logarithm.

use super::narrow::{
    low_word, narrowed, narrowed_128, narrowed_unsigned, narrowed_unsigned_128, signed, unsigned,
    unsigned_wide,
};
use super::{Number, Unit, high_unsigned, unit_product};

/// Real exponent from 0 to [`Exponent::MAX`], split into its integer part and its fraction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exponent {
    /// Integer part of the exponent.
    whole: u32,
    /// Fraction of the exponent, Q0.32.
    fraction: u32,
}

impl Exponent {
    /// Tests whether the exponent is an even integer.
    #[inline(always)]
    pub const fn is_even(self) -> bool {
        self.is_whole() && self.whole & 1 == 0
    }

    /// Returns the smallest integer above the exponent.
    #[inline(always)]
    pub const fn next_integer(self) -> u32 {
        self.whole + 1
    }

    /// Tests whether the exponent is an integer.
    #[inline(always)]
    pub const fn is_whole(self) -> bool {
        self.fraction == 0
    }

    /// Largest shininess of a highlight: 2²⁰.
    pub const MAX: i64 = 1 << 20;

    /// Splits a number into integer part and fraction. The fraction is rounded down to 2⁻³². The caller
    /// has checked that the number is within 0 to [`Exponent::MAX`].
    pub const fn new(number: Number) -> Self {
        let bits = number.to_bits();
        Self {
            whole: unsigned(narrowed(narrowed_128(bits >> 64))),
            fraction: low_word(unsigned_wide(narrowed_128(bits >> 32))),
        }
    }
}

/// Returns `base` to the power of `exponent`, for a base from 0 to 1. 0⁰ is 1.
///
/// The error is below (exponent + 4) · 2⁻²⁸.
#[inline(always)]
pub const fn power(base: Unit, exponent: Exponent) -> Unit {
    let whole = repeated(base, exponent.whole);
    if exponent.fraction == 0 {
        whole
    } else {
        unit_product(whole, fractional_power(base, exponent.fraction))
    }
}

/// Returns the power of a base, given the `square` of the base. The exponent must be even, so that no
/// root is needed.
#[inline(always)]
pub const fn even_power(square: Unit, exponent: Exponent) -> Unit {
    repeated(square, exponent.whole / 2)
}

/// Returns `base` to the power of an integer `exponent`, for a base from 0 to 1. 0⁰ is 1.
#[inline(always)]
pub const fn whole_power(base: Unit, exponent: Exponent) -> Unit {
    repeated(base, exponent.whole)
}

/// Returns `base` to the power of an integer by repeated squaring. Works in Q0.32, where a product is
/// the high word of the 64-bit product.
#[inline(always)]
const fn repeated(base: Unit, exponent: u32) -> Unit {
    let base = base.to_bits();
    if base >= 1 << 30 || exponent == 0 {
        return Unit::ONE;
    }
    let mut square = unsigned(base) << 2;
    let mut rest = exponent;
    while rest & 1 == 0 {
        square = high_unsigned(square, square);
        rest >>= 1;
    }
    let mut result = square;
    rest >>= 1;
    while rest != 0 {
        square = high_unsigned(square, square);
        if rest & 1 == 1 {
            result = high_unsigned(result, square);
        }
        rest >>= 1;
    }
    Unit::from_bits(signed(result >> 2))
}

/// Number of intervals per octave in the tables of logarithms and powers of two.
const STEPS: usize = 32;

/// Table for logarithms. Entry i has the reciprocal of the middle of interval i of 1 to 2, in Q30, and
/// -log₂ of exactly that reciprocal, in Q30.
static LOGARITHMS: [(u32, u32); STEPS] = {
    let mut table = [(0, 0); STEPS];
    let mut index = 0;
    while index < STEPS {
        let reciprocal = (1_u64 << 36) / (2 * index as u64 + 65);
        table[index] = (
            narrowed_unsigned(reciprocal),
            negative_logarithm(reciprocal),
        );
        index += 1;
    }
    table
};

/// Table of powers of two: entry i is 2^(i / 32) in Q30.
static POWERS: [u32; STEPS] = {
    // Five square roots of two give 2^(1/32) in Q60.
    let mut step = 2_u128 << 60;
    let mut halving = 0;
    while halving < 5 {
        step = (step << 60).isqrt();
        halving += 1;
    }
    let mut table = [0; STEPS];
    let mut value = 1_u128 << 60;
    let mut index = 0;
    while index < STEPS {
        table[index] = narrowed_unsigned(narrowed_unsigned_128((value + (1 << 29)) >> 30));
        value = (value * step) >> 60;
        index += 1;
    }
    table
};

/// Returns -log₂ of `value` · 2⁻³⁰ (0.5 to 1) in Q30. Each squaring gives one bit.
const fn negative_logarithm(value: u64) -> u32 {
    let mut square = (value as u128) << 33;
    let mut logarithm = 0_u32;
    let mut bit = 0;
    while bit < 31 {
        // `square` is 1 to 2 in Q62: at the start, twice the value, whose log₂ is 1 - the result.
        square = (square * square) >> 62;
        logarithm <<= 1;
        if square >= 1 << 63 {
            square >>= 1;
            logarithm |= 1;
        }
        bit += 1;
    }
    narrowed_unsigned((1 << 30) - ((logarithm as u64 + 1) >> 1))
}

/// One in Q30. The series below multiplies by constants such as `ONE / 3` instead of dividing.
const ONE: i64 = 1 << 30;

/// Natural logarithm of 2 in Q30.
const LN_2: i64 = 744_261_118;
/// Binary logarithm of e in Q30: 1 / ln 2.
const LOG2_E: i64 = 1_549_082_005;

/// Multiplies two Q30 numbers, rounded down.
const fn q30(a: i64, b: i64) -> i64 {
    (a * b) >> 30
}

/// Returns `base` (0 to 1) to the power of `fraction` (Q0.32, below one).
const fn fractional_power(base: Unit, fraction: u32) -> Unit {
    if base.to_bits() <= 0 {
        return Unit::ZERO;
    }
    let base = unsigned(base.to_bits());
    let zeros = base.leading_zeros() - 1;
    let mantissa = (base << zeros) as i64;
    // log₂ base in Q30, at most 0
    let logarithm = logarithm(mantissa) - ((zeros as i64) << 30);
    // The logarithm is within ±2^35. Times Q0.28, it is within ±2^63.
    let product = (logarithm * (fraction >> 4) as i64) >> 28;
    let whole = -(product >> 30);
    Unit::from_bits(narrowed(exponential(product & ((1 << 30) - 1)) >> whole))
}

/// Returns log₂ of a Q30 number from 1 to 2, in Q30.
const fn logarithm(mantissa: i64) -> i64 {
    let (reciprocal, base) =
        LOGARITHMS[narrowed_unsigned(unsigned_wide(mantissa >> 25)) as usize % STEPS];
    // |z| < 2⁻⁶: the fifth term of the series of ln(1 + z) is below 2⁻³².
    let z = q30(mantissa, reciprocal as i64) - (1 << 30);
    let z2 = q30(z, z);
    let series = z - (z2 >> 1) + q30(q30(z2, z), ONE / 3) - (q30(z2, z2) >> 2);
    base as i64 + q30(series, LOG2_E)
}

/// Returns 2 to the power of a Q30 number from 0 to 1, in Q30.
const fn exponential(fraction: i64) -> i64 {
    let start = POWERS[narrowed_unsigned(unsigned_wide(fraction >> 25)) as usize % STEPS] as i64;
    let z = q30(fraction & ((1 << 25) - 1), LN_2);
    let z2 = q30(z, z);
    let series = z + (z2 >> 1) + q30(q30(z2, z), ONE / 6) + q30(q30(z2, z2), ONE / 24);
    start + q30(start, series)
}

#[cfg(test)]
mod tests;
