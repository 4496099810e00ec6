//! Tests of `reference::model::view`.

use crate::host::reference::Camera;
use crate::host::reference::model::{Vector, View};
use crate::host::reference::prepared;

fn direction(fov: f64, size: (u32, u32), at: (u32, u32)) -> Vector {
    let camera = Camera {
        position: [1.0, 2.0, 3.0],
        target: [1.0, 7.0, 3.0],
        up: [0.0, 4.0, 9.0],
        fov,
    };
    let ray = View::new(&prepared::camera(&camera), size).ray(at.0, at.1);
    assert_eq!(ray.origin, Vector(camera.position));
    ray.direction
}

fn assert_near(found: Vector, expected: Vector) {
    assert!(
        (found - expected).length() < 1e-15,
        "{found:?} {expected:?}"
    );
}

#[test]
fn only_pixel_looks_straight_ahead() {
    assert_near(direction(50.0, (1, 1), (0, 0)), Vector([0.0, 1.0, 0.0]));
}

#[test]
fn rays_go_through_pixel_centres_and_row_0_is_on_top() {
    let corners = [
        ((0, 0), [-0.75, 1.0, 0.25]),
        ((3, 0), [0.75, 1.0, 0.25]),
        ((0, 1), [-0.75, 1.0, -0.25]),
        ((3, 1), [0.75, 1.0, -0.25]),
    ];
    for (at, expected) in corners {
        assert_near(direction(90.0, (4, 2), at), Vector(expected).unit());
    }
}

#[test]
fn field_of_view_is_the_full_horizontal_angle() {
    let half = 35.0_f64.to_radians();
    let (x, z) = (half.tan() * 2.0 / 3.0, half.tan() * 4.0 / 3.0);
    assert_near(
        direction(70.0, (3, 6), (2, 0)),
        Vector([x, 1.0, z * 1.25]).unit(),
    );
}
