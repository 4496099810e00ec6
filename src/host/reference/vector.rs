//! Three numbers that add and scale: points, directions and linear colours; it knows no shape.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

use super::Real;

/// A point, a direction or a linear colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Vector(pub [Real; 3]);

impl Vector {
    pub const ZERO: Self = Self([0.0; 3]);

    /// What is described by three doubles.
    pub fn of(numbers: [f64; 3]) -> Self {
        Self(numbers.map(|number| number as Real))
    }

    /// The grey with this value in all components.
    pub fn grey(value: Real) -> Self {
        Self([value; 3])
    }

    pub fn dot(self, other: Self) -> Real {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub fn length(self) -> Real {
        self.dot(self).sqrt()
    }

    /// The same direction with length one; not a number for the zero vector.
    pub fn unit(self) -> Self {
        self * (1.0 / self.length())
    }

    /// Component by component, as light is filtered by a colour.
    pub fn filtered(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a * x, b * y, c * z])
    }

    /// The part at right angles to the unit vector `axis`.
    pub fn across(self, axis: Self) -> Self {
        self - axis * self.dot(axis)
    }
}

impl Add for Vector {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a + x, b + y, c + z])
    }
}

impl AddAssign for Vector {
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl Sub for Vector {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([a - x, b - y, c - z])
    }
}

impl Mul<Real> for Vector {
    type Output = Self;

    fn mul(self, factor: Real) -> Self {
        Self(self.0.map(|component| component * factor))
    }
}

impl Neg for Vector {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|component| -component))
    }
}

/// A linear colour as bytes: each channel clamped to 0 to 1, and round(255 c).
pub(super) fn quantised(color: Vector) -> [u8; 3] {
    color
        .0
        .map(|channel| (255.0 * channel.clamp(0.0, 1.0)).round() as u8)
}
