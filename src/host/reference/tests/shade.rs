//! Tests of `reference::model::shade`.

use std::vec;

use crate::host::reference::Shading::{self, BlinnPhong, Phong};
use crate::host::reference::model::{Met, Surface, Vector};
use crate::host::reference::prepared::Prepared;
use crate::host::reference::{Light, Material, Plane, Scene};

const EPSILON: f64 = 1e-3;

const MATERIAL: Material = Material {
    color: [0.5, 0.25, 1.0],
    ambient: 0.125,
    diffuse: 0.5,
    specular: 0.25,
    shininess: 3.0,
    mirror: 0.0,
    checker: None,
};

/// Returns the light that a plane z = 0 of [`MATERIAL`] sends to a viewer 30 degrees to the left of its
/// normal.
fn lit_by(lights: &[[f64; 3]], screens: &[f64], epsilon: f64, shading: Shading) -> f64 {
    lit_on(MATERIAL, lights, screens, epsilon, shading)
}

fn lit_on(
    material: Material,
    lights: &[[f64; 3]],
    screens: &[f64],
    epsilon: f64,
    shading: Shading,
) -> f64 {
    let light = |position| Light {
        position,
        color: [1.0, 0.0, 0.5],
        sun: None,
        range: None,
    };
    let plane = |height| Plane {
        point: [0.0, 0.0, height],
        normal: [0.0, 0.0, -1.0],
        material: 0,
    };
    let scene = Scene {
        planes: screens.iter().copied().map(plane).collect(),
        lights: lights.iter().copied().map(light).collect(),
        materials: vec![material],
        epsilon,
        ..Scene::default()
    };
    let prepared = Prepared::new(&scene);
    let scene = prepared.scene();
    let normal = Vector([0.0, 0.0, 1.0]);
    let surface = Surface {
        outside: normal * epsilon,
        normal,
        viewer: Vector([-0.5, 0.0, 0.75_f64.sqrt()]),
        material: &scene.materials[0],
        distance: 1.0,
        shape: Met::Plane(0),
        is_inside: false,
    };
    let Vector([red, green, blue]) = scene.own_color(&surface, shading);
    // The material and the lights have such colours that one number determines all channels.
    assert_eq!(green, 0.25 * 0.125);
    let light = red / 0.5 - 0.125;
    assert!(
        (blue - (0.125 + 0.5 * light)).abs() < 1e-15,
        "{blue} {light}"
    );
    light
}

/// Returns the position of a light at distance 100, at this angle in degrees to the right of the normal.
fn at_angle(degrees: f64) -> [f64; 3] {
    let (sine, cosine) = degrees.to_radians().sin_cos();
    [100.0 * sine, 0.0, 100.0 * cosine]
}

fn assert_near(found: f64, expected: f64) {
    assert!((found - expected).abs() < 1e-12, "{found} {expected}");
}

#[test]
fn both_highlights_peak_where_the_light_is_mirrored() {
    let expected = 0.5 * 30.0_f64.to_radians().cos() + 0.25;
    for shading in [BlinnPhong, Phong] {
        assert_near(lit_by(&[at_angle(30.0)], &[], 1e-15, shading), expected);
    }
}

#[test]
fn phong_falls_by_the_angle_and_blinn_phong_by_half_of_it() {
    let diffuse = 0.5 * 70.0_f64.to_radians().cos();
    let highlight = |degrees: f64| 0.25 * degrees.to_radians().cos().powi(3);
    let lights = [at_angle(70.0)];
    assert_near(
        lit_by(&lights, &[], 1e-15, Phong),
        diffuse + highlight(40.0),
    );
    assert_near(
        lit_by(&lights, &[], 1e-15, BlinnPhong),
        diffuse + highlight(20.0),
    );
}

#[test]
fn highlight_never_takes_light_away() {
    // The light is on the viewer's side, so the mirrored light is 100 degrees from the viewer.
    let diffuse = 0.5 * 70.0_f64.to_radians().cos();
    assert_near(lit_by(&[at_angle(-70.0)], &[], 1e-15, Phong), diffuse);
}

#[test]
fn highlight_without_shininess_is_where_the_mirrored_light_comes_to_the_viewer() {
    let flat = Material {
        shininess: 0.0,
        ..MATERIAL
    };
    let diffuse = 0.5 * 70.0_f64.to_radians().cos();
    let all = diffuse + 0.25;
    // The light is on the viewer's side, so the mirrored light is 100 degrees from the viewer.
    for (degrees, phong, blinn_phong) in
        [(70.0, all, all), (-70.0, diffuse, all), (110.0, 0.0, 0.0)]
    {
        let lights = [at_angle(degrees)];
        assert_near(lit_on(flat, &lights, &[], 1e-15, Phong), phong);
        assert_near(lit_on(flat, &lights, &[], 1e-15, BlinnPhong), blinn_phong);
    }
}

#[test]
fn lights_add_up() {
    let [a, b] = [at_angle(10.0), at_angle(-50.0)];
    let each = lit_by(&[a], &[], EPSILON, Phong) + lit_by(&[b], &[], EPSILON, Phong);
    assert_near(lit_by(&[a, b], &[], EPSILON, Phong), each);
}

#[test]
fn light_behind_the_surface_gives_nothing() {
    assert_eq!(lit_by(&[[3.0, 0.0, -1.0]], &[], EPSILON, Phong), 0.0);
}

#[test]
fn light_is_in_front_only_when_above_epsilon() {
    let lit = |height| lit_by(&[[3.0, 0.0, height]], &[], EPSILON, BlinnPhong);
    assert_eq!(lit(0.0), 0.0);
    assert_eq!(lit(EPSILON * 0.999), 0.0);
    assert_eq!(lit(EPSILON), 0.0);
    assert!(lit(EPSILON * 1.001) > 0.0);
}

#[test]
fn light_exactly_where_shadow_rays_start_gives_nothing() {
    assert_eq!(
        lit_by(&[[0.0, 0.0, EPSILON]], &[], EPSILON, BlinnPhong),
        0.0
    );
}

#[test]
fn light_direction_is_taken_from_above_the_surface() {
    // With epsilon 1, a light at (1, 0, 2) is 45 degrees to the right.
    let diffuse = 0.5 * 0.5_f64.sqrt();
    let highlight = 0.25 * 15.0_f64.to_radians().cos().powi(3);
    assert_near(
        lit_by(&[[1.0, 0.0, 2.0]], &[], 1.0, Phong),
        diffuse + highlight,
    );
}

#[test]
fn screen_blocks_from_epsilon_above_the_surface_to_epsilon_before_the_light() {
    let light = [0.0, 0.0, 5.0];
    let free = lit_by(&[light], &[], EPSILON, Phong);
    assert!(free > 0.0);
    let lit = |screen| lit_by(&[light], &[screen], EPSILON, Phong);
    for passed in [-1.0, 0.0, EPSILON * 0.999, 5.0 - EPSILON * 0.999, 5.0, 6.0] {
        assert_eq!(lit(passed), free, "{passed}");
    }
    for blocking in [EPSILON * 1.001, 2.5, 5.0 - EPSILON * 1.001] {
        assert_eq!(lit(blocking), 0.0, "{blocking}");
    }
}
