use crate::scene::Room;
use std::format;

use super::*;
use crate::material::Material;
use crate::scene::built::{BUILT, CAMERA, filled};

#[test]
fn compiler_and_program_prepare_the_same_scene() {
    const SCENE: Scene<Room<3, 1, 1, 1, 2>> = BUILT.build();
    let scene = filled().build().unwrap();
    assert_eq!(format!("{SCENE:?}"), format!("{scene:?}"));
}

#[test]
fn scene_may_have_more_room_than_it_uses() {
    let mut scene = RuntimeScene::<Room<4, 0, 2, 0>>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0, 0, 0], 1, white).unwrap();
    scene.set_camera(CAMERA);
    let scene = scene.build().unwrap();
    let parts = scene.parts();
    assert_eq!((parts.spheres.len(), parts.cylinders.len()), (1, 0));
    assert_eq!(scene.camera(), Some(&CAMERA));
}
