//! Tests of conversions between numbers.

use super::*;

#[test]
fn number_that_fits_stays_the_same() {
    for value in [i32::MIN, -1, 0, 1, i32::MAX] {
        assert_eq!(narrowed(value.into()), value);
        assert_eq!(fitting(value.into()), Some(value));
        assert_eq!(narrowed_128(value.into()), i64::from(value));
        let (word, sign) = word_and_sign(value.into());
        assert_eq!((word, sign), (value, value >> 31));
        assert_eq!(magnitude(word, sign), value.unsigned_abs());
    }
    for value in [0, 1, u32::MAX] {
        assert_eq!(narrowed_unsigned(value.into()), value);
        assert_eq!(narrowed_unsigned_128(value.into()), u64::from(value));
        assert_eq!(to_u32(value as usize), value);
        let (word, sign) = word_and_sign(-i64::from(value));
        assert_eq!(magnitude(word, if value == 0 { 0 } else { sign }), value);
    }
    for value in [0, 1, i32::MAX] {
        assert_eq!(signed(unsigned(value)), value);
        assert_eq!(signed_wide(unsigned_wide(value.into())), i64::from(value));
        assert_eq!(unsigned_128(value.into()), u128::from(unsigned(value)));
    }
    assert_eq!((to_u8(255), to_u16(0xffff)), (u8::MAX, u16::MAX));
}

#[test]
fn sum_that_fits_is_the_sum() {
    assert_eq!(plus_signed(u32::MAX, -1), u32::MAX - 1);
    assert_eq!(plus_signed(1 << 31, i32::MIN), 0);
    assert_eq!(signed_difference(0, 1 << 31), i32::MIN);
    assert_eq!(signed_difference(u32::MAX, 1 << 31), i32::MAX);
    assert_eq!(minus_wide(1, 1 << 31), i32::MIN + 1);
    assert_eq!(shifted_left(1, 31), 1 << 31);
}

#[test]
fn offset_is_at_most_twice_the_limit_within_it_and_above_it_beyond() {
    for limit in [0, 5, 3 << 27, i32::MAX] {
        let is_within = |value| offset_modulo_2_32(value, limit) <= 2 * unsigned(limit);
        for value in [i32::MIN, i32::MIN + 1, -6, -5, -1, 0, 1, 5, 6, i32::MAX] {
            assert_eq!(is_within(value), value.unsigned_abs() <= unsigned(limit));
        }
        assert!(is_within(limit) && is_within(-limit));
    }
}

#[test]
fn what_is_modulo_wraps() {
    assert_eq!(low_word(u64::MAX - 1), u32::MAX - 1);
    assert_eq!(fitting(1 << 31), None);
    assert_eq!(fitting(i128::MIN), None);
    assert_eq!(sum_modulo_2_32(u32::MAX, 2), 1);
    assert_eq!(difference_modulo_2_32(1, 2), u32::MAX);
    assert_eq!(product_modulo_2_32(1 << 31, 3), 1 << 31);
    assert_eq!(sum_modulo_2_64(u64::MAX, 2), 1);
    assert_eq!(from_twos_complement(twos_complement(i64::MIN)), i64::MIN);
    assert_eq!((bit_modulo_32(0), bit_modulo_32(33)), (1, 2));
}

#[test]
#[cfg(debug_assertions)]
fn number_out_of_range_is_refused_where_that_is_asserted() {
    fn is_refused<T>(call: fn() -> T) -> bool {
        std::panic::catch_unwind(call).is_err()
    }
    assert!(is_refused(|| narrowed(1 << 31)));
    assert!(is_refused(|| narrowed_unsigned(1 << 32)));
    assert!(is_refused(|| narrowed_128(1 << 63)));
    assert!(is_refused(|| narrowed_unsigned_128(1 << 64)));
    assert!(is_refused(|| to_u8(256)));
    assert!(is_refused(|| to_u16(1 << 16)));
    assert!(is_refused(|| unsigned(-1)));
    assert!(is_refused(|| unsigned_wide(-1)));
    assert!(is_refused(|| unsigned_128(-1)));
    assert!(is_refused(|| signed(1 << 31)));
    assert!(is_refused(|| signed_wide(1 << 63)));
    assert!(is_refused(|| word_and_sign(-(1 << 32))));
    assert!(is_refused(|| magnitude(0, -1)));
    assert!(is_refused(|| plus_signed(0, -1)));
    assert!(is_refused(|| plus_signed(u32::MAX, 1)));
    assert!(is_refused(|| signed_difference(1 << 31, 0)));
    assert!(is_refused(|| minus_wide(0, 1 << 32)));
    assert!(is_refused(|| shifted_left(1, 32)));
    assert!(is_refused(|| shifted_left(2, 31)));
    assert!(is_refused(|| offset_modulo_2_32(0, -1)));
}
