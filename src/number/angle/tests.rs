use super::*;

#[test]
fn the_cotangent_agrees_with_double_precision() {
    for degrees in [
        0.001, 0.5, 2.5, 45.0, 50.0, 65.0, 90.0, 120.0, 179.0, 179.9, 179.999,
    ] {
        let found = cotangent_of_half(Number::new(degrees)).expect("inside the range");
        assert!((1 << 30..1 << 31).contains(&found.mantissa), "{degrees}");
        let value = f64::from(found.mantissa) * 2f64.powi(found.exponent);
        let truth = 1.0 / (degrees / 2.0).to_radians().tan();
        assert!(
            (value / truth - 1.0).abs() < 2f64.powi(-30),
            "{degrees}: {value}, {truth}"
        );
    }
}

#[test]
fn sine_and_cosine_agree_with_double_precision() {
    for degrees in [
        -720.0, -359.5, -90.0, -12.25, 0.0, 0.001, 30.0, 89.999, 90.0, 135.0, 181.0, 1e6,
    ] {
        let (sine, cosine) = sine_and_cosine_of(Number::new(degrees));
        let (true_sine, true_cosine) = f64::sin_cos((degrees % 360.0).to_radians());
        assert!(
            (sine.to_num::<f64>() - true_sine).abs() < 2f64.powi(-29),
            "{degrees}"
        );
        assert!(
            (cosine.to_num::<f64>() - true_cosine).abs() < 2f64.powi(-29),
            "{degrees}"
        );
    }
}

#[test]
fn angles_too_close_to_the_ends_have_none() {
    assert_eq!(cotangent_of_half(Number::ZERO), None);
    assert_eq!(cotangent_of_half(Number::from(180)), None);
}
