use crate::material::Material;
use crate::scene::{Room, RuntimeScene};

#[test]
fn stamp_tells_scenes_apart() {
    let stamp = |x: f64, shade: f64| {
        let mut scene = RuntimeScene::<Room<1, 0, 0, 0>>::new();
        let chalk = scene.add_material(Material::new([shade; 3])).unwrap();
        scene.add_sphere([x, 0.0, 0.0], 1, chalk).unwrap();
        scene.build().unwrap().stamp
    };
    assert_eq!(stamp(0.5, 0.5), stamp(0.5, 0.5));
    assert_ne!(stamp(0.5, 0.5), stamp(0.25, 0.5));
    assert_ne!(stamp(0.5, 0.5), stamp(0.5, 0.25));
}
