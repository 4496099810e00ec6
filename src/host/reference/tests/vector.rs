//! Tests of `reference::vector`.

use crate::host::reference::vector::*;

#[test]
fn cross_product_is_right_handed() {
    let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector);
    assert_eq!([x.cross(y), y.cross(z), z.cross(x)], [z, x, y]);
}

#[test]
fn unit_of_a_pythagorean_box_is_exact_to_an_ulp() {
    let Vector(unit) = Vector([2.0, -3.0, 6.0]).unit();
    for (component, exact) in unit.into_iter().zip([2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0]) {
        assert!((component - exact).abs() <= f64::EPSILON, "{unit:?}");
    }
}

#[test]
fn across_drops_the_part_along_the_axis() {
    let axis = Vector([0.0, 1.0, 0.0]);
    assert_eq!(
        Vector([3.0, 5.0, -2.0]).across(axis),
        Vector([3.0, 0.0, -2.0])
    );
}
