//! The float port is what the library is compared with: its pictures are right.

#[path = "../../examples/shared/float.rs"]
mod float;

use float::port;
use float_port::Shading;
use reflet::{
    host::{compare::compare, reference},
    scenes,
};
use xtask::measure::scene::Scene as Source;

#[test]
fn float_port_agrees_with_double_precision() {
    const SIZE: (u32, u32) = (320, 320);
    let shadings = [
        (Shading::BlinnPhong, reference::Shading::BlinnPhong),
        (Shading::Phong, reference::Shading::Phong),
        (Shading::Normals, reference::Shading::Normals),
    ];
    for name in scenes::NAMES {
        let (scene, camera) = Source::BuiltIn(name).reference();
        for (shading, exact) in shadings {
            let expected = reference::render(&scene, &camera, SIZE.0, SIZE.1, 4, exact);
            let difference =
                compare(&port(&scene, &camera, SIZE, (shading, 4)), &expected).unwrap();
            println!("{name} {shading:?} {difference:?}");
            assert!(
                difference.within1 >= 0.999,
                "{name}, {shading:?}: {difference:?}"
            );
        }
    }
}
