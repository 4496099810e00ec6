//! Tests of the conversion of descriptions.

use super::*;
use crate::host::reference::{Cylinder, Disc, Plane, Sphere, Triangle};
use crate::scene::{Room, RuntimeScene};

#[test]
fn every_number_of_a_description_arrives_in_its_place() {
    let mut described = RuntimeScene::<Room<1, 1, 1, 1, 2, 1, 2>>::new();
    let gold = material::Material::new([0.1, 0.2, 0.3])
        .ambient(0.4)
        .diffuse(0.5)
        .specular(0.6, 0.7)
        .mirror(0.8);
    let chalk = described.add_material(material::Material::new([0.9; 3]));
    let (chalk, gold) = (chalk.unwrap(), described.add_material(gold).unwrap());
    described.add_sphere([1.1, 1.2, 1.3], 1.4, gold).unwrap();
    described
        .add_plane([2.1, 2.2, 2.3], [2.4, 2.5, 2.6], chalk)
        .unwrap();
    described
        .add_cylinder([3.1, 3.2, 3.3], [3.4, 3.5, 3.6], 3.7, 3.8, gold)
        .unwrap();
    described
        .add_disc([5.1, 5.2, 5.3], [5.4, 5.5, 5.6], 5.7, chalk)
        .unwrap();
    let corners = [[6.1, 6.2, 6.3], [6.4, 6.5, 6.7], [6.8, 6.9, 7.1]];
    let normals = [[7.2, 7.3, 7.4], [7.5, 7.6, 7.7], [7.8, 7.9, 8.1]];
    described.add_triangle(corners, None, gold).unwrap();
    described.add_triangle(corners, normals, chalk).unwrap();
    described
        .add_light([4.1, 4.2, 4.3], [0.4, 0.5, 0.6])
        .unwrap();
    described.set_background([0.7, 0.8, 0.9]).unwrap();
    described.set_epsilon(0.01).unwrap();

    let scene = Scene::from(&described.description());
    let sphere = Sphere {
        center: [1.1, 1.2, 1.3],
        radius: 1.4,
        material: 1,
    };
    let plane = Plane {
        point: [2.1, 2.2, 2.3],
        normal: [2.4, 2.5, 2.6],
        material: 0,
    };
    let cylinder = Cylinder {
        center: [3.1, 3.2, 3.3],
        axis: [3.4, 3.5, 3.6],
        radius: 3.7,
        height: 3.8,
        material: 1,
    };
    let disc = Disc {
        center: [5.1, 5.2, 5.3],
        normal: [5.4, 5.5, 5.6],
        radius: 5.7,
        material: 0,
    };
    let light = Light {
        position: [4.1, 4.2, 4.3],
        color: [0.4, 0.5, 0.6],
        sun: None,
        range: None,
    };
    let gold = Material {
        color: [0.1, 0.2, 0.3],
        ambient: 0.4,
        diffuse: 0.5,
        specular: 0.6,
        shininess: 0.7,
        mirror: 0.8,
        checker: None,
    };
    assert_eq!(scene.spheres, [sphere]);
    assert_eq!(scene.planes, [plane]);
    assert_eq!(scene.cylinders, [cylinder]);
    assert_eq!(scene.discs, [disc]);
    let triangle = |normals, material| Triangle {
        corners,
        normals,
        material,
    };
    assert_eq!(
        scene.triangles,
        [triangle(None, 1), triangle(Some(normals), 0)]
    );
    assert_eq!(scene.lights, [light]);
    assert_eq!(scene.materials[1], gold);
    assert_eq!(scene.materials[0].color, [0.9; 3]);
    assert_eq!(scene.materials.len(), 2);
    assert_eq!((scene.background, scene.epsilon), ([0.7, 0.8, 0.9], 0.01));
}

#[test]
fn camera_arrives_as_it_was_described() {
    let described = camera::Camera::look_at([0.1, 0.2, 0.3], [1.4, 1.5, 1.6], [0.7, 0.8, -0.9]);
    let camera = Camera::from(&described.fov(33.3));
    let expected = Camera {
        position: [0.1, 0.2, 0.3],
        target: [1.4, 1.5, 1.6],
        up: [0.7, 0.8, -0.9],
        fov: 33.3,
    };
    assert_eq!(camera, expected);
}
