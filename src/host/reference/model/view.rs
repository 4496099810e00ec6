//! From a pixel to the ray through its centre; it knows no scene.

use super::{Ray, Real, Vector, tangent};

/// Where a picture is taken from.
#[derive(Clone, Copy, Debug)]
pub struct Camera {
    /// Where it stands.
    pub position: Vector,
    /// What it looks at: the middle of the picture.
    pub target: Vector,
    /// What is up; only its direction across the view matters.
    pub up: Vector,
    /// Full horizontal field of view in degrees.
    pub fov: Real,
}

/// A camera made ready for pictures of one size.
#[derive(Clone, Copy, Debug)]
pub struct View {
    position: Vector,
    forward: Vector,
    /// From the middle of the picture to its right edge, at distance one.
    right: Vector,
    /// From the middle of the picture to its upper edge, at distance one.
    up: Vector,
    /// The middle of the picture, in pixels from its top left corner.
    middle: [Real; 2],
}

impl View {
    /// Makes a camera ready for pictures of this width and height.
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

    /// The ray through the centre of a pixel; row 0 is on top.
    #[inline]
    pub fn ray(&self, x: u32, y: u32) -> Ray {
        self.ray_through(x as Real + 0.5, y as Real + 0.5)
    }

    /// The ray through a point of the picture, in pixels from its top left corner.
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

    /// How far apart the directions of neighbouring pixels are at most, in radians.
    pub fn pixel_angle(&self) -> Real {
        self.right.length() / self.middle[0]
    }
}
