//! Tests that micromath's numbers and vectors are accepted when a camera or a scene is made at run
//! time.
#![cfg(feature = "micromath")]

use embedded_graphics::prelude::Size;
use micromath::F32;
use micromath::vector::F32x3;
use reflet::host::painted;
use reflet::{Camera, Error, ErrorKind, Material, Number, Position, RuntimeScene, room};

fn vector([x, y, z]: [f32; 3]) -> F32x3 {
    F32x3 { x, y, z }
}

#[test]
fn number_is_the_one_of_the_float_it_wraps() {
    for value in [0.0, 1.0, -0.1, 3.25e9, 1e-9, f32::MIN_POSITIVE] {
        assert_eq!(Number::from(F32(value)), Number::from(value), "{value}");
    }
    for value in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        assert_eq!(Number::from(F32(value)), Number::OUT_OF_RANGE, "{value}");
    }
}

#[test]
fn vector_is_the_position_of_its_coordinates() {
    let coordinates = [0.1, -55.742, 1e6];
    let position = Position::from(vector(coordinates));
    assert_eq!(position, Position::from(coordinates));
}

#[test]
fn camera_made_of_them_is_the_camera_made_of_floats() {
    let [position, target, up] = [
        [24.186, -55.742, 26.689],
        [20.357, -47.128, 23.352],
        [-0.136, 0.305, 0.943],
    ];
    let camera = Camera::new(vector(position), vector(target), vector(up), F32(50.5));
    assert_eq!(camera, Camera::new(position, target, up, 50.5_f32));
    assert!(camera.is_ok());
    let turned = camera.unwrap().orbited(F32(35.0), F32(-5.0));
    assert_eq!(turned, camera.unwrap().orbited(35, -5));
    let nowhere = Camera::new(vector(position), vector(position), vector(up), F32(50.5));
    let error = nowhere.unwrap_err();
    assert_eq!((error.part(), error.kind()), ("camera", ErrorKind::View));
}

type Scenery = RuntimeScene<room!(spheres: 1, planes: 1, cylinders: 1, lights: 1, materials: 1)>;

fn filled<N, V>(number: fn(f32) -> N, vector: fn([f32; 3]) -> V) -> Result<Scenery, Error>
where
    N: Into<Number>,
    V: Into<Position>,
{
    let mut scene = Scenery::new();
    let color = [0.9, 0.8, 0.1].map(number);
    let [ambient, diffuse, specular, shininess, mirror] = [0.1, 0.7, 0.3, 9.5, 0.2].map(number);
    let made = Material::from_numbers(color, ambient, diffuse, (specular, shininess), mirror);
    let gold = scene.add_material(made?)?;
    scene.add_sphere(vector([0.1, 0.2, 0.3]), number(0.7), gold)?;
    scene.add_plane(vector([0.0, 0.0, -0.4]), vector([0.1, 0.0, 1.0]), gold)?;
    let [center, axis] = [[1.5, 0.4, 0.5], [0.0, 0.3, 1.0]].map(vector);
    scene.add_cylinder(center, axis, number(0.3), number(1.1), gold)?;
    scene.add_light(vector([3.3, -4.4, 5.5]), [0.9, 0.9, 0.8].map(number))?;
    scene.set_background([0.1, 0.2, 0.4].map(number))?;
    scene.set_epsilon(number(0.002))?;
    Ok(scene)
}

#[test]
fn scene_made_of_them_is_the_scene_made_of_floats() {
    let scenes = [filled(F32, vector), filled(|it| it, |it| it)].map(Result::unwrap);
    let [wrapped, plain] = &scenes;
    let described = scenes
        .each_ref()
        .map(|it| format!("{:?}", it.description()));
    assert_eq!(described[0], described[1]);
    let camera = Camera::look_at([0.0, -6.0, 2.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let painted = |scene: &Scenery| {
        let scene = scene.build().unwrap();
        let frame = scene.frame(&camera).prepare(Size::new(32, 24));
        painted(&frame.on(&scene).unwrap())
    };
    assert!(painted(wrapped) == painted(plain));
}

#[test]
fn what_is_not_finite_is_refused() {
    let mut scene = Scenery::new();
    let id = scene.add_material(Material::new([1.0; 3])).unwrap();
    for (center, radius) in [([0.0, f32::NAN, 0.0], 1.0), ([0.0; 3], f32::INFINITY)] {
        let refused = scene.add_sphere(vector(center), F32(radius), id);
        let error = refused.unwrap_err();
        assert_eq!((error.part(), error.index()), ("sphere", Some(0)));
        assert_eq!(error.kind(), ErrorKind::Coordinate);
    }
}
