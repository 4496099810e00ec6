//! Angles: the cotangent of the field of view, and sine and cosine for rotations of a camera. They are
//! computed when a camera is made or moved, never for a pixel.

use super::narrow::{
    narrowed, narrowed_128, narrowed_unsigned, narrowed_unsigned_128, signed, to_u32, unsigned_wide,
};
use super::{Number, Quotient, Unit};

/// Factor from degrees to half the angle in radians: π / 360 in Q60.
const HALF_DEGREE: i128 = 10_061_138_136_218_226;

/// Returns cot(`degrees` / 2), with a relative error below 2⁻³⁰ for 0.001 to 179.999 degrees. The
/// mantissa is 2³⁰ to 2³¹ - 1.
///
/// `degrees` is between 0 and 180. Returns `None` if it is so close to 0 or 180 that the cotangent does
/// not fit.
pub const fn cotangent_of_half(degrees: Number) -> Option<Quotient> {
    // Q64 · Q60 >> 64 = Q60
    let angle = narrowed_128(((degrees.to_bits() >> 4) * HALF_DEGREE) >> 60);
    let (sine, cosine) = sine_and_cosine(angle);
    if sine <= 1 << 20 || cosine <= 1 << 20 {
        return None;
    }
    let quotient = ((unsigned_wide(cosine) as u128) << 64) / unsigned_wide(sine) as u128;
    let bits = 128 - signed(quotient.leading_zeros());
    let mantissa = if bits > 31 { quotient >> (bits - 31) } else { quotient << (31 - bits) };
    Some(Quotient {
        mantissa: narrowed_unsigned(narrowed_unsigned_128(mantissa)),
        exponent: bits - 31 - 64,
    })
}

/// Returns sine and cosine of an angle within ±2³¹ degrees, rounded down to 2⁻³⁰.
#[inline(never)]
pub const fn sine_and_cosine_of(degrees: Number) -> (Unit, Unit) {
    let whole = narrowed(narrowed_128(degrees.to_bits() >> 64));
    let quarters = whole.div_euclid(90);
    // The rest after whole quarter turns, in degrees, Q56.
    let rest =
        (whole.rem_euclid(90) as i64) << 56 | ((degrees.to_bits() >> 8) & ((1 << 56) - 1)) as i64;
    let (sine, cosine) = sine_and_cosine(narrowed_128((rest as i128 * 2 * HALF_DEGREE) >> 56));
    let (sine, cosine) = (narrowed(sine >> 30), narrowed(cosine >> 30));
    let (sine, cosine) = match quarters.rem_euclid(4) {
        0 => (sine, cosine),
        1 => (cosine, -sine),
        2 => (-sine, -cosine),
        _ => (-cosine, sine),
    };
    (Unit::from_bits(sine), Unit::from_bits(cosine))
}

/// Reciprocals 1 / i in Q60. Entry 0 is unused.
static RECIPROCALS: [i64; 32] = {
    let mut reciprocals = [0; 32];
    let mut order = 1;
    while order < 32 {
        reciprocals[order] = (1 << 60) / signed(to_u32(order)) as i64;
        order += 1;
    }
    reciprocals
};

/// Multiplies two Q60 numbers, rounded down.
#[inline(never)]
const fn q60(a: i64, b: i64) -> i64 {
    narrowed_128((a as i128 * b as i128) >> 60)
}

/// Returns sine and cosine, in Q60, of an angle from 0 to π/2 in Q60. Sums the Taylor series up to the
/// first term below 2⁻⁶⁰: 26 terms at most.
#[inline(never)]
const fn sine_and_cosine(angle: i64) -> (i64, i64) {
    let (mut sine, mut cosine) = (0, 1 << 60);
    let mut term = 1_i64 << 60;
    let mut order = 1;
    loop {
        term = q60(q60(term, angle), RECIPROCALS[order % 32]);
        if term == 0 {
            return (sine, cosine);
        }
        match order % 4 {
            0 => cosine += term,
            1 => sine += term,
            2 => cosine -= term,
            _ => sine -= term,
        }
        order += 1;
    }
}

#[cfg(test)]
mod tests;
