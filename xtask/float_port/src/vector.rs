//! Three numbers: a point, a direction or a colour.

use core::ops::{Add, Mul, Sub};

use crate::float::square_root;

/// Three numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vector {
    /// East, or red.
    pub x: f32,
    /// North, or green.
    pub y: f32,
    /// Up, or blue.
    pub z: f32,
}

impl Vector {
    /// Nothing.
    pub const ZERO: Self = Self::new(0.0, 0.0, 0.0);

    /// From its numbers.
    pub const fn new(x: f32, y: f32, z: f32) -> Self {
        Self { x, y, z }
    }

    /// The scalar product.
    #[inline]
    pub fn dot(self, other: Self) -> f32 {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// The vector product.
    #[inline]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// The length.
    #[inline]
    pub fn length(self) -> f32 {
        square_root(self.dot(self))
    }

    /// The same direction, of length one.
    #[inline]
    pub fn unit(self) -> Self {
        self * (1.0 / self.length())
    }

    /// Each number times its counterpart.
    #[inline]
    pub fn filtered(self, other: Self) -> Self {
        Self::new(self.x * other.x, self.y * other.y, self.z * other.z)
    }

    /// Mirrored in a surface with this normal.
    #[inline]
    pub fn mirrored(self, normal: Self) -> Self {
        self - normal * (2.0 * self.dot(normal))
    }
}

impl Add for Vector {
    type Output = Self;

    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl Sub for Vector {
    type Output = Self;

    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl Mul<f32> for Vector {
    type Output = Self;

    #[inline]
    fn mul(self, factor: f32) -> Self {
        Self::new(self.x * factor, self.y * factor, self.z * factor)
    }
}
