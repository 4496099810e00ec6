//! The camera of the render example's window, which moves around its target.

#[path = "../examples/render/orbit.rs"]
mod orbit;

use orbit::orbit;
use reflet::host::reference::Camera;

const NEAR: f64 = 1e-12;

/// Five units in front of a target that is not the origin.
fn camera() -> Camera {
    Camera {
        position: [1.0, -3.0, 3.0],
        target: [1.0, 2.0, 3.0],
        up: [0.0, 0.0, 2.0],
        fov: 50.0,
    }
}

fn arm(camera: &Camera) -> [f64; 3] {
    [0, 1, 2].map(|axis| camera.position[axis] - camera.target[axis])
}

fn moved(around: i32, over: i32) -> [f64; 3] {
    let mut camera = camera();
    orbit(&mut camera, around, over);
    arm(&camera)
}

fn assert_near(found: [f64; 3], expected: [f64; 3]) {
    let near = found
        .iter()
        .zip(expected)
        .all(|(found, expected)| (found - expected).abs() < NEAR);
    assert!(near, "{found:?} {expected:?}");
}

#[test]
fn quarter_to_the_right_is_on_the_right() {
    assert_near(moved(18, 0), [5.0, 0.0, 0.0]);
    assert_near(moved(-18, 0), [-5.0, 0.0, 0.0]);
}

#[test]
fn step_up_is_five_degrees() {
    let (sine, cosine) = 5.0_f64.to_radians().sin_cos();
    assert_near(moved(0, 1), [0.0, -5.0 * cosine, 5.0 * sine]);
    assert_near(moved(0, -1), [0.0, -5.0 * cosine, -5.0 * sine]);
}

#[test]
fn once_around_comes_back() {
    let mut camera = camera();
    for _ in 0..72 {
        orbit(&mut camera, 1, 0);
    }
    assert_near(arm(&camera), [0.0, -5.0, 0.0]);
}

#[test]
fn camera_never_looks_along_up() {
    let (sine, cosine) = 5.0_f64.to_radians().sin_cos();
    let mut camera = camera();
    for _ in 0..40 {
        orbit(&mut camera, 0, 1);
    }
    assert_near(arm(&camera), [0.0, -5.0 * sine, 5.0 * cosine]);
    for _ in 0..80 {
        orbit(&mut camera, 0, -1);
    }
    assert_near(arm(&camera), [0.0, -5.0 * sine, -5.0 * cosine]);
}
