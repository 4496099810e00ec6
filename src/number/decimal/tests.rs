use super::*;

#[test]
fn floats_are_read_to_the_last_bit() {
    for value in [
        0.0,
        1.0,
        -1.0,
        0.1,
        -55.742,
        1e9,
        2f64.powi(-64),
        123456.789,
        2f64.powi(62),
        -2f64.powi(63).next_down(),
    ] {
        assert_eq!(Number::new(value).to_f64(), value, "{value}");
    }
    for value in [0.1_f32, -3.25, 1e6, 2f32.powi(-40)] {
        assert_eq!(Number::from(value).to_f64(), f64::from(value), "{value}");
    }
}

#[test]
fn half_a_step_rounds_up_and_less_vanishes() {
    assert_eq!(Number::new(2f64.powi(-65)).to_bits(), 1);
    assert_eq!(Number::new(2f64.powi(-66)).to_bits(), 0);
    assert_eq!(Number::new(2f64.powi(-200)).to_bits(), 0);
}

#[test]
fn what_is_not_finite_is_out_of_range() {
    for value in [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        1e30,
        -1e30,
        2f64.powi(63),
    ] {
        assert_eq!(Number::new(value), Number::OUT_OF_RANGE, "{value}");
        assert_eq!(Number::from(value as f32), Number::OUT_OF_RANGE, "{value}");
    }
}

#[test]
fn quantising_rounds_to_nearest() {
    assert_eq!(Number::new(0.75).quantised(1), 2);
    assert_eq!(Number::new(0.74).quantised(1), 1);
    assert_eq!(Number::new(-0.75).quantised(1), -1);
    assert_eq!(Number::new(-0.76).quantised(1), -2);
}
