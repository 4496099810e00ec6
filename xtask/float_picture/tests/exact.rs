//! `Exact` beside single precision, on every built-in scene.

use float_picture::Shading;
use float_picture::accuracy::measure;
use reflet::scenes::NAMES;

/// What is as good as the truth: one pixel in ten thousand is other.
const ALL: f64 = 0.9999;

fn assert_is_no_worse_than_single_precision(shading: Shading) {
    let mut worse = Vec::new();
    for name in NAMES {
        let row = measure(name, 320, 4, shading).unwrap();
        let [fast, _, _, exact, single] = row.differences.map(|it| it.same);
        println!("{name:<18} fast {fast:.5}  exact {exact:.5}  f32 {single:.5}");
        if exact < single.min(ALL) {
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
