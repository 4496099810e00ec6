//! From a pixel to the ray through its middle.

use crate::float::tangent;
use crate::shape::Ray;
use crate::vector::Vector;

/// Where a picture is taken from.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// Where it stands.
    pub position: Vector,
    /// What it looks at.
    pub target: Vector,
    /// What is up.
    pub up: Vector,
    /// Full horizontal field of view in degrees.
    pub fov: f32,
}

/// A camera made ready for one size.
pub struct View {
    position: Vector,
    /// To the middle of the top left pixel.
    first: Vector,
    /// From a pixel to the next on its right.
    right: Vector,
    /// From a pixel to the next below.
    down: Vector,
}

impl View {
    /// Makes a camera ready for pictures of this width and height.
    pub fn new(camera: &Camera, (width, height): (u32, u32)) -> Self {
        let (width, height) = (width as f32, height as f32);
        let forward = (camera.target - camera.position).unit();
        let right = forward.cross(camera.up).unit();
        let up = right.cross(forward);
        let pixel = 2.0 * tangent(camera.fov * (core::f32::consts::PI / 360.0)) / width;
        let (right, down) = (right * pixel, up * -pixel);
        let corner = right * (0.5 - width / 2.0) + down * (0.5 - height / 2.0);
        Self {
            position: camera.position,
            first: forward + corner,
            right,
            down,
        }
    }

    /// The ray through the middle of a pixel; row 0 is on top.
    #[inline]
    pub fn ray(&self, x: u32, y: u32) -> Ray {
        let direction = self.first + self.right * x as f32 + self.down * y as f32;
        Ray {
            origin: self.position,
            direction: direction.unit(),
        }
    }
}
