use std::string::{String, ToString};

use fixed::types::I64F64;

use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::number::Number;
use crate::number::sweep::Sweep;

const SEED: u64 = 1;
const TEXTS: usize = 100_000;

#[track_caller]
fn bits(text: &str) -> i128 {
    let number: Result<Number, _> = text.parse();
    number
        .map(Number::to_bits)
        .unwrap_or_else(|_| panic!("{text} is refused"))
}

/// The raw bits of `halves` halves.
const fn half(halves: i128) -> i128 {
    halves << 63
}

#[test]
fn all_forms_of_a_number_are_read() {
    for text in [
        "1.5", "+1.5", "01.50", "15e-1", "15E-01", "0.15e1", ".15e+1", "1500.e-3",
    ] {
        assert_eq!(bits(text), half(3), "{text}");
    }
    for (text, value) in [
        ("5.", half(10)),
        (".5", half(1)),
        ("-.5", half(-1)),
        ("-12e3", half(-24_000)),
    ] {
        assert_eq!(bits(text), value, "{text}");
    }
    for text in [
        "0",
        "-0",
        "0.",
        ".0",
        "0e9",
        "-0e-9",
        "0e99999999999999999999",
    ] {
        assert_eq!(bits(text), 0, "{text}");
    }
}

#[test]
fn what_is_no_number_is_refused() {
    for text in [
        "", " ", "+", "-", ".", "+.", "e", "e5", ".e5", "-e5", "1e", "1e+", "1e-", "1e5.", "1e 5",
        " 1", "1 ", "1\n", "+-1", "--1", "1-", "1.2.3", "1,5", "1_000", "0x10", "1f", "1e5e5",
        "inf", "-inf", "infinity", "nan", "NaN", "½", "١", "−1", "1\0",
    ] {
        assert_eq!(
            text.parse::<Number>(),
            Err(Error::of("number", ErrorKind::Number)),
            "{text:?}"
        );
    }
}

#[test]
fn what_f64_reads_is_read_and_nothing_else() {
    const ALPHABET: [char; 7] = ['0', '1', '9', '.', 'e', '+', '-'];
    const LONGEST: usize = 6;
    let mut texts = vec![String::new()];
    let mut from = 0;
    for _ in 0..=LONGEST {
        let to = texts.len();
        for index in from..to {
            let text = texts[index].clone();
            assert_eq!(
                text.parse::<Number>().is_ok(),
                text.parse::<f64>().is_ok(),
                "{text:?}"
            );
            if text.parse::<f64>().is_ok() {
                assert_near_f64(&text);
            }
            texts.extend(ALPHABET.map(|it| text.clone() + &it.to_string()));
        }
        from = to;
    }
}

/// Asserts that the number is within half a step of the nearest `f64`, plus 2⁻⁶⁴. A step of an `f64` is at
/// most 2⁻⁵² of its value.
#[track_caller]
fn assert_near_f64(text: &str) {
    let (found, float) = (bits(text), text.parse::<f64>().unwrap());
    if float.abs() < 2f64.powi(63) {
        let expected = Number::new(float).to_bits();
        let allowed = (expected.abs() >> 53) + 1;
        assert!(
            (found - expected).abs() <= allowed,
            "{text}: {found}, {expected}"
        );
    } else if float.abs() > 2f64.powi(63) {
        assert_eq!(found, Number::OUT_OF_RANGE.to_bits(), "{text}");
    }
}

fn digits(sweep: &mut Sweep, count: i32) -> String {
    (0..count).map(|_| sweep.within(0, 9).to_string()).collect()
}

/// A random number without an exponent: at least one digit, at most 19 before the point.
fn plain(sweep: &mut Sweep) -> String {
    let sign = ["", "-", "+"][sweep.within(0, 2) as usize];
    let (before, after) = (sweep.within(0, 19), sweep.within(1, 30));
    format!("{sign}{}.{}", digits(sweep, before), digits(sweep, after))
}

#[test]
fn decimals_are_near_what_f64_reads() {
    let sweep = &mut Sweep::new(SEED);
    for _ in 0..TEXTS {
        let (number, exponent) = (plain(sweep), sweep.within(-45, 25));
        assert_near_f64(&number);
        assert_near_f64(&format!("{number}e{exponent}"));
    }
}

#[test]
fn numbers_that_an_f64_holds_are_read_exactly() {
    let sweep = &mut Sweep::new(SEED);
    for _ in 0..TEXTS {
        // 52 bits, of which at most 62 are behind the point.
        let mantissa = f64::from(sweep.within(-1 << 25, 1 << 25)) * f64::from(1 << 26)
            + f64::from(sweep.within(0, 1 << 26));
        let float = mantissa * 2f64.powi(sweep.within(-62, 9));
        // Written to the last digit, not only as far as tells it from its neighbours.
        for text in [format!("{float:.70}"), format!("{float:.80e}")] {
            assert_eq!(bits(&text), Number::new(float).to_bits(), "{text}");
        }
    }
}

#[test]
fn rounding_is_that_of_another_reader_where_nothing_is_half_way() {
    let sweep = &mut Sweep::new(SEED);
    for _ in 0..TEXTS {
        let text = plain(sweep);
        // It rounds halves to even, and says so where a number is beyond ±2^63.
        let expected = I64F64::from_str(&text).unwrap_or(I64F64::MAX);
        assert_eq!(bits(&text), expected.to_bits(), "{text}");
    }
}

/// `bits` / 2^`places` of the format's step, written out to the last digit.
fn exactly(bits: u128, places: u32) -> String {
    let places = 64 + places;
    let (whole, mut rest) = (bits >> places, bits & ((1 << places) - 1));
    let mut text = whole.to_string() + ".";
    while rest > 0 {
        rest *= 10;
        text += &(rest >> places).to_string();
        rest &= (1 << places) - 1;
    }
    text
}

#[test]
fn halves_are_rounded_away_from_zero_and_less_is_rounded_down() {
    let sweep = &mut Sweep::new(SEED);
    for _ in 0..1000 {
        let high = u128::from(sweep.within(0, i32::MAX) as u32);
        let low = u128::from(sweep.within(i32::MIN, i32::MAX) as u32);
        let below = (high << sweep.within(0, 64)) + low;
        let exact = exactly(below, 0);
        let below = below as i128;
        assert_eq!(bits(&exact), below);
        assert_eq!(bits(&format!("-{exact}")), -below);

        let halfway = exactly(below as u128 * 2 + 1, 1);
        assert_eq!(bits(&halfway), below + 1, "{halfway}");
        assert_eq!(bits(&format!("-{halfway}")), -below - 1, "-{halfway}");
        let more = format!("{halfway}{}1", "0".repeat(100));
        assert_eq!(bits(&more), below + 1, "{more}");
        // The last digit of what is half way is a 5.
        let less = format!("{}4{}", &halfway[..halfway.len() - 1], "9".repeat(100));
        assert_eq!(bits(&less), below, "{less}");
    }
}

#[test]
fn beyond_the_format_is_out_of_range() {
    let limit = "9223372036854775808";
    let below = "9223372036854775807";
    let out = Number::OUT_OF_RANGE.to_bits();
    assert_eq!(bits(below), i128::from(i64::MAX) << 64);
    assert_eq!(
        bits(&format!("-{below}.5")),
        half(-2 * i128::from(i64::MAX) - 1)
    );
    for text in [
        limit.to_string(),
        format!("-{limit}"),
        format!("{below}.{}", "9".repeat(30)),
        format!("-{below}.{}", "9".repeat(30)),
        "9".repeat(40),
        "1e19".into(),
        "-1e19".into(),
        "1e300".into(),
        "1e400".into(),
        "-1e99999999999999999999999".into(),
        ".0001e9223372036854775807".into(),
    ] {
        assert_eq!(bits(&text), out, "{text}");
    }
}

#[test]
fn texts_may_be_of_any_length() {
    const LENGTH: usize = 100_000;
    let (zeros, nines) = ("0".repeat(LENGTH), "9".repeat(LENGTH));
    let one = Number::ONE.to_bits();
    for (text, value) in [
        (format!("{zeros}1.{zeros}"), one),
        (format!("1{zeros}e-{LENGTH}"), one),
        (format!("0.{zeros}1e{}", LENGTH + 1), one),
        (format!("1e{zeros}0"), one),
        (format!("0.{nines}"), one),
        (format!("{zeros}.5"), half(1)),
        (format!("{zeros}e{nines}"), 0),
        (format!("{nines}e-{nines}"), 0),
        (format!("0.{zeros}1"), 0),
        (format!("1e{nines}"), Number::OUT_OF_RANGE.to_bits()),
        (nines.clone(), Number::OUT_OF_RANGE.to_bits()),
    ] {
        let (start, length) = (&text[..20], text.len());
        assert!(bits(&text) == value, "{start}.. of {length}");
    }
    assert_eq!(
        format!("{nines}x").parse::<Number>(),
        Err(Error::of("number", ErrorKind::Number))
    );
}

#[test]
fn smallest_numbers_vanish_below_half_a_step() {
    // 2^-65 is 2.71..e-20.
    for (text, value) in [
        ("5.43e-20", 1),
        ("2.72e-20", 1),
        ("2.71e-20", 0),
        ("9e-21", 0),
        ("9e-999", 0),
    ] {
        assert_eq!(bits(text), value, "{text}");
        assert_eq!(bits(&format!("-{text}")), -value, "-{text}");
    }
}
