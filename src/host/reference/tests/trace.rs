//! Tests of `reference::trace`.

use std::vec;

use crate::host::reference::bound::{Paths, Precision};
use crate::host::reference::model::{Ray, Vector};
use crate::host::reference::prepared::Prepared;
use crate::host::reference::trace::*;
use crate::host::reference::{Camera, Light, Material, Plane, Scene, Shading, Sphere, pixel};
use crate::number::sweep::Sweep;

const SHADINGS: [Shading; 2] = [Shading::BlinnPhong, Shading::Phong];

fn glowing(color: [f64; 3], mirror: f64) -> Material {
    Material {
        color,
        ambient: 1.0,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1.0,
        mirror,
        checker: None,
    }
}

fn plane(height: f64, material: usize) -> Plane {
    Plane {
        point: [0.0, 0.0, height],
        normal: [0.0, 0.0, 1.0],
        material,
    }
}

/// Returns a room inside a sphere that has ambient light and mirrors by `mirror`.
fn room(mirror: f64) -> Scene {
    Scene {
        spheres: vec![Sphere {
            center: [1.0, 2.0, 3.0],
            radius: 4.0,
            material: 0,
        }],
        materials: vec![glowing([0.75, 0.5, 2.0], mirror)],
        ..Scene::default()
    }
}

fn seen(scene: &Scene, ray: Ray, reflections: u32, shading: Shading) -> Vector {
    color(&Prepared::new(scene).scene(), ray, reflections, shading)
}

/// Returns a ray that starts at this height on the z axis and goes straight down.
fn down(height: f64) -> Ray {
    Ray {
        origin: Vector([0.0, 0.0, height]),
        direction: Vector([0.0, 0.0, -1.0]),
    }
}

fn assert_near(found: Vector, expected: Vector) {
    assert!(
        (found - expected).length() < 1e-12,
        "{found:?} {expected:?}"
    );
}

#[test]
fn closed_room_of_mirrors_shows_its_colour_but_for_what_is_cut_off() {
    let ray = Ray {
        origin: Vector([2.0, 1.0, 2.5]),
        direction: Vector([0.3, -0.4, 0.9]).unit(),
    };
    for mirror in [0.0, 0.25, 0.5, 0.9, 0.999, 1.0] {
        for reflections in [0, 1, 2, 7, 255] {
            let cut_off = f64::powi(mirror, reflections as i32 + 1);
            let expected = Vector([0.75, 0.5, 2.0]) * (1.0 - cut_off);
            for shading in SHADINGS {
                assert_near(seen(&room(mirror), ray, reflections, shading), expected);
            }
        }
    }
}

#[test]
fn hundred_thousand_reflections_need_no_stack() {
    let ray = down(3.0);
    assert_eq!(seen(&room(1.0), ray, 100_000, Shading::Phong), Vector::ZERO);
    let found = seen(&room(0.99999), ray, 100_000, Shading::Phong);
    let cut_off = (0.99999_f64.ln() * 100_001.0).exp();
    assert!((found - Vector([0.75, 0.5, 2.0]) * (1.0 - cut_off)).length() < 1e-9);
}

#[test]
fn ray_stops_at_the_first_surface_that_mirrors_nothing() {
    // A path of 2³² - 1 reflections would not end in time.
    let expected = Vector([0.75, 0.5, 2.0]);
    assert_eq!(
        seen(&room(0.0), down(3.0), u32::MAX, Shading::Phong),
        expected
    );
}

#[test]
fn miss_ends_the_recurrence_with_the_background() {
    let scene = Scene {
        planes: vec![plane(0.0, 0)],
        materials: vec![glowing([1.0, 0.0, 0.0], 0.25)],
        background: [0.0, 0.5, 1.0],
        ..Scene::default()
    };
    for shading in SHADINGS {
        let up = Ray {
            direction: Vector([0.0, 0.0, 1.0]),
            ..down(1.0)
        };
        assert_eq!(seen(&scene, up, 0, shading), Vector([0.0, 0.5, 1.0]));
        assert_eq!(
            seen(&scene, down(1.0), 0, shading),
            Vector([0.75, 0.0, 0.0])
        );
        for reflections in [1, 2, 255] {
            let expected = Vector([0.75, 0.125, 0.25]);
            assert_eq!(seen(&scene, down(1.0), reflections, shading), expected);
        }
    }
}

#[test]
fn two_parallel_mirrors_alternate() {
    let (red, blue) = (Vector([1.0, 0.0, 0.0]), Vector([0.0, 0.0, 1.0]));
    let scene = Scene {
        planes: vec![plane(0.0, 0), plane(2.0, 1)],
        materials: vec![glowing(red.0, 0.5), glowing(blue.0, 0.25)],
        ..Scene::default()
    };
    let weights = [0.5, 0.5 * 0.75, 0.125 * 0.5, 0.0625 * 0.75, 0.015625 * 0.5];
    let mut expected = Vector::ZERO;
    for (reflections, weight) in weights.into_iter().enumerate() {
        expected += if reflections % 2 == 0 { red } else { blue } * weight;
        assert_eq!(
            seen(&scene, down(1.0), reflections as u32, Shading::Phong),
            expected
        );
    }
}

/// A vertical ray hits two mirrors in turn. `trace` evaluates the recursion from the path's end, `bound`
/// adds colours from its start with a running weight.
#[test]
fn recursion_and_running_weight_agree_between_two_mirrors() {
    let camera = Camera {
        position: [0.0, 0.0, 1.0],
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov: 50.0,
    };
    let precision = Precision {
        step: 1e-9,
        middle: [0.0; 3],
        dimness: 1.0,
    };
    let mut sweep = Sweep::new(5);
    for _ in 0..50 {
        let mut share = || f64::from(sweep.within(0, i32::MAX)) / f64::from(i32::MAX);
        let mut mirror = || glowing([share(), share(), 16.0 * share()], share().sqrt().sqrt());
        let scene = Scene {
            planes: vec![plane(0.0, 0), plane(2.0, 1)],
            materials: vec![mirror(), mirror()],
            ..Scene::default()
        };
        let all = 300;
        let shading = Shading::Phong;
        let paths = Paths::follow(&scene, &camera, (1, 1), all, shading, &precision);
        let recursive = |reflections| {
            let color = pixel(&scene, &camera, (1, 1), (0, 0), reflections, shading);
            Vector(color)
        };
        for reflections in [0, 1, 2, 5, 40, 299] {
            let stage = paths.path(0, 0).ended(reflections, 0.0);
            let sum = Vector(stage.color);
            assert!((sum - recursive(reflections as u32)).length() < 1e-9);
            // The remainder is the colour along the next ray: up after the floor, down after the
            // ceiling.
            let next = match reflections % 2 {
                0 => Ray {
                    direction: Vector([0.0, 0.0, 1.0]),
                    ..down(1.0)
                },
                _ => down(1.0),
            };
            let rest = seen(&scene, next, (all - reflections - 1) as u32, shading);
            let whole = sum + rest * stage.weight;
            assert!((whole - recursive(all as u32)).length() < 1e-9);
        }
    }
}

#[test]
fn reflected_ray_starts_epsilon_above_its_surface() {
    let scene = |epsilon| Scene {
        planes: vec![plane(0.0, 0), plane(0.75, 1)],
        materials: vec![glowing([0.0; 3], 1.0), glowing([1.0; 3], 0.0)],
        epsilon,
        ..Scene::default()
    };
    let found = |epsilon| seen(&scene(epsilon), down(0.5), 1, Shading::Phong);
    assert_eq!(found(0.749), Vector::grey(1.0));
    assert_eq!(found(0.751), Vector::ZERO);
}

#[test]
fn mirrors_show_shaded_surfaces_lit_from_their_own_side() {
    // The mirror below shows the ceiling, lit by the lamp between the two. The ceiling's diffuse light
    // is 0.5 straight above the lamp, and the mirror has no colour of its own.
    let ceiling = Material {
        ambient: 0.0,
        diffuse: 0.5,
        ..glowing([1.0; 3], 0.0)
    };
    let scene = Scene {
        planes: vec![plane(0.0, 0), plane(8.0, 1)],
        lights: vec![Light {
            position: [0.0, 0.0, 4.0],
            color: [1.0, 0.5, 0.25],
            sun: None,
            range: None,
        }],
        materials: vec![glowing([0.0; 3], 0.5), ceiling],
        ..Scene::default()
    };
    for shading in SHADINGS {
        let expected = Vector([0.25, 0.125, 0.0625]);
        assert_eq!(seen(&scene, down(2.0), 1, shading), expected);
    }
}

#[test]
fn normals_view_shows_the_side_that_faces_the_ray_and_blue_beside_it() {
    let scene = room(1.0);
    let ray = |origin, direction| Ray {
        origin: Vector(origin),
        direction: Vector(direction),
    };
    let normals = |ray| seen(&scene, ray, 4, Shading::Normals);
    let inside = ray([1.0, 2.0, 3.0], [0.0, 0.6, 0.8]);
    assert_near(normals(inside), Vector([0.5, 0.2, 0.1]));
    let outside = ray([9.0, 2.0, 3.0], [-1.0, 0.0, 0.0]);
    assert_near(normals(outside), Vector([1.0, 0.5, 0.5]));
    let beside = ray([9.0, 2.0, 3.0], [1.0, 0.0, 0.0]);
    assert_eq!(normals(beside), Vector([0.0, 0.0, 1.0]));
}
