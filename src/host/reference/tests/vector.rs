//! Tests of `reference::model::vector`.

use crate::host::reference::Vector;

#[test]
fn unit_of_a_pythagorean_box_is_exact_to_an_ulp() {
    let Vector(unit) = Vector([2.0, -3.0, 6.0]).unit();
    for (component, exact) in unit.into_iter().zip([2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0]) {
        assert!((component - exact).abs() <= f64::EPSILON, "{unit:?}");
    }
}
