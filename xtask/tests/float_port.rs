//! Tests that the pictures of the float port and of single precision are right, because the library
//! is compared with them.

use float_picture::{Shading, render, single};
use reflet::host::compare::compare;
use reflet::host::reference;
use reflet::scenes;
use xtask::measure::Scene as Source;

#[test]
fn single_precision_agrees_with_double_precision() {
    const SIZE: (u32, u32) = (320, 320);
    let shadings = [Shading::BlinnPhong, Shading::Phong, Shading::Normals];
    for name in scenes::NAMES {
        let (scene, camera) = Source::BuiltIn(name).reference();
        for shading in shadings {
            let expected = reference::render(&scene, &camera, SIZE.0, SIZE.1, 4, shading);
            let port = render(&scene, &camera, SIZE, 4, shading);
            let formulas = single::render(&scene, &camera, SIZE, 4, shading);
            for (what, picture) in [("port", port), ("formulas", formulas)] {
                let difference = compare(&picture, &expected).unwrap();
                println!("{name} {shading:?} {what} {difference:?}");
                assert!(
                    difference.within1 >= 0.999,
                    "{name}, {shading:?}, {what}: {difference:?}"
                );
            }
        }
    }
}
