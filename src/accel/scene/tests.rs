use crate::scene::Room;
use std::format;

use super::*;
use crate::scene::built::{BUILT, CAMERA, filled};

#[test]
fn compiler_and_program_prepare_the_same_scene() {
    const SCENE: Scene<Room<3, 1, 2, 1, 2>> = BUILT.build();
    assert_eq!(
        format!("{SCENE:?}"),
        format!("{:?}", filled().build().unwrap())
    );
}

#[test]
fn scene_may_have_more_room_than_it_uses() {
    let scene = BUILT.build();
    assert_eq!(BUILT.description().cylinders.len(), 1);
    let parts = scene.parts();
    assert_eq!((parts.spheres.len(), parts.cylinders.len()), (3, 1));
    assert_eq!(scene.camera(), Some(&CAMERA));
}
