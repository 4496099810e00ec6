//! Decimal numbers in descriptions of scenes, converted without float arithmetic.

use fixed::types::{I16F16, I32F32, I64F64, U16F16};

use super::narrow::{narrowed, narrowed_128};

/// Number in a description, in Q64.64: every decimal literal that a scene may hold is exact to 2⁻⁶⁴.
///
/// Conversions from `f64` and `f32` take the bits of the float apart with integer shifts. So they need
/// no float instruction and no soft-float routine on a core without an FPU. A value that is not finite
/// or beyond ±2⁶³ becomes [`Number::OUT_OF_RANGE`]. Every constructor refuses it, and its error names
/// the field.
///
/// ```
/// use reflet::Number;
/// assert_eq!(Number::new(0.75), Number::from(3) * Number::new(0.25));
/// assert_eq!(Number::new(f64::NAN), Number::OUT_OF_RANGE);
///
/// assert_eq!((Number::ZERO.to_bits(), Number::ONE.to_bits()), (0, 1 << 64));
/// assert_eq!(Number::from_bits(3 << 62).to_f64(), 0.75);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Number(I64F64);

impl Number {
    /// The number 0.
    pub const ZERO: Self = Self(I64F64::ZERO);

    /// The number 1.
    pub const ONE: Self = Self::new(1.0);

    /// Sentinel for a float that Q64.64 cannot hold: not a number, infinite, or beyond ±2⁶³.
    pub const OUT_OF_RANGE: Self = Self(I64F64::MAX);

    /// Converts an `f64`, rounded to the nearest 2⁻⁶⁴.
    pub const fn new(value: f64) -> Self {
        let bits = value.to_bits();
        let exponent = ((bits >> 52) & 0x7ff) as i32;
        let fraction = (bits & ((1 << 52) - 1)) as i128;
        if exponent == 0 {
            return Self::ZERO;
        }
        // The value is (2^52 + fraction) · 2^(exponent - 1075); the format adds 2^64.
        let shift = exponent - 1075 + 64;
        if shift > 74 {
            return Self::OUT_OF_RANGE;
        }
        let mantissa = (1 << 52) | fraction;
        let magnitude = if shift >= 0 {
            mantissa << shift
        } else if shift > -54 {
            (mantissa + (1 << (-shift - 1))) >> -shift
        } else {
            0
        };
        Self(I64F64::from_bits(if bits >> 63 == 0 {
            magnitude
        } else {
            -magnitude
        }))
    }

    /// Creates a number from raw Q64.64 bits.
    pub const fn from_bits(bits: i128) -> Self {
        Self(I64F64::from_bits(bits))
    }

    /// Returns the raw Q64.64 bits.
    pub const fn to_bits(self) -> i128 {
        self.0.to_bits()
    }

    /// Converts the number to the nearest `f64`. Meant for desktop computers, because it uses float
    /// arithmetic.
    pub const fn to_f64(self) -> f64 {
        self.0.to_bits() as f64 / (1_u128 << 64) as f64
    }

    /// Tests whether the number is within `low` to `high`, both included. The bounds are integers.
    pub(crate) const fn is_within(self, low: i64, high: i64) -> bool {
        let bits = self.to_bits();
        (low as i128) << 64 <= bits && bits <= (high as i128) << 64
    }

    /// Converts the number to a format with `fraction_bits` fraction bits, rounded to nearest.
    ///
    /// The caller has checked that the result fits an `i32`.
    pub(crate) const fn quantised(self, fraction_bits: u32) -> i32 {
        let drop = 64 - fraction_bits;
        narrowed(narrowed_128((self.to_bits() + (1 << (drop - 1))) >> drop))
    }

    /// Tests whether two numbers are equal. It can be called in constants, unlike `==`.
    pub(crate) const fn same(self, other: Self) -> bool {
        self.to_bits() == other.to_bits()
    }
}

/// Returns 2^`exponent`, which is within -1022 to 1023. `f64::powi` needs std.
#[cfg(feature = "files")]
pub(crate) const fn power_of_two(exponent: i32) -> f64 {
    f64::from_bits((super::unsigned(exponent + 1023) as u64) << 52)
}

impl core::ops::Mul for Number {
    type Output = Self;

    fn mul(self, other: Self) -> Self {
        Self(self.0.saturating_mul(other.0))
    }
}

impl From<f64> for Number {
    fn from(value: f64) -> Self {
        Self::new(value)
    }
}

impl From<f32> for Number {
    fn from(value: f32) -> Self {
        // Widening an f32 is a float instruction, so its bits are taken apart here too.
        let bits = value.to_bits();
        let exponent = ((bits >> 23) & 0xff) as u64;
        let fraction = (bits & 0x7f_ffff) as u64;
        let sign = ((bits >> 31) as u64) << 63;
        match exponent {
            0 => Self::ZERO,
            0xff => Self::OUT_OF_RANGE,
            _ => Self::new(f64::from_bits(
                sign | ((exponent + 896) << 52) | (fraction << 29),
            )),
        }
    }
}

/// Converts numbers of types that Q64.64 holds exactly.
macro_rules! exact {
    ($($number:ty)*) => {
        $(impl From<$number> for Number {
            fn from(value: $number) -> Self {
                Self(I64F64::from(value))
            }
        })*
    };
}
exact!(i8 u8 i16 u16 i32 u32 i64 I16F16 U16F16 I32F32);

impl From<I64F64> for Number {
    fn from(value: I64F64) -> Self {
        Self(value)
    }
}

#[cfg(feature = "micromath")]
impl From<micromath::F32> for Number {
    fn from(value: micromath::F32) -> Self {
        Self::from(value.0)
    }
}

/// Converts three `f64`s, such as a position or a colour, each rounded to the nearest 2⁻⁶⁴.
pub(crate) const fn numbers([first, second, third]: [f64; 3]) -> [Number; 3] {
    [Number::new(first), Number::new(second), Number::new(third)]
}

#[cfg(test)]
mod tests;
