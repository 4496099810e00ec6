//! Compares `Exact` with single precision, on every built-in scene.

use float_picture::Shading;
use float_picture::accuracy::{NAMES as QUALITIES, measure};
use reflet::scenes::NAMES;

fn assert_is_no_worse_than_single_precision(shading: Shading) {
    let exact_one = QUALITIES.iter().position(|name| *name == "exact").unwrap();
    let mut worse = Vec::new();
    for name in NAMES {
        let row = measure(name, 320, 4, shading).unwrap();
        let [fast, _, exact, single] = row.differences.map(|it| it.same);
        println!("{name:<18} fast {fast:.5}  exact {exact:.5}  f32 {single:.5}");
        if !row.is_as_near_as_single_precision(exact_one) {
            worse.push(name);
        }
    }
    assert!(worse.is_empty(), "{shading:?}: {worse:?}");
}

#[test]
fn exact_is_no_worse_than_single_precision_in_blinn_phong() {
    assert_is_no_worse_than_single_precision(Shading::BlinnPhong);
}

#[test]
fn exact_is_no_worse_than_single_precision_in_phong() {
    assert_is_no_worse_than_single_precision(Shading::Phong);
}
