//! A camera that moves around its target; it knows no window.

use reflet::host::reference::Camera;

/// One press of an arrow key, in radians.
const STEP: f64 = 5.0 * std::f64::consts::PI / 180.0;

/// Moves the camera `around` steps to the right about its `up`, and `over` steps towards it.
///
/// It keeps its distance from the target and stays at least a step away from looking along `up`.
pub fn orbit(camera: &mut Camera, around: i32, over: i32) {
    let up = scaled(camera.up, 1.0 / length(camera.up));
    let arm = sum(camera.position, scaled(camera.target, -1.0));
    let distance = length(arm);
    // The arm as an angle from `up` and a direction across it.
    let along = dot(arm, up) / distance;
    let across = sum(scaled(arm, 1.0 / distance), scaled(up, -along));
    let across = scaled(across, 1.0 / length(across));
    let side = cross(up, across);

    let lowest = std::f64::consts::PI - STEP;
    let polar = (along.clamp(-1.0, 1.0).acos() - f64::from(over) * STEP).clamp(STEP, lowest);
    let (turn_sine, turn_cosine) = (f64::from(around) * STEP).sin_cos();
    let turned = sum(scaled(across, turn_cosine), scaled(side, turn_sine));
    let direction = sum(scaled(turned, polar.sin()), scaled(up, polar.cos()));
    camera.position = sum(camera.target, scaled(direction, distance));
}

fn sum(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| a[axis] + b[axis])
}

fn scaled(a: [f64; 3], factor: f64) -> [f64; 3] {
    a.map(|coordinate| coordinate * factor)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    let of = |i: usize, j: usize| a[i] * b[j] - a[j] * b[i];
    [of(1, 2), of(2, 0), of(0, 1)]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}
