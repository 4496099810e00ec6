use super::*;

#[test]
fn powers_agree_with_double_precision() {
    for exponent in [
        0.0, 0.5, 1.0, 2.0, 2.5, 3.0, 4.0, 7.9, 10.0, 50.0, 128.0, 1000.0, 1e5,
    ] {
        let bound = (exponent + 4.0) * 2f64.powi(-28);
        for step in 0..=4096 {
            let base = Unit::from_bits((1 << 18) * step);
            let found = power(base, Exponent::new(Number::new(exponent))).to_num::<f64>();
            let truth = base.to_num::<f64>().powf(exponent);
            assert!(
                (found - truth).abs() < bound,
                "{base}^{exponent}: {found}, not {truth}"
            );
        }
    }
}

#[test]
fn nothing_to_the_power_of_nothing_is_one() {
    assert_eq!(power(Unit::ZERO, Exponent::new(Number::ZERO)), Unit::ONE);
    assert_eq!(
        power(Unit::ZERO, Exponent::new(Number::new(0.5))),
        Unit::ZERO
    );
}

#[test]
fn one_stays_one_for_whole_exponents() {
    for exponent in [0, 1, 2, 8, 1 << 20] {
        assert_eq!(
            power(Unit::ONE, Exponent::new(Number::from(exponent))),
            Unit::ONE
        );
    }
}
