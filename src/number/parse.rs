//! Decimal text to a [`Number`], in integers only. Knows neither files nor lines.

use core::str::FromStr;

use super::Number;
use crate::error::Error;
use crate::error_kind::ErrorKind;

/// Reads a decimal number, without float arithmetic and without allocation.
///
/// The grammar is that of `f64::from_str`, without the words for infinity and not-a-number:
///
/// ```text
/// number   = [sign] (digits ["." [digits]] | "." digits) [("e" | "E") [sign] digits]
/// digits   = "0" to "9", any number of them
/// sign     = "+" | "-"
/// ```
///
/// There are no spaces around a number, and no other signs in it.
///
/// The value is rounded once, to the nearest multiple of 2⁻⁶⁴; halves are rounded away from zero, as
/// [`Number::new`] does. What lies beyond ±2⁶³ is [`Number::OUT_OF_RANGE`], which is refused by name
/// where it is used. Digits and exponents may be of any length: the time grows with the length of the
/// text, and not with its exponent.
///
/// ```
/// use reflet::{ErrorKind, Number};
/// assert_eq!("-1.5".parse(), Ok(Number::new(-1.5)));
/// assert_eq!("25e-2".parse(), Ok(Number::new(0.25)));
/// assert_eq!("1e999".parse(), Ok(Number::OUT_OF_RANGE));
/// let error = "1,5".parse::<Number>().unwrap_err();
/// assert_eq!(error.kind(), ErrorKind::Number);
/// ```
///
/// # Errors
/// [`ErrorKind::Number`] if the text is no such number.
impl FromStr for Number {
    type Err = Error;

    fn from_str(text: &str) -> Result<Self, Error> {
        let decimal =
            Decimal::read(text.as_bytes()).ok_or(Error::of("number", ErrorKind::Number))?;
        Ok(decimal.rounded())
    }
}

/// The parts of a decimal text: `whole`.`fraction` · 10^`exponent`.
struct Decimal<'a> {
    is_negative: bool,
    whole: &'a [u8],
    fraction: &'a [u8],
    exponent: i64,
}

impl<'a> Decimal<'a> {
    fn read(text: &'a [u8]) -> Option<Self> {
        let (is_negative, text) = sign(text);
        let (whole, text) = digits(text);
        let (fraction, text) = match text {
            [b'.', rest @ ..] => digits(rest),
            _ => (&[][..], text),
        };
        let exponent = match text {
            [] => 0,
            [b'e' | b'E', rest @ ..] => exponent(rest)?,
            _ => return None,
        };
        let has_digits = !whole.is_empty() || !fraction.is_empty();
        has_digits.then_some(Self {
            is_negative,
            whole,
            fraction,
            exponent,
        })
    }

    fn rounded(&self) -> Number {
        let digits = self.whole.iter().chain(self.fraction).map(|it| it & 15);
        let count = self.whole.len() + self.fraction.len();
        // The exponent moves the point to behind this many digits.
        let point = wide(self.whole.len()).saturating_add(self.exponent);
        let before = bounded(point, count);
        let zeros_before = bounded(point.saturating_sub(wide(count)), MOST_ZEROS);
        let zeros_after = bounded(point.saturating_neg(), MOST_ZEROS);

        let zeros = core::iter::repeat_n(0, zeros_before);
        let whole = whole(digits.clone().take(before).chain(zeros));
        let zeros = core::iter::repeat_n(0, zeros_after);
        let fraction = fraction(digits.rev().take(count - before).chain(zeros));

        match i128::try_from((u128::from(whole) << 64) + fraction) {
            Ok(bits) if self.is_negative => Number::from_bits(-bits),
            Ok(bits) => Number::from_bits(bits),
            Err(_) => Number::OUT_OF_RANGE,
        }
    }
}

/// More zeros than this change nothing: any digit before 20 zeros is beyond 2⁶³, and any digits after
/// 20 zeros are below half of 2⁻⁶⁴.
const MOST_ZEROS: usize = 20;

/// The value of digits, the first of which weighs most; at least 2⁶³ if it is.
fn whole(digits: impl Iterator<Item = u8>) -> u64 {
    // Ten times 2^60 is beyond 2^63, and below 2^64 with a digit added: once beyond, always beyond.
    const LARGEST: u64 = 1 << 60;
    digits.fold(0, |value, digit| value.min(LARGEST) * 10 + u64::from(digit))
}

/// The value of digits behind the point, the last of which comes first: in 2⁻⁶⁴, rounded to nearest.
///
/// Each digit d makes (d + value) / 10 of the value behind it. What is rounded down on the way never
/// reaches the next multiple of 2⁻⁶⁴ or its half, so the last remainder alone says how to round.
fn fraction(digits: impl Iterator<Item = u8>) -> u128 {
    let (value, remainder) = digits.fold((0, 0), |(value, _), digit| tenth(digit, value));
    u128::from(value) + u128::from(remainder >= 5)
}

/// (`digit` · 2⁶⁴ + `value`) / 10, rounded down, and the remainder.
fn tenth(digit: u8, value: u64) -> (u64, u64) {
    // 2^64 = 10 · TENTH + 6. A digit is at most 9, so that the quotient is below 2^64.
    const TENTH: u64 = u64::MAX / 10;
    let digit = u64::from(digit);
    let rest = 6 * digit + value % 10;
    (digit * TENTH + value / 10 + rest / 10, rest % 10)
}

/// Whether there is a minus sign, and what follows the sign.
const fn sign(text: &[u8]) -> (bool, &[u8]) {
    match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, text),
    }
}

/// The digits at the start, and what follows them.
fn digits(text: &[u8]) -> (&[u8], &[u8]) {
    let end = text.iter().position(|it| !it.is_ascii_digit());
    // `split_at` could panic, for all that the linker knows.
    end.and_then(|end| text.split_at_checked(end))
        .unwrap_or((text, &[]))
}

/// The value of an exponent. A long one is at least 2⁵⁹, which no text has digits to outweigh.
fn exponent(text: &[u8]) -> Option<i64> {
    const LARGEST: i64 = 1 << 59;
    let (is_negative, text) = sign(text);
    let (digits, rest) = digits(text);
    if digits.is_empty() || !rest.is_empty() {
        return None;
    }
    let magnitude = digits.iter().fold(0, |value: i64, it| {
        value.min(LARGEST) * 10 + i64::from(it & 15)
    });
    Some(if is_negative { -magnitude } else { magnitude })
}

/// Converts a number of digits from `usize` to `i64`.
fn wide(count: usize) -> i64 {
    i64::try_from(count).unwrap_or(i64::MAX)
}

/// `count`, from 0 to `most`.
fn bounded(count: i64, most: usize) -> usize {
    usize::try_from(count.max(0)).map_or(most, |it| it.min(most))
}

#[cfg(test)]
mod tests;
