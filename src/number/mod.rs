//! Floor 0: the number formats, and all shifts, roots and reciprocals.
//!
//! | format | type | used for |
//! |---|---|---|
//! | Q64.64 | [`Number`] | the numbers in descriptions of scenes and cameras |
//! | Q2.30 | [`Unit`] | directions, weights, cosines |
//! | Q6.26 | [`Brightness`] | colours and the light on a surface |
//! | Q32.0 | [`Length`] | positions and distances, in steps of a power of two that the scene chooses |
//! | Q12.20, Q6.26 | `i32` in [`crate::color`] | the light that a surface reflects |
//! | Q8.24 | `i32` in [`crate::color`] | the sum over reflections |
//!
//! Knows no scene, no ray and no colour.

mod angle;
mod decimal;
#[cfg_attr(
    not(test),
    expect(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        clippy::cast_sign_loss,
        reason = "the one place for such casts"
    )
)]
mod narrow;
mod parse;
mod power;
mod product;
mod root;
#[cfg(test)]
pub(crate) mod sweep;
mod zeros;

pub use angle::{cotangent_of_half, sine_and_cosine_of};
pub use decimal::Number;
pub(crate) use decimal::numbers;
#[cfg(feature = "files")]
pub(crate) use decimal::power_of_two;
pub use narrow::{
    absolute, bit_modulo_32, difference_modulo_2_32, fitting, from_twos_complement, low_word,
    magnitude, minus_wide, narrowed, narrowed_128, narrowed_unsigned, narrowed_unsigned_128,
    offset_modulo_2_32, product_modulo_2_32, signed, signed_wide, sum_modulo_2_32, sum_modulo_2_64,
    to_u8, to_u16, to_u32, twos_complement, unsigned, unsigned_128, unsigned_wide, word_and_sign,
};
pub use power::{Exponent, even_power, power, whole_power};
pub use product::{
    IS_ARMV6_M, add_high_positive, high, high_positive, high_unsigned, wide, wide_positive,
    wide_unsigned,
};
pub use root::{
    Quotient, divide, ratio, reciprocal_root, root_of_square, root_of_unit, square_root, unit_shift,
};
pub use zeros::leading_zeros;

use fixed::types::{I2F30, I6F26};

/// Number for directions, weights and cosines: Q2.30 in an `i32`, -2 to 2 in steps of 2⁻³⁰.
pub type Unit = I2F30;

/// Number for colours and light: Q6.26 in an `i32`, -32 to 32 in steps of 2⁻²⁶.
pub type Brightness = I6F26;

/// Length in raw scene steps.
///
/// One step is 2⁻ᶠ scene units. f is chosen when the scene is prepared, so that its shapes fit a ball of
/// 2²⁸ steps (see [`crate::scene`]).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Length(i32);

impl Length {
    /// Creates a length from raw steps.
    pub const fn from_bits(bits: i32) -> Self {
        Self(bits)
    }

    /// Returns the length in raw steps.
    pub const fn to_bits(self) -> i32 {
        self.0
    }

    /// Returns a lower bound of the exact length, given the rounded one. Directions are within 2⁻²⁶ of
    /// length one, and points and roots are known to a few steps.
    #[inline(always)]
    pub(crate) const fn surely_less(self) -> Self {
        Self(self.0 - (self.0 >> 24) - 16)
    }
}

/// Returns `start` + `step` · `count`, for a `count` below 2¹⁶. The sum must fit 64 bits; the product
/// need not.
#[inline(always)]
pub const fn stepped(start: i64, step: i64, count: u32) -> i64 {
    debug_assert!(count < 1 << 16);
    // The mask tells the compiler that `count` has 16 bits. On cores without a long multiply, it then
    // omits half of the partial products.
    let count = count & 0xffff;
    let bits = twos_complement(step);
    let high = product_modulo_2_32((bits >> 32) as u32, count);
    let way = sum_modulo_2_64(wide_unsigned(low_word(bits), count), (high as u64) << 32);
    let end = from_twos_complement(sum_modulo_2_64(twos_complement(start), way));
    debug_assert!(start as i128 + step as i128 * count as i128 == end as i128);
    end
}

/// Returns `value` · 2^`exponent`, rounded down. The exponent is at least -63, and the result must fit
/// 64 bits.
///
/// Not inlined, because a 64-bit shift takes many instructions and callers need it rarely.
#[inline(never)]
pub const fn shifted(value: i64, exponent: i32) -> i64 {
    if exponent >= 0 {
        debug_assert!((value << exponent) >> exponent == value);
        value << exponent
    } else {
        value >> -exponent
    }
}

/// Returns `value` · 2^-`places`, rounded to nearest; halves are rounded up. `places` is 1 to 62.
#[inline(always)]
pub const fn rounded(value: i64, places: u32) -> i64 {
    (value + (1 << (places - 1))) >> places
}

/// Multiplies two Q2.30 numbers, rounded down to Q2.30.
pub const fn unit_product(a: Unit, b: Unit) -> Unit {
    Unit::from_bits(scaled_by_unit(a.to_bits(), b))
}

/// Multiplies two Q2.30 numbers, neither of which is below 0, rounded down to Q2.30.
#[inline(always)]
pub const fn share(whole: Unit, part: Unit) -> Unit {
    Unit::from_bits(narrowed(
        wide_positive(whole.to_bits(), part.to_bits()) >> 30,
    ))
}

/// Multiplies `raw`, of any format, by a Q2.30 number. The product has the format of `raw`, is rounded
/// down, and must stay within ±2³¹.
pub const fn scaled_by_unit(raw: i32, unit: Unit) -> i32 {
    narrowed(wide(raw, unit.to_bits()) >> 30)
}

/// Multiplies a cosine by a coefficient: Q2.30 · Q6.26, rounded down to 2⁻²⁴.
#[inline(always)]
pub const fn lit(cosine: Unit, coefficient: Brightness) -> Brightness {
    Brightness::from_bits(high(coefficient.to_bits(), cosine.to_bits()) << 2)
}
