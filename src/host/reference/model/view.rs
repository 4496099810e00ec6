//! The camera of the model: computes the ray through the centre of a pixel. This file knows no scene.

use super::{Ray, Real, Vector, tangent};

/// A camera as described: position, target, up and field of view.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// Position of the camera, in scene units.
    pub position: Vector,
    /// Point that the camera looks at, in scene units. It is in the middle of the picture.
    pub target: Vector,
    /// Direction that is up in the picture. Only its part perpendicular to the view direction matters.
    pub up: Vector,
    /// Full horizontal field of view in degrees.
    pub fov: Real,
}

/// A camera prepared for pictures of one size.
#[derive(Clone, Copy, Debug)]
pub struct View {
    position: Vector,
    forward: Vector,
    /// Vector from the middle of the picture to its right edge, on the image plane at distance one.
    right: Vector,
    /// Vector from the middle of the picture to its upper edge, on the image plane at distance one.
    up: Vector,
    /// Middle of the picture, in pixels from its top left corner.
    middle: [Real; 2],
}

impl View {
    /// Prepares a camera for pictures of this width and height, in pixels.
    pub fn new(camera: &Camera, (width, height): (u32, u32)) -> Self {
        let (width, height) = (width as Real, height as Real);
        let forward = (camera.target - camera.position).unit();
        let right = forward.cross(camera.up).unit();
        let up = right.cross(forward);
        let half_width = tangent((camera.fov / 2.0).to_radians());
        Self {
            position: camera.position,
            forward,
            right: right * half_width,
            up: up * (half_width * height / width),
            middle: [width / 2.0, height / 2.0],
        }
    }

    /// Returns the ray through the centre of the pixel in column `x` and row `y`. Row 0 is on top.
    #[inline]
    pub fn ray(&self, x: u32, y: u32) -> Ray {
        self.ray_through(x as Real + 0.5, y as Real + 0.5)
    }

    /// Returns the ray through a point of the picture, given in pixels from its top left corner.
    #[inline]
    pub fn ray_through(&self, x: Real, y: Real) -> Ray {
        let across = x / self.middle[0] - 1.0;
        let above = 1.0 - y / self.middle[1];
        let direction = self.forward + self.right * across + self.up * above;
        Ray {
            origin: self.position,
            direction: direction.unit(),
        }
    }

    /// Returns the largest angle between the rays of neighbouring pixels, in radians.
    pub fn pixel_angle(&self) -> Real {
        self.right.length() / self.middle[0]
    }
}
