use crate::scene::Room;
use std::format;

use super::*;
use crate::scene::RuntimeScene;

const RED: Material = Material::new([1.0, 0.1, 0.0]).mirror(0.25);
const BLUE: Material = Material::new([0.0, 0.1, 1.0]).specular(0.5, 7.5);
pub(crate) const CAMERA: Camera =
    Camera::look_at([0.0, -9.0, 1.5], [0.0; 3], [0.0, 0.0, 1.0]).fov(33.0);

pub(crate) const BUILT: SceneBuilder<Room<3, 1, 1, 1, 2>> = SceneBuilder::new()
    .sphere([0.0, 0.1, 0.2], 1.5, RED)
    .sphere([3.0, 0.1, 0.2], 0.5, BLUE)
    .sphere([-3.0, 0.1, 0.2], 0.7, RED)
    .plane([0.0, 0.0, -1.5], [0.0, 0.1, 2.0], BLUE)
    .cylinder([1.0, 2.0, 3.0], [3.0, 2.0, 1.0], 0.25, 4.0, RED)
    .light([4.0, -5.0, 60.0], [0.9, 0.8, 0.7])
    .background([0.1, 0.2, 0.3])
    .epsilon(0.002)
    .camera(CAMERA);

pub(crate) fn filled() -> RuntimeScene<Room<3, 1, 1, 1, 2>> {
    let mut scene = RuntimeScene::new();
    let red = scene.add_material(RED).unwrap();
    let blue = scene.add_material(BLUE).unwrap();
    scene.add_sphere([0.0, 0.1, 0.2], 1.5, red).unwrap();
    scene.add_sphere([3.0, 0.1, 0.2], 0.5, blue).unwrap();
    scene.add_sphere([-3.0, 0.1, 0.2], 0.7, red).unwrap();
    scene
        .add_plane([0.0, 0.0, -1.5], [0.0, 0.1, 2.0], blue)
        .unwrap();
    let axis = [3.0, 2.0, 1.0];
    scene
        .add_cylinder([1.0, 2.0, 3.0], axis, 0.25, 4.0, red)
        .unwrap();
    scene.add_light([4.0, -5.0, 60.0], [0.9, 0.8, 0.7]).unwrap();
    scene.set_background([0.1, 0.2, 0.3]).unwrap();
    scene.set_epsilon(0.002).unwrap();
    scene.set_camera(CAMERA);
    scene
}

#[test]
fn both_ways_describe_the_same_scene() {
    let filled = filled();
    assert_eq!(
        format!("{:?}", BUILT.description()),
        format!("{:?}", filled.description())
    );
}

#[test]
fn material_used_twice_is_kept_once() {
    let description = BUILT.description();
    assert_eq!(description.materials, [RED, BLUE]);
    let named = description
        .spheres
        .iter()
        .map(|sphere| sphere.material.index());
    assert!(named.eq([0, 1, 0]));
}

#[test]
fn new_scene_is_empty_and_black() {
    let builder = SceneBuilder::<Room<1, 1, 1, 1>>::default();
    let description = builder.description();
    assert!(description.spheres.is_empty() && description.planes.is_empty());
    assert!(description.cylinders.is_empty() && description.lights.is_empty());
    assert!(description.materials.is_empty());
    assert_eq!(description.background, [Number::ZERO; 3]);
    assert_eq!(description.epsilon, Number::new(0.001));
    assert_eq!(description.camera, None);
}
