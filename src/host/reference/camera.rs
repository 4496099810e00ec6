//! From a pixel to the ray through its centre; it knows no scene.

use super::shape::Ray;
use super::vector::Vector;

/// Where a picture is taken from, in plain doubles.
///
/// Nothing is checked: `target` differs from `position`, `up` is not along the view, and `fov` is
/// between 0 and 180.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// Where it stands.
    pub position: [f64; 3],
    /// What it looks at: the middle of the picture.
    pub target: [f64; 3],
    /// What is up; only its direction across the view matters.
    pub up: [f64; 3],
    /// Full horizontal field of view in degrees.
    pub fov: f64,
}

impl View {
    /// How far apart the directions of neighbouring pixels are at most, in radians.
    pub fn pixel_angle(&self) -> f64 {
        2.0 * self.right.length() / self.width
    }
}

/// A camera made ready for pictures of one size.
pub(super) struct View {
    position: Vector,
    forward: Vector,
    /// From the middle of the picture to its right edge, at distance one.
    right: Vector,
    /// From the middle of the picture to its upper edge, at distance one.
    up: Vector,
    width: f64,
    height: f64,
}

impl View {
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let (width, height) = (f64::from(width), f64::from(height));
        let position = Vector(camera.position);
        let forward = (Vector(camera.target) - position).unit();
        let right = forward.cross(Vector(camera.up)).unit();
        let up = right.cross(forward);
        let half_width = (camera.fov / 2.0).to_radians().tan();
        Self {
            position,
            forward,
            right: right * half_width,
            up: up * (half_width * height / width),
            width,
            height,
        }
    }

    /// The ray through the centre of a pixel; row 0 is on top.
    pub fn ray(&self, x: u32, y: u32) -> Ray {
        self.ray_through(f64::from(x) + 0.5, f64::from(y) + 0.5)
    }

    /// The ray through a point of the picture, in pixels from its top left corner.
    pub fn ray_through(&self, x: f64, y: f64) -> Ray {
        let across = 2.0 * x / self.width - 1.0;
        let above = 1.0 - 2.0 * y / self.height;
        let direction = self.forward + self.right * across + self.up * above;
        Ray {
            origin: self.position,
            direction: direction.unit(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn direction(fov: f64, size: (u32, u32), at: (u32, u32)) -> Vector {
        let camera = Camera {
            position: [1.0, 2.0, 3.0],
            target: [1.0, 7.0, 3.0],
            up: [0.0, 4.0, 9.0],
            fov,
        };
        let ray = View::new(&camera, size.0, size.1).ray(at.0, at.1);
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
}
