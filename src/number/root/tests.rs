//! Tests of roots and reciprocals.

use super::*;

/// Returns the edges of every table entry, and 4 million values between 1 and 4 from a fixed
/// sequence.
fn mantissas() -> impl Iterator<Item = u32> {
    let edges = (256_u32..1024).flat_map(|index| {
        let low = index << 22;
        [low, low + 1, low + (1 << 21), low + ((1 << 22) - 1)]
    });
    let sweep = (0..4_000_000_u32).map(|step| step.wrapping_mul(805_307) | 1 << 30);
    edges.chain(sweep)
}

#[test]
fn the_reciprocal_root_is_within_its_bound() {
    let mut worst = 0.0_f64;
    for mantissa in mantissas() {
        let truth = 2f64.powi(31) / (f64::from(mantissa) / 2f64.powi(30)).sqrt();
        let error = (f64::from(reciprocal_root(mantissa)) - truth).abs() / truth;
        worst = worst.max(error);
    }
    assert!(worst < 2f64.powf(-27.5), "{worst:e} = 2^{}", worst.log2());
    assert!(
        worst > 2f64.powi(-31),
        "a bound this loose says nothing: {worst:e}"
    );
}

#[test]
fn the_square_root_is_within_its_bound() {
    for bits in 0..62 {
        for low in [0_u64, 1, 12345] {
            let square = (1_u64 << bits) + low % (1 << bits);
            let truth = (square as f64).sqrt();
            let found = f64::from(square_root(square));
            assert!(
                (found - truth).abs() <= 1.0 + truth * 2f64.powi(-27),
                "{square}: {found}"
            );
        }
    }
    assert_eq!(square_root(0), 0);
}

#[test]
fn the_reciprocal_is_within_its_bound() {
    let mut worst = 0.0_f64;
    for mantissa in mantissas().map(|mantissa| mantissa | 1 << 31) {
        let truth = 2f64.powi(62) / f64::from(mantissa);
        let error = (f64::from(reciprocal(mantissa)) - truth).abs() / truth;
        worst = worst.max(error);
    }
    assert!(worst < 2f64.powi(-26), "{worst:e} = 2^{}", worst.log2());
}

#[test]
fn a_ratio_is_within_its_bound() {
    let mut sweep = crate::number::sweep::Sweep::new(5);
    for _ in 0..200_000 {
        let denominator = sweep.octaves(1, 30);
        let numerator = sweep.within(0, denominator - 1);
        let truth = f64::from(numerator) / f64::from(denominator) * 2f64.powi(30);
        let found = f64::from(ratio(numerator as u32, denominator as u32));
        assert!(
            (found - truth).abs() <= 1.0 + truth * 2f64.powi(-26),
            "{numerator}/{denominator}: {found}, not {truth}"
        );
    }
}

#[test]
fn a_quotient_is_within_its_bound() {
    for up in 0..31 {
        for numerator in [1_u64, 3, 1 << 40, (1 << 62) + 12345] {
            let denominator = (1_u32 << up) + (98_765 % (1 << up));
            let Quotient { mantissa, exponent } = divide(numerator, denominator);
            let found = f64::from(mantissa) * 2f64.powi(exponent);
            let truth = (numerator | 1) as f64 / f64::from(denominator);
            assert!(
                (found / truth - 1.0).abs() < 2f64.powi(-26),
                "{numerator}/{denominator}"
            );
        }
    }
}

#[test]
fn a_unit_shift_brings_every_length_to_the_same_octave() {
    for bits in 0..62 {
        let (shift, mantissa) = unit_shift(1 << bits);
        assert!(mantissa >= 1 << 30);
        let length = 2f64.powf(f64::from(bits) / 2.0 + f64::from(shift));
        assert!(
            (2f64.powi(30)..2f64.powi(31)).contains(&length) || bits == 61,
            "{bits}"
        );
    }
}
