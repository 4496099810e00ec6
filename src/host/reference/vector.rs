//! Three doubles that add and scale: points, directions and linear colours; it knows no shape.

use std::ops::{Add, AddAssign, Mul, Neg, Sub};

/// A point, a direction or a linear colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Vector(pub [f64; 3]);

impl Vector {
    pub const ZERO: Self = Self([0.0; 3]);

    /// The grey with this value in all components.
    pub fn grey(value: f64) -> Self {
        Self([value; 3])
    }

    pub fn dot(self, other: Self) -> f64 {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        a * x + b * y + c * z
    }

    pub fn cross(self, other: Self) -> Self {
        let ([a, b, c], [x, y, z]) = (self.0, other.0);
        Self([b * z - c * y, c * x - a * z, a * y - b * x])
    }

    pub fn length(self) -> f64 {
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

impl Mul<f64> for Vector {
    type Output = Self;

    fn mul(self, factor: f64) -> Self {
        Self(self.0.map(|component| component * factor))
    }
}

impl Neg for Vector {
    type Output = Self;

    fn neg(self) -> Self {
        Self(self.0.map(|component| -component))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cross_product_is_right_handed() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vector);
        assert_eq!([x.cross(y), y.cross(z), z.cross(x)], [z, x, y]);
    }

    #[test]
    fn unit_of_a_pythagorean_box_is_exact_to_an_ulp() {
        let Vector(unit) = Vector([2.0, -3.0, 6.0]).unit();
        for (component, exact) in unit.into_iter().zip([2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0]) {
            assert!((component - exact).abs() <= f64::EPSILON, "{unit:?}");
        }
    }

    #[test]
    fn across_drops_the_part_along_the_axis() {
        let axis = Vector([0.0, 1.0, 0.0]);
        assert_eq!(
            Vector([3.0, 5.0, -2.0]).across(axis),
            Vector([3.0, 0.0, -2.0])
        );
    }
}
