use std::vec;

use super::*;
use crate::host::reference::{Material, Sphere};

const CAMERA: Camera = Camera {
    position: [0.0; 3],
    target: [0.0, 1.0, 0.0],
    up: [0.0, 0.0, 1.0],
    fov: 50.0,
};

#[test]
fn channels_are_clamped_and_rounded_to_nearest() {
    let step = 1.0 / 255.0;
    assert_eq!(quantised(Vector([-3.0, 0.0, 0.49 * step])), [0, 0, 0]);
    assert_eq!(
        quantised(Vector([0.51 * step, 1.49 * step, 254.51 * step])),
        [1, 1, 255]
    );
    assert_eq!(quantised(Vector([1.0, 1.001, f64::INFINITY])), [255; 3]);
}

#[test]
fn picture_is_its_pixels_row_by_row_from_the_top() {
    let ball = Sphere {
        center: [1.0, 5.0, 0.5],
        radius: 1.5,
        material: 0,
    };
    let matte = Material {
        color: [1.0; 3],
        ambient: 1.0,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1.0,
        mirror: 0.0,
        checker: None,
    };
    let scene = Scene {
        spheres: vec![ball],
        materials: vec![matte],
        ..Scene::default()
    };
    for shading in [Shading::BlinnPhong, Shading::Phong, Shading::Normals] {
        let picture = render(&scene, &CAMERA, 7, 5, 2, shading);
        let places = (0..5).flat_map(|y| (0..7).map(move |x| (x, y)));
        let pixels: Vec<_> = places
            .map(|at| quantised(Vector(pixel(&scene, &CAMERA, (7, 5), at, 2, shading))))
            .collect();
        assert_eq!(picture.pixels, pixels);
    }
    let lit = render(&scene, &CAMERA, 7, 5, 2, Shading::Phong).pixels;
    // The ball is up and to the right of the middle.
    assert_eq!((lit[0], lit[7 + 4], lit[28]), ([0; 3], [255; 3], [0; 3]));
}

#[test]
fn picture_without_pixels_is_empty() {
    for (width, height) in [(0, 0), (0, 3), (3, 0)] {
        let picture = render(&Scene::default(), &CAMERA, width, height, 4, Shading::Phong);
        assert_eq!((picture.width, picture.height), (width, height));
        assert!(picture.pixels.is_empty());
    }
}
