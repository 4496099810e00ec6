//! Tests of `reference::model::scene`.

use std::vec;

use crate::host::reference::model::{self, Met, Ray, Surface, Vector};
use crate::host::reference::prepared::Prepared;
use crate::host::reference::{Cylinder, Material, Plane, Scene, Sphere};

fn material(mirror: f64) -> Material {
    Material {
        color: [1.0; 3],
        ambient: 1.0,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1.0,
        mirror,
        checker: None,
    }
}

/// Returns a scene with shapes along the y axis: a sphere from 4 to 6, a plane at 9, and the walls of a
/// tube at 12 and 14. Each shape has another α, by which tests know it.
fn row() -> Scene {
    Scene {
        spheres: vec![Sphere {
            center: [0.0, 5.0, 0.0],
            radius: 1.0,
            material: 0,
        }],
        planes: vec![Plane {
            point: [3.0, 9.0, 1.0],
            normal: [0.0, 0.5, 0.0],
            material: 1,
        }],
        cylinders: vec![Cylinder {
            center: [0.0, 13.0, 0.0],
            axis: [0.0, 0.0, 1.0],
            radius: 1.0,
            height: 1.0,
            material: 2,
        }],
        materials: vec![material(0.0), material(0.1), material(0.2)],
        epsilon: 0.25,
        ..Scene::default()
    }
}

fn along_y(from: f64, way: f64) -> Ray {
    Ray {
        origin: Vector([0.0, from, 0.0]),
        direction: Vector([0.0, way, 0.0]),
    }
}

#[test]
fn nearest_surface_ahead_is_met_and_faces_the_ray() {
    let prepared = Prepared::new(&row());
    let scene = prepared.scene();
    let cases = [
        (0.0, 1.0, 4.0, 0.0),
        (5.0, 1.0, 6.0, 0.0),
        (7.0, -1.0, 6.0, 0.0),
        (7.0, 1.0, 9.0, 0.1),
        (11.0, -1.0, 9.0, 0.1),
        (11.0, 1.0, 12.0, 0.2),
        (13.0, 1.0, 14.0, 0.2),
        (15.0, -1.0, 14.0, 0.2),
    ];
    for (from, way, expected, mirror) in cases {
        let surface = scene.nearest(&along_y(from, way)).unwrap();
        let back = Vector([0.0, -way, 0.0]);
        assert_eq!(surface.material.mirror, mirror);
        assert_eq!((surface.normal, surface.viewer), (back, back));
        assert_eq!(surface.outside, Vector([0.0, expected - way * 0.25, 0.0]));
    }
    assert!(scene.nearest(&along_y(0.0, -1.0)).is_none());
    assert!(scene.nearest(&along_y(15.0, 1.0)).is_none());
}

#[test]
fn only_what_is_nearer_than_the_reach_blocks() {
    let prepared = Prepared::new(&row());
    let scene = prepared.scene();
    let ray = along_y(0.0, 1.0);
    assert!(!scene.is_blocked(&ray, 4.0));
    assert!(scene.is_blocked(&ray, 4.0 + 1e-12));
    assert!(!scene.is_blocked(&along_y(15.0, 1.0), f64::INFINITY));
}

#[test]
fn reflected_ray_leaves_as_steeply_as_the_ray_came() {
    let ground = model::Material {
        color: Vector::grey(1.0),
        ambient: 1.0,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1.0,
        mirror: 1.0,
        checker: None,
    };
    let surface = Surface {
        outside: Vector([1.0, 2.0, 3.0]),
        normal: Vector([0.0, 0.0, 1.0]),
        viewer: Vector([-0.6, 0.0, 0.8]),
        material: &ground,
        distance: 1.0,
        shape: Met::Plane(0),
        is_inside: false,
    };
    let Ray { origin, direction } = surface.reflected();
    assert_eq!(origin, surface.outside);
    assert!(
        (direction - Vector([0.6, 0.0, 0.8])).length() < 1e-15,
        "{direction:?}"
    );
}

#[test]
#[should_panic = "no material 3"]
fn shape_without_its_material_is_refused() {
    let mut scene = row();
    scene.cylinders[0].material = 3;
    Prepared::new(&scene);
}
