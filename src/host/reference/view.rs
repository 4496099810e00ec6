//! From a pixel to the ray through its centre; it knows no scene.

use super::shape::Ray;
use super::vector::Vector;
use super::{Camera, Real};

/// A camera made ready for pictures of one size.
pub(super) struct View {
    position: Vector,
    forward: Vector,
    /// From the middle of the picture to its right edge, at distance one.
    right: Vector,
    /// From the middle of the picture to its upper edge, at distance one.
    up: Vector,
    width: Real,
    height: Real,
}

impl View {
    pub fn new(camera: &Camera, width: u32, height: u32) -> Self {
        let (width, height) = (width as Real, height as Real);
        let position = Vector::of(camera.position);
        let forward = (Vector::of(camera.target) - position).unit();
        let right = forward.cross(Vector::of(camera.up)).unit();
        let up = right.cross(forward);
        let half_width = (camera.fov as Real / 2.0).to_radians().tan();
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
        self.ray_through(x as Real + 0.5, y as Real + 0.5)
    }

    /// The ray through a point of the picture, in pixels from its top left corner.
    pub fn ray_through(&self, x: Real, y: Real) -> Ray {
        let across = 2.0 * x / self.width - 1.0;
        let above = 1.0 - 2.0 * y / self.height;
        let direction = self.forward + self.right * across + self.up * above;
        Ray {
            origin: self.position,
            direction: direction.unit(),
        }
    }

    /// How far apart the directions of neighbouring pixels are at most, in radians.
    pub fn pixel_angle(&self) -> Real {
        2.0 * self.right.length() / self.width
    }
}
